// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/permutation.h"
#include "franken/result.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace FRANKEN_API franken {

/// How many vec4 of its own an effect may have.
inline constexpr std::size_t kEffectValues = 4;

/// What an effect asks of the recipe: the hooks that it fills, and the inputs that they read.
enum EffectTrait : std::uint16_t {
    kVertexHook = 1 << 0,
    kBaseColorHook = 1 << 1,
    kSurfaceHook = 1 << 2,
    kLightHook = 1 << 3,
    kLightReadsNormal = 1 << 4,
    kLightReadsToEye = 1 << 5,
    kSurfaceReadsToEye = 1 << 6,
    kSurfaceChangesMetallic = 1 << 7,
    kSurfaceChangesRoughness = 1 << 8,
};

/// GLSL of an application's own, in every surface's program that asks for it: fog, a rim light, a dissolve, a
/// wave. A text for one or several hooks, in sections as a snippet has them (generator/README.md):
///
///     // Fog that thickens with the distance.
///     //! declarations
///     uniform vec4 uFog; // user: linear colour; density, 1/m
///     //! light
///     vec3 onLight(vec3 color, vec3 toEye) {
///       return mix(uFog.rgb, color, exp2(-uFog.w * length(toEye)));
///     }
///
/// | section      | function                                 | runs                                     |
/// |--------------|------------------------------------------|------------------------------------------|
/// | `vertex`     | `vec3 onVertex(vec3 position)`           | before all matrices; model space, m      |
/// | `base-color` | `vec4 onBaseColor(vec4 base)`            | after the base colour; linear RGB, alpha |
/// | `surface`    | `void onSurface(inout vec3 normal, ...)` | before the light, on lit surfaces        |
/// | `light`      | `vec3 onLight(vec3 color, ...)`          | on the sum of light, before the tone map |
///
/// onSurface() takes any of `inout vec3 normal`, `inout float metallic`, `inout float roughness` and `vec3
/// toEye`; onLight() takes `vec3 normal` and `vec3 toEye` after the colour. The normal is unit, and must stay
/// so; toEye leads from the surface to the eye, m, not normalised; both in world space, turned with the sky.
/// Sections may have helpers of their own above that function, and constants. Up to kEffectValues uniforms
/// `uniform vec4 uName; // user: meaning` are the effect's values, in that order; a varying is handed from
/// the vertex hook to the others. An orthographic camera's eye is far away: fog by distance needs a
/// perspective one. With all values 1, or else 0, an effect must draw something, or it is taken for one that
/// the driver cannot draw. What an effect moves in the vertex hook is culled where it was.
///
/// It costs what its text costs, on each pixel (`frankenshader cost --effects FILE NAME`); a normal or
/// metalness per pixel that the program had not got is added. Programs without an effect are not changed.
///
/// An immutable value that is cheap to copy; any thread.
class Effect {
public:
    /// `file` is how errors and line maps call the text. Fails, with file and line in `where`, with
    ///
    ///     effect.name        not a-z, then a-z, 0-9 and '-', at most 32; or a word of names already
    ///     effect.syntax      breaks the form above: a section that is no hook, GLSL outside of sections
    ///     effect.text        a directive (#version), or more than 16 KiB
    ///     effect.uniform     no vec4 with a comment "// user:", more than kEffectValues, or not used
    ///     effect.clash       a name that FrankenShader's snippets have, or GLSL
    ///     effect.function    a section without its function
    ///     effect.signature   the function takes or returns something else
    static Result<Effect> parse(std::string name, std::string_view text, std::string file);

    const std::string& name() const;                  ///< As it was given to parse().
    std::uint32_t hash() const;                       ///< CRC-32 of the text.
    const std::string& word() const;                  ///< In names of permutations: "fog@afb248b9".
    const std::vector<std::string>& uniforms() const; ///< "uFog", in the order of the values.
    /// For a Permutation, where a SnippetSet has the effect in that slot.
    EffectChoice choice(std::uint8_t slot) const;

    /// The generator's own business (src/effect_text.h).
    struct Text;
    const Text& text() const { return *m_text; }

private:
    explicit Effect(std::shared_ptr<const Text> text) : m_text(std::move(text)) {}

    std::shared_ptr<const Text> m_text;
};

} // namespace franken
