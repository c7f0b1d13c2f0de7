// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/effect.h"
#include "franken/generator/interface.h"

#include <span>
#include <string>
#include <vector>

namespace franken {

/// A named place in the recipe, and the function that an effect puts there.
struct EffectHook {
    std::string_view name;     ///< Of the section in the effect's text: "light".
    EffectTrait trait;         ///< Its bit.
    std::string_view snippet;  ///< Where it is called: "fragment/effect/light".
    std::string_view type;     ///< What the function returns: "vec3".
    std::string_view function; ///< "onLight"
    std::string_view first;    ///< The parameter that must come first; empty where any may.
};

std::span<const EffectHook> effectHooks();

/// An effect's text, taken apart.
struct Effect::Text {
    struct Declaration {
        std::string text; ///< The line, with its end.
        int line;         ///< In the file, from 1.
        std::string name;
        Type type;
        bool varying; ///< Else a value.
    };
    /// A section: lines of functions, the last of which is called.
    struct Hook {
        const EffectHook* hook;
        std::string text;
        int line; ///< Of its first line.
        std::string call;
    };

    std::string name, word;
    std::uint32_t hash = 0;
    std::uint16_t traits = 0;
    std::string_view file; ///< Outlives all programs.
    std::vector<Declaration> declarations;
    std::vector<std::string> uniforms;
    std::vector<Hook> hooks;
};

} // namespace franken
