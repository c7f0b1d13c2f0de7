// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/compose.h"

#include <string>
#include <utility>

namespace franken::bench {

/// Composes as the program does that this library is named after: a template with marker words, each of
/// which is looked for from the start of the growing string and replaced by a piece of GLSL and itself.
/// Makes the same bytes as compose() of the same snippets, but neither interface nor line map, and it is
/// given the comments at the head: what it saves speaks for it.
class ReplaceComposer {
public:
    explicit ReplaceComposer(const Permutation& permutation);

    /// Vertex and fragment shader.
    std::pair<std::string, std::string> compose() const;

private:
    std::string composeStage(Stage stage, const std::string& head) const;

    Permutation m_permutation;
    std::string m_vertexHead, m_fragmentHead;
};

} // namespace franken::bench
