// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace franken::test {

/// How often the process has called operator new.
std::size_t allocationCount();

} // namespace franken::test
