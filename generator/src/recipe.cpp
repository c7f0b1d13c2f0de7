// SPDX-License-Identifier: MIT
#include "recipe.h"

#include <algorithm>
#include <array>
#include <utility>

namespace franken {
namespace {

using P = const Permutation&;
using N = const Needs&;
constexpr Stage kVertex = Stage::Vertex;
constexpr Stage kFragment = Stage::Fragment;

bool pixelLight(N n) { return n.direct && !n.vertexSuns; }
bool manyAngles(N n) { return pixelLight(n) && !n.fewSuns; }
bool eye(N n) { return (n.direct || n.reflection) && !n.vertexSuns && !n.fewSuns; }
bool worldSuns(N n) { return n.vertexSuns && !n.tangentSpace; }
bool frame(N n) { return n.normalMap && !n.tangentSpace; }
bool packed(P p) { return p.metallicRoughness == MetallicRoughness::Packed; }
bool packedOcclusion(P p, N n) { return n.occlusion && p.occlusion == Occlusion::Packed; }
bool separate(P p) { return p.metallicRoughness == MetallicRoughness::Separate; }
bool looked(P p, N n) { return n.material && p.view == View::RoughnessMetallic; }
bool factors(P p, N n) { return (n.textured && (n.metallic || n.roughness)) || looked(p, n); }
bool reflectance(N n) { return n.material && n.shaded && n.metallic && !n.textured; }
bool lit(N n) { return n.direct || n.ambient; }
bool unlit(P p, N n) { return n.material && n.shaded && p.shading == Shading::Unlit; }
bool cubic(P p, N n) { return n.color && p.baseColorTexture && n.decode && p.decode == Decode::Fast; }
bool emissiveTexture(P p, N n) { return n.emissive && p.emissive == Emissive::Texture; }
bool toneMapped(P p, N n) { return p.program == Program::Sky || lit(n) || n.emissive; }
template<Brdf B>
bool uses(P p, N n) {
    return n.direct && p.brdf == B;
}
// Whether vectors are made unit that go into a highlight's width (README.md, Roots on VideoCore IV).
bool exactLengths(N n) { return n.direct && !n.fewSuns && !n.tangentSpace; }
bool looseLengths(P p, N n) { return p.target == Target::Vc4 && !exactLengths(n); }
// Not the seed's, whose order of products was searched with the other form.
bool anglesByLogarithms(P p) { return p.target == Target::Vc4 && p.brdf != Brdf::Seed; }
// Where it was found to pay (README.md, One division a light).
bool lobeByLogarithms(P p, N n) {
    const bool shorter = n.tangentSpace || (manyAngles(n) && n.reflection);
    return p.target == Target::Vc4 && uses<Brdf::Gltf>(p, n) && shorter;
}
bool roots(P p, N n) {
    return n.fewSuns || (manyAngles(n) && !anglesByLogarithms(p)) || uses<Brdf::Gltf>(p, n);
}
bool inverses(P p, N n) { return n.reflection || (n.direct && !lobeByLogarithms(p, n)); }
template<Brdf B>
bool usesTextures(P p, N n) {
    return uses<B>(p, n) && n.textured;
}
template<ToneMap T>
bool mapsBy(P p, N n) {
    return p.toneMap == T && toneMapped(p, n);
}
template<Output O>
bool encodesBy(P p, N n) {
    return n.encode && p.output == O;
}
// Not the background's, which it makes dearer.
bool encodesInExponent(P p, N n) {
    return p.target == Target::Vc4 && n.material && encodesBy<Output::SrgbFast>(p, n);
}

constexpr std::array kRecipe = {
    Row{kVertex, "position", [](P, N n) { return n.material; }},
    Row{kVertex, "overlay", [](P p, N) { return p.program == Program::Overlay; }},
    Row{kVertex, "sky", [](P p, N) { return p.program == Program::Sky; }},
    Row{kVertex, "uv0", [](P p, N n) { return n.uv0 && !p.uv0Transform; }},
    Row{kVertex, "uv0_transform", [](P p, N n) { return n.uv0 && p.uv0Transform; }},
    Row{kVertex, "uv1", [](P p, N n) { return n.uv1 && !p.uv1Transform; }},
    Row{kVertex, "uv1_transform", [](P p, N n) { return n.uv1 && p.uv1Transform; }},
    Row{kVertex, "color", [](P p, N n) { return n.base && p.vertexColor; }},
    Row{kVertex, "normal", [](P, N n) { return n.normal; }},
    Row{kVertex, "normal_varying", [](P, N n) { return n.normal && !n.tangentSpace; }},
    Row{kVertex, "world", [](P, N n) { return n.toCamera; }},
    Row{kVertex, "camera_varying", [](P, N n) { return n.toCamera && !n.vertexSuns; }},
    Row{kVertex, "model", [](P, N n) { return n.normalMap && !n.toCamera; }},
    Row{kVertex, "tangent", [](P, N n) { return n.normalMap; }},
    Row{kVertex, "tangent_varying", [](P, N n) { return frame(n); }},
    Row{kVertex, "tangent_frame", [](P, N n) { return n.tangentSpace; }},
    Row{kVertex, "sun_tangent", [](P, N n) { return n.tangentSpace; }, Each::Sun},
    Row{kVertex, "sun_angles", [](P, N n) { return worldSuns(n); }},
    Row{kVertex, "sun_angle", [](P, N n) { return worldSuns(n); }, Each::Sun},
    Row{kVertex, "sun_fresnel", [](P, N n) { return worldSuns(n); }},

    Row{kFragment, "precision", [](P, N) { return true; }},
    Row{kFragment, "uv0_varying", [](P, N n) { return n.uv0; }},
    Row{kFragment, "uv1_varying", [](P, N n) { return n.uv1; }},
    Row{kFragment, "color_varying", [](P p, N n) { return n.base && p.vertexColor; }},
    Row{kFragment, "normal_varying", [](P, N n) { return n.normal && !n.tangentSpace; }},
    Row{kFragment, "camera_varying", [](P, N n) { return n.toCamera && !n.vertexSuns; }},
    Row{kFragment, "direction_varying", [](P p, N) { return p.program == Program::Sky; }},

    Row{kFragment, "decode_exact", [](P p, N n) { return n.decode && p.decode == Decode::Exact; }},
    Row{kFragment, "root", [](P p, N n) { return roots(p, n) && p.target != Target::Vc4; }},
    Row{kFragment, "root.vc4", [](P p, N n) { return roots(p, n) && p.target == Target::Vc4; }},
    Row{kFragment, "inverse_root", [](P p, N n) { return n.normal && !looseLengths(p, n); }},
    Row{kFragment, "inverse_root.vc4", [](P p, N n) { return n.normal && looseLengths(p, n); }},
    Row{kFragment, "inverse", [](P p, N n) { return inverses(p, n) && p.target != Target::Vc4; }},
    Row{kFragment, "inverse.vc4", [](P p, N n) { return inverses(p, n) && p.target == Target::Vc4; }},
    Row{kFragment, "base_factor", [](P p, N n) { return n.base && !p.baseColorTexture; }},
    Row{kFragment, "base_texture", [](P p, N n) { return n.base && p.baseColorTexture; }, Each::Once,
        &Permutation::baseColorUv},
    Row{kFragment, "base_decode",
        [](P p, N n) { return n.color && p.baseColorTexture && n.decode && p.decode == Decode::Exact; }},
    Row{kFragment, "base_tint", [](P p, N n) { return n.base && p.baseColorTexture && !cubic(p, n); }},
    Row{kFragment, "base_cubic", cubic},
    Row{kFragment, "base_alpha", [](P p, N n) { return cubic(p, n) && p.alpha != Alpha::Opaque; }},
    Row{kFragment, "base_color", [](P p, N n) { return n.base && p.vertexColor; }},
    Row{kFragment, "mask", [](P p, N n) { return n.material && p.alpha == Alpha::Mask; }},

    Row{kFragment, "normal_vertex", [](P, N n) { return n.normal && !n.normalMap && !n.fewSuns; }},
    Row{kFragment, "normal_vertex.few", [](P, N n) { return n.fewSuns && !n.normalMap; }},
    Row{kFragment, "normal_map", [](P, N n) { return frame(n) && !n.fewSuns; }, Each::Once,
        &Permutation::normalUv},
    Row{kFragment, "normal_map.few", [](P, N n) { return frame(n) && n.fewSuns; }, Each::Once,
        &Permutation::normalUv},
    Row{kFragment, "normal_tangent", [](P, N n) { return n.tangentSpace; }, Each::Once,
        &Permutation::normalUv},
    Row{kFragment, "double_sided", [](P p, N n) { return n.turned && !p.facingWorkaround; }},
    Row{kFragment, "double_sided.facing", [](P p, N n) { return n.turned && p.facingWorkaround; }},

    Row{kFragment, "orm",
        [](P p, N n) {
            return packed(p) && (n.metallic || n.roughness || (n.occlusion && p.occlusion == Occlusion::Packed));
        },
        Each::Once, &Permutation::metallicRoughnessUv},
    Row{kFragment, "metallic_roughness", [](P p, N n) { return factors(p, n); }},
    Row{kFragment, "metallic_factor", [](P p, N n) { return looked(p, n) && !n.textured; }},
    Row{kFragment, "metallic_packed", [](P p, N n) { return n.metallic && packed(p); }},
    Row{kFragment, "metallic_separate", [](P p, N n) { return n.metallic && separate(p); }, Each::Once,
        &Permutation::metallicRoughnessUv},
    Row{kFragment, "roughness_factor", [](P p, N n) { return looked(p, n) && !n.textured; }},
    Row{kFragment, "roughness_packed", [](P p, N n) { return n.roughness && packed(p); }},
    Row{kFragment, "roughness_separate", [](P p, N n) { return n.roughness && separate(p); }, Each::Once,
        &Permutation::metallicRoughnessUv},
    Row{kFragment, "occlusion", [](P p, N n) { return n.occlusion && p.occlusion == Occlusion::Texture; },
        Each::Once, &Permutation::occlusionUv},
    Row{kFragment, "occlusion_packed", [](P p, N n) { return packedOcclusion(p, n) && !n.reflection; }},

    Row{kFragment, "sky_irradiance", [](P, N n) { return n.reflection; }},
    Row{kFragment, "surface", [](P p, N n) { return n.direct && p.brdf != Brdf::Seed; }},
    Row{kFragment, "surface.seed", uses<Brdf::Seed>},
    Row{kFragment, "gltf", [](P p, N n) { return uses<Brdf::Gltf>(p, n) && !lobeByLogarithms(p, n); }},
    Row{kFragment, "gltf.vc4", lobeByLogarithms},
    Row{kFragment, "seed", uses<Brdf::Seed>},
    Row{kFragment, "fast", uses<Brdf::Fast>},
    Row{kFragment, "schlick", uses<Brdf::Schlick>},
    Row{kFragment, "add_light", [](P p, N n) { return n.direct && p.brdf != Brdf::Seed && !n.reflection; }},
    Row{kFragment, "add_light.reflection", [](P p, N n) { return n.direct && p.brdf != Brdf::Seed && n.reflection; }},
    Row{kFragment, "add_light.seed", [](P p, N n) { return uses<Brdf::Seed>(p, n) && !n.reflection; }},
    Row{kFragment, "add_light.seed.reflection", [](P p, N n) { return uses<Brdf::Seed>(p, n) && n.reflection; }},
    Row{kFragment, "reflectance_uniform", [](P, N n) { return reflectance(n); }},
    Row{kFragment, "surface_factors",
        [](P p, N n) { return n.direct && !n.textured && p.brdf != Brdf::Seed; }},
    Row{kFragment, "surface_factors.seed", [](P p, N n) { return uses<Brdf::Seed>(p, n) && !n.textured; }},
    Row{kFragment, "surface_gltf.texture", usesTextures<Brdf::Gltf>},
    Row{kFragment, "surface_seed.texture", usesTextures<Brdf::Seed>},
    Row{kFragment, "surface_fast.texture", usesTextures<Brdf::Fast>},
    Row{kFragment, "surface_schlick.texture", usesTextures<Brdf::Schlick>},

    Row{kFragment, "dark", [](P, N n) { return n.direct && !n.ambient; }},
    Row{kFragment, "ambient_color", [](P p, N n) { return n.ambient && p.ambient == Ambient::Color; }},
    Row{kFragment, "ambient_sky", [](P, N n) { return n.skyLit && !n.reflection; }},
    Row{kFragment, "sky_atlas", [](P, N n) { return n.reflection; }},
    Row{kFragment, "sky_reflectance.factors", [](P, N n) { return n.skyLit && !n.reflection && !n.textured; }},
    Row{kFragment, "sky_reflectance", [](P, N n) { return n.skyLit && !n.reflection && n.textured; }},
    Row{kFragment, "occlude", [](P, N n) { return n.ambient && n.occlusion && !n.reflection; }},
    Row{kFragment, "specular", [](P, N n) { return n.direct && !n.reflection; }},
    Row{kFragment, "eye", [](P, N n) { return eye(n); }},
    Row{kFragment, "eye.few", [](P p, N n) { return n.fewSuns && p.target != Target::Vc4; }},
    Row{kFragment, "eye.few.vc4", [](P p, N n) { return n.fewSuns && p.target == Target::Vc4; }},
    Row{kFragment, "angles", [](P p, N n) { return manyAngles(n) && !anglesByLogarithms(p); }},
    Row{kFragment, "angles.vc4", [](P p, N n) { return manyAngles(n) && anglesByLogarithms(p); }},
    Row{kFragment, "angles.few", [](P p, N n) { return n.fewSuns && p.target != Target::Vc4; }},
    Row{kFragment, "angles.few.vc4", [](P p, N n) { return n.fewSuns && p.target == Target::Vc4; }},
    Row{kFragment, "sun_angles", [](P, N n) { return worldSuns(n); }},
    Row{kFragment, "sun_tangent_varyings", [](P, N n) { return n.tangentSpace; }, Each::Sun},
    Row{kFragment, "tangent_angles", [](P, N n) { return n.tangentSpace; }},
    Row{kFragment, "eye_vertex", [](P, N n) { return n.reflection && n.vertexSuns; }},
    Row{kFragment, "sky_specular.factors", [](P, N n) { return n.reflection && !n.textured; }},
    Row{kFragment, "sky_specular", [](P, N n) { return n.reflection && n.textured; }},
    // Late: while the lookup is waited for, the packed texel takes a register already.
    Row{kFragment, "occlusion_packed", [](P p, N n) { return packedOcclusion(p, n) && n.reflection; }},
    Row{kFragment, "occlude.reflection", [](P, N n) { return n.reflection && n.occlusion; }},
    Row{kFragment, "sky_sum", [](P, N n) { return n.reflection; }},
    Row{kFragment, "sun", [](P, N n) { return manyAngles(n) && !n.reflection; }, Each::Sun},
    Row{kFragment, "sun.reflection", [](P, N n) { return manyAngles(n) && n.reflection; }, Each::Sun},
    Row{kFragment, "sun.few", [](P p, N n) { return n.fewSuns && p.target != Target::Vc4; }, Each::Sun},
    Row{kFragment, "sun.few.vc4", [](P p, N n) { return n.fewSuns && p.target == Target::Vc4; }, Each::Sun},
    Row{kFragment, "sun_vertex", [](P, N n) { return worldSuns(n) && !n.reflection; }, Each::Sun},
    Row{kFragment, "sun_vertex.reflection", [](P, N n) { return worldSuns(n) && n.reflection; }, Each::Sun},
    Row{kFragment, "sun_tangent", [](P, N n) { return n.tangentSpace; }, Each::Sun},
    Row{kFragment, "punctual_point", [](P p, N n) { return n.direct && p.punctualLights > 0; }},
    Row{kFragment, "punctual_cone", [](P p, N n) { return n.direct && p.punctualLights > 0 && p.spots; }},
    Row{kFragment, "punctual", [](P, N n) { return n.direct; }, Each::Punctual},
    Row{kFragment, "punctual_spot", [](P p, N n) { return n.direct && p.spots; }, Each::Punctual},
    Row{kFragment, "punctual_add", [](P, N n) { return n.direct && !n.reflection; }, Each::Punctual},
    Row{kFragment, "punctual_add.reflection", [](P, N n) { return n.direct && n.reflection; }, Each::Punctual},

    Row{kFragment, "shade", [](P, N n) { return n.direct && !n.reflection; }},
    Row{kFragment, "shade_ambient", [](P, N n) { return n.ambient && !n.direct && !n.reflection; }},
    Row{kFragment, "shade_unlit",
        [](P p, N n) {
            return unlit(p, n) || p.program == Program::Overlay || (n.material && p.view == View::BaseColor);
        }},
    Row{kFragment, "shade_black",
        [](P p, N n) { return n.material && n.shaded && p.shading == Shading::Lit && !lit(n); }},
    Row{kFragment, "shade_sky", [](P p, N) { return p.program == Program::Sky; }},
    Row{kFragment, "view_normal", [](P p, N n) { return n.material && p.view == View::Normal; }},
    Row{kFragment, "view_metallic_roughness", looked},
    Row{kFragment, "view_occlusion",
        [](P p, N n) { return n.material && p.view == View::Occlusion && n.occlusion; }},
    Row{kFragment, "view_unoccluded",
        [](P p, N n) { return n.material && p.view == View::Occlusion && !n.occlusion; }},
    Row{kFragment, "emissive_factor", [](P p, N n) { return n.emissive && p.emissive == Emissive::Factor; }},
    Row{kFragment, "emissive_texture",
        [](P p, N n) { return emissiveTexture(p, n) && n.decode && p.decode == Decode::Exact; }, Each::Once,
        &Permutation::emissiveUv},
    Row{kFragment, "emissive_cubic",
        [](P p, N n) { return emissiveTexture(p, n) && n.decode && p.decode == Decode::Fast; }, Each::Once,
        &Permutation::emissiveUv},
    Row{kFragment, "emissive_texture_linear", [](P p, N n) { return emissiveTexture(p, n) && !n.decode; },
        Each::Once, &Permutation::emissiveUv},

    Row{kFragment, "tone_reinhard", mapsBy<ToneMap::Reinhard>},
    Row{kFragment, "tone_aces", mapsBy<ToneMap::Aces>},
    Row{kFragment, "tone_neutral", mapsBy<ToneMap::Neutral>},
    Row{kFragment, "tone_map", [](P p, N n) { return p.toneMap != ToneMap::None && toneMapped(p, n); }},
    Row{kFragment, "encode_srgb", encodesBy<Output::Srgb>},
    Row{kFragment, "encode_srgb_fast",
        [](P p, N n) { return encodesBy<Output::SrgbFast>(p, n) && !encodesInExponent(p, n); }},
    Row{kFragment, "encode_srgb_fast.vc4", encodesInExponent},
    Row{kFragment, "encode_pow22", encodesBy<Output::Pow22>},
    Row{kFragment, "encode", [](P, N n) { return n.encode; }},
    Row{kFragment, "dither", [](P p, N) { return p.dither == Dither::Ordered; }},
    Row{kFragment, "write_opaque",
        [](P p, N) { return p.program == Program::Sky || p.alpha != Alpha::Blend; }},
    Row{kFragment, "write_blend",
        [](P p, N) { return p.program != Program::Sky && p.alpha == Alpha::Blend; }},
};

static_assert(kRecipe.size() <= std::bitset<192>().size());

// The rows of the vertex shader stand first.
constexpr std::size_t kVertexRows = static_cast<std::size_t>(
    std::count_if(kRecipe.begin(), kRecipe.end(), [](const Row& row) { return row.stage == kVertex; }));
static_assert(kRecipe[kVertexRows - 1].stage == kVertex);

std::size_t firstRow(Stage stage) { return stage == kVertex ? 0 : kVertexRows; }
std::size_t endRow(Stage stage) { return stage == kVertex ? kVertexRows : kRecipe.size(); }

std::uint8_t count(P p, Each each) {
    return each == Each::Sun ? p.suns : each == Each::Punctual ? p.punctualLights : 1;
}

template<std::size_t Index>
void addRow(P p, N n, Outline& outline) {
    constexpr Row row = kRecipe[Index];
    const bool applies = row.when(p, n) && count(p, row.each) > 0;
    outline.rows[Index] = applies;
    if constexpr (row.uv != nullptr)
        outline.readsUv1[Index] = applies && p.*row.uv == UvStream::Uv1;
    if constexpr (row.each == Each::Sun)
        outline.suns = applies ? p.suns : outline.suns;
    if constexpr (row.each == Each::Punctual)
        outline.punctualLights = applies ? p.punctualLights : outline.punctualLights;
}

// Spelt out row by row: no loop and no calls are left, and canonicalising is mostly this.
template<std::size_t First, std::size_t... Index>
void addRows(P p, N n, Outline& outline, std::index_sequence<Index...>) {
    (addRow<First + Index>(p, n, outline), ...);
}

} // namespace

std::span<const Row> recipe() { return kRecipe; }

Outline outline(const Permutation& p, Stage stage) {
    const Needs needs = needsOf(p);
    Outline result{};
    if (stage == kVertex)
        addRows<0>(p, needs, result, std::make_index_sequence<kVertexRows>());
    else
        addRows<kVertexRows>(p, needs, result, std::make_index_sequence<kRecipe.size() - kVertexRows>());
    return result;
}

std::vector<Step> plan(const Permutation& p, Stage stage) {
    const Outline applying = outline(p, stage);
    std::vector<Step> steps;
    steps.reserve(64);
    for (std::size_t begin = firstRow(stage), end = begin + 1; begin < endRow(stage); begin = end++) {
        if (!applying.rows[begin])
            continue;
        const Each each = kRecipe[begin].each;
        while (each != Each::Once && end < endRow(stage) && kRecipe[end].each == each)
            ++end;
        for (std::uint8_t light = 0; light < count(p, each); ++light)
            for (std::size_t row = begin; row < end; ++row)
                if (applying.rows[row])
                    steps.push_back({static_cast<std::uint8_t>(row), light,
                                     applying.readsUv1[row] ? UvStream::Uv1 : UvStream::Uv0});
    }
    return steps;
}

std::vector<Step> plan(const Permutation& p) {
    std::vector<Step> steps = plan(p, Stage::Vertex);
    const std::vector<Step> fragment = plan(p, Stage::Fragment);
    steps.insert(steps.end(), fragment.begin(), fragment.end());
    return steps;
}

} // namespace franken
