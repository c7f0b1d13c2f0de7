// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/permutation.h"

#include <string>
#include <vector>

namespace FRANKEN_API franken {

/// Why a snippet is part of a program.
struct Reason {
    /// How the words below bring the snippet.
    enum class Kind : std::uint8_t {
        Always, ///< Even the program "surface" has it. There are no words.
        All,    ///< It goes when any one of the words is taken away.
        Enough, ///< The words together bring it, but others of the name would do so as well.
    };

    std::string snippet; ///< "fragment/brdf/ggx", as in LineOrigin.
    Kind kind;
    std::vector<std::string> words; ///< In the order of choices.h.
};

/// The snippets of a canonical permutation's program, in the order of the text (vertex, then fragment), and
/// the words of its name that brought each: what compose.h's line map needs to tell, of every line, where it
/// comes from and why it is there. A word is found to bring a snippet by planning the program without it;
/// where no single word is missed, words are taken away from the last to the first for as long as the snippet
/// stays.
std::vector<Reason> explain(const Permutation& permutation);

/// "normal+sun1" where all are needed, "sun1 or others" where those are enough, "" for what is always there.
std::string toText(const Reason& reason);

} // namespace franken
