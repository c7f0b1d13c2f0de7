// SPDX-License-Identifier: MIT
#pragma once

#include "franken/gl.h"

namespace franken::test {

/// The table of a driver that does nothing, at once: names are numbers, everything compiles, links and is
/// complete, and limits are those of a desktop.
Gl nullGl();

} // namespace franken::test
