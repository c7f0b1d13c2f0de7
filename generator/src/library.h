// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/snippet_set.h"
#include "recipe.h"
#include "snippet.h"

#include <array>
#include <string>

namespace franken {

/// What stands together in a program's declarations, in this order. Uniforms stand in the order of their
/// blocks.
enum class Group : std::uint8_t {
    Precision,
    Attributes,
    Varyings,
    FrameUniforms,
    LightsUniforms,
    MaterialUniforms,
    ObjectUniforms,
    Samplers,
};
inline constexpr std::size_t kGroups = 8;

/// A snippet with its placeholders filled in: what one step of a plan adds to a program.
struct Part {
    struct Section {
        std::string text; ///< Lines, each with its end.
        std::vector<LineOrigin> lines;
    };

    std::array<Section, kGroups> declarations; ///< By group.
    Section functions, main;
    Interface interface; ///< What the declarations declare; varyings in the vertex stage only.
};

/// Made once for a set, so that composing only copies.
struct SnippetSet::Parts {
    std::vector<std::vector<Part>> rows; ///< By row, then by light, then by stream.
    std::string folder;                  ///< Where they came from, as errors name it.
};

const Part& partOf(const SnippetSet& snippets, const Step& step);

/// What a row's snippet is called: "fragment/brdf/ggx".
std::string snippetName(const Row& row);

/// What a row's lines of main are about: the folder of its snippet, "lights" of "lights/sun".
std::string_view concernOf(const Row& row);

/// A declaration's name with its placeholders filled in: "uSun0Direction".
std::string declaredName(const Declaration& declaration, const Step& step);

/// The parts of one row, from its snippet.
std::vector<Part> makeParts(std::uint8_t row, const Snippet& snippet);

} // namespace franken
