// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/permutation.h"

#include <string>
#include <vector>

namespace FRANKEN_API franken {

/// Why a snippet is part of a program.
struct Reason {
    /// How the words below relate to the snippet.
    enum class Kind : std::uint8_t {
        Always, ///< Even the program "surface" has the snippet. There are no words.
        All,    ///< Removing any one of the words removes the snippet.
        Enough, ///< The words together suffice, but other words of the name would as well.
    };

    std::string snippet; ///< "fragment/brdf/ggx", as in LineOrigin; an effect's file.
    Kind kind;
    std::vector<std::string> words; ///< In the order of choices.h.
};

/// The snippets of a canonical permutation's program, in the order of the text (vertex, then fragment), and
/// the words of its name that require each one. Together with compose.h's line map, this says where every
/// line comes from and why it is there. A word requires a snippet if the program without the word lacks the
/// snippet; if no single word is necessary, words are removed from last to first while the snippet remains,
/// and the rest is reported.
std::vector<Reason> explain(const Permutation& permutation,
                            const SnippetSet& snippets = SnippetSet::builtIn());

/// "normal+sun1" where all words are needed, "sun1 or others" where they suffice, "" for snippets that are
/// always there.
std::string toText(const Reason& reason);

} // namespace franken
