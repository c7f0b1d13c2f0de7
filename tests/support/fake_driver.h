// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/permutation.h"
#include "franken/gl.h"

#include <vector>

namespace franken::test {

/// What a driver does with a program that it cannot cope with.
enum class Refusal {
    Compile, ///< Says that the fragment shader does not compile.
    Link,    ///< Says that the program does not link.
    Draw,    ///< Says that all is well, and draws nothing: vc4 without registers.
    Black,   ///< Draws black.
    Nan,     ///< Draws what is no number: fragments that overflow.
};

/// The table of a driver that refuses programs by their fragment shaders' texts, and else does what `gl`
/// does. There is one at a time: calling this makes the table before it mean the same.
Gl refusingDriver(const Gl& gl, Refusal refusal, const std::vector<Permutation>& refused);

/// A driver that refuses all programs.
Gl refusingDriver(const Gl& gl, Refusal refusal);

} // namespace franken::test
