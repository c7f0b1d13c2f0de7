// SPDX-License-Identifier: MIT
#include "franken/generator/ladder.h"

#include "canonical.h"
#include "franken/generator/texture_role.h"

#include <algorithm>
#include <cassert>

namespace franken {
namespace {

using Change = void (*)(Permutation&);

void keepTwoLightsOfEach(Permutation& p) {
    p.suns = std::min<std::uint8_t>(p.suns, 2);
    p.punctualLights = std::min<std::uint8_t>(p.punctualLights, 2);
}

void keepOneLight(Permutation& p) {
    p.suns = std::min<std::uint8_t>(p.suns, 1);
    p.punctualLights = p.suns > 0 ? 0 : std::min<std::uint8_t>(p.punctualLights, 1);
    p.spots = p.spots && p.punctualLights > 0;
}

void dropRelief(Permutation& p) {
    p.normal = Normal::Vertex;
    p.occlusion = Occlusion::None;
}

void useFactors(Permutation& p) {
    p.metallicRoughness = MetallicRoughness::Factors;
    p.occlusion = Occlusion::None;
    p.emissive = p.emissive == Emissive::Texture ? Emissive::Factor : p.emissive;
}

void dropLight(Permutation& p) {
    p.shading = Shading::Unlit;
    p.toneMap = ToneMap::None;
    p.view = View::Shaded;
}

void useOneColor(Permutation& p) {
    p.baseColorTexture = p.vertexColor = false;
    p.alpha = p.alpha == Alpha::Blend ? Alpha::Blend : Alpha::Opaque;
}

// Whoever draws with a program that moves no vertices moves them on the CPU: the picture stays the same.
void moveVerticesOnTheCpu(Permutation& p) {
    p.influences = 0;
    p.joints = {};
}

constexpr Change kRungs[] = {
    moveVerticesOnTheCpu,
    [](Permutation& p) { p.effect = {}; },
    [](Permutation& p) { p.target = Target::Generic; },
    [](Permutation& p) { p.dither = Dither::None; },
    [](Permutation& p) { p.energy = false; },
    keepTwoLightsOfEach,
    keepOneLight,
    [](Permutation& p) { p.reflection = Reflection::None; },
    dropRelief,
    useFactors,
    dropLight,
    useOneColor,
};

/// What went may leave choices behind that contradict its absence.
void dropUnreadStreams(Permutation& p) {
    for (const TextureRoleRow& role : textureRoles())
        if (role.stream != nullptr && !isRead(p, role.stream))
            p.*role.stream = UvStream::Uv0;
    p.uv0Transform = p.uv0Transform && anyReads(p, UvStream::Uv0);
    p.uv1Transform = p.uv1Transform && anyReads(p, UvStream::Uv1);
}

} // namespace

std::optional<Permutation> simpler(const Permutation& permutation) {
    for (const Change change : kRungs) {
        Permutation next = permutation;
        change(next);
        dropUnreadStreams(next);
        const Result<Canonical> canonical = canonicalise(next);
        assert(canonical && "a rung takes away, and what is left does not contradict itself");
        if (canonical->permutation != permutation)
            return canonical->permutation;
    }
    return std::nullopt;
}

} // namespace franken
