// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/permutation.h"
#include "franken/gl.h"

#include <string_view>

namespace franken {

/// Draws a pixel that says what fragments compute in where a program asks for a precision: "highp" (or
/// mediump where the compiler knows no highp) or "mediump". Fp32 where nothing can be drawn or read. Leaves
/// state changed, but not the framebuffer that is bound and the viewport.
Precision measuredPrecision(const Gl& gl, std::string_view qualifier);

} // namespace franken
