// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"

namespace FRANKEN_API franken {

/// Of the generated texts: raised by a release that writes any permutation's text otherwise than the one
/// before, so that whoever keeps texts knows when to write them anew. `frankenshader diff --against` shows
/// what changed.
inline constexpr unsigned kTextVersion = 1;

} // namespace franken
