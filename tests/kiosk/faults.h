// SPDX-License-Identifier: MIT
#pragma once

namespace franken::test {

/// Whether the file that FRANKEN_FAULTS names has that call in its list now ("write fsync"): for programs
/// that define functions of the system's libraries.
bool isListed(const char* call);

} // namespace franken::test
