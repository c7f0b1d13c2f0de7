// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace franken::cli {

/// Something that `frankenshader check` found, or the gate of `frankenshader cost`.
struct Finding {
    std::string program; ///< The permutation's name.
    std::string check;   ///< "budget", "lint" or "glslang"; "max" or "baseline".
    std::string
        where; ///< "generator/glsl/fragment/brdf/ggx.glsl:12", or the profile that is exceeded, or the GPU.
    std::string what;
    std::string remedy; ///< May be empty.
};

/// As people read it, with a newline.
std::string toLine(const Finding& finding);

} // namespace franken::cli
