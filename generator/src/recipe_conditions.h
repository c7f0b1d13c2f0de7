// SPDX-License-Identifier: MIT
#pragma once

#include "needs.h"

#include "franken/generator/permutation.h"

// What the slots and forms of the recipe ask of a permutation and its needs.
namespace franken::conditions {

using P = const Permutation&;
using N = const Needs&;
using Condition = bool (*)(P, N);
constexpr bool always(P, N) { return true; }

template<auto Member, auto Value>
bool is(P p, N) {
    return p.*Member == Value;
}
template<bool Needs::*Need>
bool needs(P, N n) {
    return n.*Need;
}
template<LightForm Form>
bool lights(P, N n) {
    return n.lightForm == Form;
}
inline bool lightsPerVertex(N n) {
    return n.lightForm == LightForm::VertexWorld || n.lightForm == LightForm::VertexTangent;
}

inline constexpr Condition kDirect = needs<&Needs::direct>;
inline constexpr Condition kReflected = needs<&Needs::reflection>;
inline constexpr Condition kEnergy = needs<&Needs::energy>;
inline constexpr Condition kTextured = needs<&Needs::textured>;
inline constexpr Condition kNormal = needs<&Needs::normal>;
// Where a vertex is moved before it is projected.
inline bool moved(P, N n) { return n.skinned || n.vertexHook; }
inline constexpr Condition kRigid = is<&Permutation::influences, 1>;
inline constexpr Condition kFew = lights<LightForm::PixelFew>;
inline constexpr Condition kTangent = lights<LightForm::VertexTangent>;
inline constexpr Condition kFp16 = is<&Permutation::precision, Precision::Fp16>;
inline bool directInFp16(P p, N n) { return n.direct && p.precision == Precision::Fp16; }
inline bool spotsInFp16(P p, N) { return p.spots && p.precision == Precision::Fp16; }
// Lights that are attenuated each by its own distance. 16 bits have another form.
inline bool atAnyDistance(P p, N n) {
    return n.direct && p.punctualLights > 0 && p.precision == Precision::Fp32;
}
// VideoCore IV has 32 bits.
inline bool onVc4(P p) { return p.target == Target::Vc4 && p.precision == Precision::Fp32; }
inline bool fewOnVc4(P p, N n) { return n.lightForm == LightForm::PixelFew && onVc4(p); }
inline bool ofVc4(P p, N) { return onVc4(p); }
inline constexpr Condition kSeed = is<&Permutation::brdf, Brdf::Seed>;
inline bool texturedBase(P p, N n) { return n.base && p.baseColorTexture; }
inline bool coloured(P p, N n) { return n.base && p.vertexColor; }
inline bool normalVarying(P, N n) { return n.normal && n.lightForm != LightForm::VertexTangent; }
inline bool cameraVarying(P, N n) { return n.toCamera && !lightsPerVertex(n); }
inline bool cubic(P p, N n) { return n.color && n.decode && p.decode == Decode::Fast; }
inline constexpr Condition kPacked = is<&Permutation::metallicRoughness, MetallicRoughness::Packed>;
inline constexpr Condition kSeparate = is<&Permutation::metallicRoughness, MetallicRoughness::Separate>;
inline bool packedOcclusion(P p, N n) { return n.occlusion && p.occlusion == Occlusion::Packed; }
inline bool looked(P p, N n) { return n.material && p.view == View::RoughnessMetallic; }
template<View V>
bool views(P p, N n) {
    return n.material && p.view == V;
}
inline bool toneMapped(P p, N n) {
    return p.toneMap != ToneMap::None && (p.program == Program::Sky || n.direct || n.ambient || n.emissive);
}

// Whether vectors are made unit that go into a highlight's width (docs/mathematics.md, Roots on VideoCore
// IV).
inline bool exactLengths(N n) {
    return n.lightForm == LightForm::PixelUnit || n.lightForm == LightForm::VertexWorld;
}
inline bool looseLengths(P p, N n) { return onVc4(p) && !exactLengths(n); }
// Not the seed's, whose order of products was searched with the other form.
inline bool anglesByLogarithms(P p, N n) {
    return onVc4(p) && p.brdf != Brdf::Seed && n.lightForm == LightForm::PixelUnit;
}
// Where it was found to pay (docs/mathematics.md, One division a light).
inline bool lobeByLogarithms(P p, N n) {
    const bool two = n.lightForm == LightForm::PixelFew && n.normalMap && p.suns == 2;
    const bool mirrored = n.lightForm == LightForm::PixelUnit && n.reflection;
    const bool shorter = n.lightForm == LightForm::VertexTangent || mirrored || two;
    return onVc4(p) && p.brdf == Brdf::Gltf && shorter;
}
// Two suns over a normal map and the textures of all else: an order that was searched for these alone
// (tests/qpu/README.md, Goals).
inline bool twoSunsOverTextures(P p, N n) {
    const bool all = n.textured && n.emissive && p.emissive == Emissive::Texture && packedOcclusion(p, n);
    const bool fast = cubic(p, n) && p.output != Output::Srgb; // The exact curves' are dearer so.
    return all && fast && n.ambient && !n.energy && !n.reflection && n.lightForm == LightForm::PixelFew &&
           lobeByLogarithms(p, n);
}
// Only 16 bits have a lobe of their own for a product.
inline bool separateLobe(P p, N n) {
    return n.direct && (p.brdf == Brdf::Gltf || p.brdf == Brdf::Fast || p.precision == Precision::Fp16);
}
inline bool readsRoughness(P p, N n) {
    return n.roughness && (n.textured || looked(p, n) || directInFp16(p, n));
}
// Each light is tinted by the base colour at once, so that there is one sum.
inline bool tintsAtOnce(P, N n) { return n.direct && (n.reflection || n.energy); }
// Where Smith's root stands in the fit of what is scattered between facets.
inline bool fitsEnergy(P, N n) { return n.direct && n.energy && n.textured && !n.reflection; }
inline bool roots(P p, N n) {
    return fitsEnergy(p, n) || n.lightForm == LightForm::PixelFew ||
           (n.lightForm == LightForm::PixelUnit && !anglesByLogarithms(p, n)) ||
           (n.direct && p.brdf == Brdf::Gltf);
}

} // namespace franken::conditions
