// SPDX-License-Identifier: MIT
#pragma once

#include "recipe.h"
#include "snippet.h"

namespace franken {

/// A snippet with its placeholders filled in: what one step of a plan adds to a program.
struct Part {
    struct Section {
        std::string text; ///< Lines, each with its end.
        std::vector<LineOrigin> lines;
    };

    std::string_view name; ///< "fragment/gltf"
    Section declarations, functions, main;
    Interface interface; ///< What the declarations declare; varyings in the vertex stage only.
};

/// All parts are made at the first call, so that composing only copies.
const Part& partOf(const Step& step);

} // namespace franken
