// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace franken::cli {

/// Something that `frankenshader check` found.
struct Finding {
    std::string program; ///< The permutation's name.
    std::string check;   ///< "budget", "lint" or "glslang".
    std::string where;   ///< "generator/glsl/fragment/brdf/ggx.glsl:12", or the profile that is exceeded.
    std::string what;
    std::string remedy; ///< May be empty.
};

} // namespace franken::cli
