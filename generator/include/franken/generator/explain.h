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
/// the words of its name that bring each one in. With compose.h's line map they tell of every line where it
/// comes from and why it is there. A word brings a snippet in if the program without the word lacks the
/// snippet; if no single word is necessary, words are removed from last to first while the snippet remains,
/// and the rest is reported.
std::vector<Reason> explain(const Permutation& permutation);

/// "normal+sun1" where all are needed, "sun1 or others" where those are enough, "" for what is always there.
std::string toText(const Reason& reason);

} // namespace franken
