// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/effect.h"
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
    SkinUniforms,
    UserUniforms,
    Samplers,
};
inline constexpr std::size_t kGroups = 10;

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
    std::vector<std::vector<Part>> rows; ///< By row, then by light or effect's slot, then by stream.
    std::string folder;                  ///< Where they came from, as errors name it.
    std::vector<Effect> effects;         ///< By slot, from 1.
    bool builtIn = false;
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

/// The part of a hook's row as the effect fills it: its functions, what they read of its declarations, and
/// its call. Empty where it does not fill that hook.
Part effectPart(Part hookPart, const Effect& effect, std::string_view snippet);

/// Composes programs with the effect, and lints what is its own. Fails with "effect.glsl".
Result<void> checkEffectText(const SnippetSet& snippets, const EffectChoice& effect);

/// Where the call of an effect goes in the text of a part that no effect has filled.
inline constexpr std::string_view kCall = "${call}";

} // namespace franken
