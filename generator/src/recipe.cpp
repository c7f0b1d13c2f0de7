// SPDX-License-Identifier: MIT
#include "recipe.h"

#include "recipe_slot.h"
#include "recipe_walk.h"

#include <array>
#include <utility>

namespace franken {
namespace {

using namespace conditions;

constexpr Stage kVertex = Stage::Vertex;
constexpr Stage kFragment = Stage::Fragment;

constexpr std::array kSlots = {
    Slot{kVertex,
         needs<&Needs::skinned>,
         {{"skin/palette.32", is<&Permutation::joints, Joints::UpTo32>},
          {"skin/palette.64", is<&Permutation::joints, Joints::UpTo64>},
          {"skin/palette.256"}}},
    Slot{kVertex, needs<&Needs::skinned>, {{"skin/matrix.rigid", kRigid}, {"skin/matrix"}}},
    Slot{kVertex, [](P p, N n) { return n.skinned && !kRigid(p, n); }, {{"skin/influence"}}, Each::Influence},
    Slot{kVertex, moved, {{"transform/moved.skin", needs<&Needs::skinned>}, {"transform/moved"}}},
    Slot{kVertex, needs<&Needs::vertexHook>, {{"transform/effect"}}, Each::Effect},
    Slot{kVertex, needs<&Needs::material>, {{"transform/position.moved", moved}, {"transform/position"}}},
    Slot{kVertex, is<&Permutation::program, Program::Overlay>, {{"transform/overlay"}}},
    Slot{kVertex, is<&Permutation::program, Program::Sky>, {{"transform/skybox"}}},
    Slot{kVertex,
         needs<&Needs::uv0>,
         {{"streams/uv0.transform", is<&Permutation::uv0Transform, true>}, {"streams/uv0"}}},
    Slot{kVertex,
         needs<&Needs::uv1>,
         {{"streams/uv1.transform", is<&Permutation::uv1Transform, true>}, {"streams/uv1"}}},
    Slot{kVertex, coloured, {{"streams/color"}}},
    Slot{kVertex, kNormal, {{"frame/normal.skin", needs<&Needs::skinned>}, {"frame/normal"}}},
    Slot{kVertex, normalVarying, {{"frame/normal_varying"}}},
    Slot{kVertex,
         [](P, N n) { return n.toCamera || n.normalMap; },
         {{"frame/to_camera.moved", [](P p, N n) { return n.toCamera && moved(p, n); }},
          {"frame/to_camera", needs<&Needs::toCamera>},
          {"frame/model"}}},
    Slot{kVertex, cameraVarying, {{"frame/to_camera_varying.fp16", kFp16}, {"frame/to_camera_varying"}}},
    Slot{kVertex, directInFp16, {{"lights/to_punctual.fp16"}}, Each::Punctual},
    Slot{kVertex,
         needs<&Needs::normalMap>,
         {{"frame/tangent.skin", needs<&Needs::skinned>}, {"frame/tangent"}}},
    Slot{kVertex, needs<&Needs::normalMap>, {{"frame/tangent_space", kTangent}, {"frame/tangent_varying"}}},
    Slot{kVertex, kTangent, {{"sun/tangent_space"}}, Each::Sun},
    Slot{kVertex, lights<LightForm::VertexWorld>, {{"sun/angles"}}},
    Slot{kVertex, lights<LightForm::VertexWorld>, {{"sun/angle"}}, Each::Sun},
    Slot{kVertex, lights<LightForm::VertexWorld>, {{"sun/fresnel"}}},

    Slot{kFragment, always, {{"inputs/precision.fp16", kFp16}, {"inputs/precision"}}},
    Slot{kFragment, needs<&Needs::uv0>, {{"inputs/uv0"}}},
    Slot{kFragment, needs<&Needs::uv1>, {{"inputs/uv1"}}},
    Slot{kFragment, coloured, {{"inputs/vertex_color"}}},
    Slot{kFragment, normalVarying, {{"inputs/normal"}}},
    Slot{kFragment, cameraVarying, {{"inputs/to_camera"}}},
    Slot{kFragment, is<&Permutation::program, Program::Sky>, {{"inputs/direction"}}},

    Slot{
        kFragment, [](P p, N n) { return n.decode && p.decode == Decode::Exact; }, {{"math/srgb_to_linear"}}},
    Slot{kFragment, roots, {{"math/square_root.vc4", ofVc4}, {"math/square_root"}}},
    Slot{kFragment, kNormal, {{"math/inverse_square_root.vc4", looseLengths}, {"math/inverse_square_root"}}},
    Slot{kFragment,
         [](P p, N n) { return n.reflection || (n.direct && !lobeByLogarithms(p, n)); },
         {{"math/reciprocal.vc4", ofVc4}, {"math/reciprocal"}}},

    Slot{kFragment,
         needs<&Needs::base>,
         {{"base_color/texture", is<&Permutation::baseColorTexture, true>, &Permutation::baseColorUv},
          {"base_color/factor"}}},
    Slot{kFragment,
         [](P p, N n) { return n.color && p.baseColorTexture && n.decode && p.decode == Decode::Exact; },
         {{"base_color/srgb_to_linear"}}},
    Slot{kFragment,
         texturedBase,
         {{"base_color/times_factor.encoded", needs<&Needs::encoded>},
          {"base_color/approximate_srgb_to_linear", cubic},
          {"base_color/times_factor"}}},
    Slot{
        kFragment,
        [](P p, N n) { return texturedBase(p, n) && (cubic(p, n) || n.encoded) && p.alpha != Alpha::Opaque; },
        {{"base_color/times_alpha"}}},
    Slot{kFragment, coloured, {{"base_color/times_vertex_color"}}},
    Slot{kFragment, needs<&Needs::baseColorHook>, {{"effect/base_color"}}, Each::Effect},
    Slot{kFragment,
         [](P p, N n) { return n.material && p.alpha == Alpha::Mask; },
         {{"base_color/alpha_mask"}}},

    Slot{kFragment,
         kNormal,
         {{"normal/map.tangent_space", kTangent, &Permutation::normalUv},
          {"normal/map.unnormalised",
           [](P, N n) { return n.normalMap && n.lightForm == LightForm::PixelFew; }, &Permutation::normalUv},
          {"normal/map", needs<&Needs::normalMap>, &Permutation::normalUv},
          {"normal/vertex.unnormalised", kFew},
          {"normal/vertex"}}},
    Slot{kFragment,
         needs<&Needs::turned>,
         {{"normal/double_sided.facing", is<&Permutation::facingWorkaround, true>}, {"normal/double_sided"}}},

    Slot{kFragment,
         [](P p, N n) { return kPacked(p, n) && (n.metallic || n.roughness || packedOcclusion(p, n)); },
         {{"metallic_roughness/packed", always, &Permutation::metallicRoughnessUv}}},
    Slot{kFragment,
         [](P p, N n) { return (n.textured && n.metallic) || readsRoughness(p, n) || looked(p, n); },
         {{"metallic_roughness/factors"}}},
    Slot{kFragment,
         [](P p, N n) { return n.metallic && (n.textured || looked(p, n)); },
         {{"metallic_roughness/metallic.packed", kPacked},
          {"metallic_roughness/metallic.separate", kSeparate, &Permutation::metallicRoughnessUv},
          {"metallic_roughness/metallic.factor"}}},
    Slot{kFragment,
         readsRoughness,
         {{"metallic_roughness/roughness.packed", kPacked},
          {"metallic_roughness/roughness.separate", kSeparate, &Permutation::metallicRoughnessUv},
          {"metallic_roughness/roughness.factor"}}},
    Slot{kFragment, needs<&Needs::toEye>, {{"effect/to_eye.fp16", kFp16}, {"effect/to_eye"}}},
    Slot{kFragment, needs<&Needs::surfaceHook>, {{"effect/surface"}}, Each::Effect},
    Slot{kFragment,
         [](P p, N n) { return n.textured && n.roughness && n.shaded && p.precision == Precision::Fp16; },
         {{"metallic_roughness/floor.fp16"}}},
    // A packed occlusion waits where the sky is reflected, or two suns come first: see below.
    Slot{kFragment,
         [](P p, N n) {
             return n.occlusion && !(packedOcclusion(p, n) && n.reflection) && !twoSunsOverTextures(p, n);
         },
         {{"occlusion/packed", packedOcclusion}, {"occlusion/texture", always, &Permutation::occlusionUv}}},

    Slot{kFragment, kReflected, {{"reflection/irradiance"}}},
    Slot{kFragment,
         kDirect,
         {{"surface/surface.seed", kSeed},
          {"surface/surface.energy", kEnergy},
          {"surface/surface.reflection", kReflected},
          {"surface/surface"}}},
    Slot{kFragment, kDirect, {{"lights/angles.fp16", kFp16}, {"lights/angles"}}},
    Slot{kFragment, [](P, N n) { return n.direct && !lightsPerVertex(n); }, {{"brdf/schlick"}}},
    Slot{kFragment, kDirect, {{"brdf/ggx.fp16", kFp16}, {"brdf/ggx"}}},
    Slot{kFragment,
         kDirect,
         {{"brdf/smith_correlated", is<&Permutation::brdf, Brdf::Gltf>},
          {"brdf/hammon", is<&Permutation::brdf, Brdf::Fast>},
          {"brdf/schlick_ggx.fp16", kFp16},
          {"brdf/schlick_ggx"}}},
    // Schlick-GGX, a product, has its lobe already.
    Slot{kFragment,
         separateLobe,
         {{"brdf/specular.fp16", kFp16}, {"brdf/specular.vc4", lobeByLogarithms}, {"brdf/specular"}}},
    Slot{kFragment,
         [](P, N n) { return n.material && n.shaded && n.metallic && !n.textured; },
         {{"surface/reflectance.seed", [](P p, N n) { return n.direct && p.brdf == Brdf::Seed; }},
          {"surface/reflectance"}}},
    Slot{kFragment,
         kDirect,
         {{"surface/factors.seed", [](P p, N n) { return !n.textured && p.brdf == Brdf::Seed; }},
          {"surface/factors", [](P, N n) { return !n.textured; }},
          {"surface/textures.smith_correlated.vc4", twoSunsOverTextures},
          {"surface/textures.smith_correlated", is<&Permutation::brdf, Brdf::Gltf>},
          {"surface/textures.seed", kSeed},
          {"surface/textures.hammon", is<&Permutation::brdf, Brdf::Fast>},
          {"surface/textures.schlick_ggx"}}},
    Slot{kFragment, [](P p, N n) { return tintsAtOnce(p, n) && !kSeed(p, n); }, {{"surface/base"}}},
    Slot{kFragment, directInFp16, {{"surface/slope.fp16"}}},

    Slot{kFragment,
         [](P, N n) { return n.ambient && !n.reflection; },
         {{"ambient/irradiance", needs<&Needs::skyLit>}, {"ambient/constant"}}},
    Slot{kFragment, kReflected, {{"reflection/atlas"}}},
    Slot{kFragment,
         [](P, N n) { return n.skyLit && !n.reflection; },
         {{"ambient/diffuse_share", kTextured}, {"ambient/diffuse_share.factors"}}},
    Slot{kFragment,
         [](P p, N n) { return n.ambient && n.occlusion && !n.reflection && !twoSunsOverTextures(p, n); },
         {{"occlusion/occlude"}}},
    Slot{kFragment, kDirect, {{"brdf/sum.tinted", tintsAtOnce}, {"brdf/sum"}}},
    Slot{kFragment,
         [](P, N n) { return n.direct && !n.reflection; },
         {{"ambient/sum.energy", [](P, N n) { return n.ambient && n.energy; }},
          {"ambient/none.energy", kEnergy},
          {"ambient/none", twoSunsOverTextures},
          {"ambient/sum", needs<&Needs::ambient>},
          {"ambient/none"}}},
    Slot{kFragment,
         twoSunsOverTextures,
         {{"emissive/texture.approximate_srgb.early", always, &Permutation::emissiveUv}}},
    Slot{kFragment, kTangent, {{"inputs/sun_tangent_space"}}, Each::Sun},
    Slot{kFragment,
         [](P, N n) { return n.direct || n.reflection; },
         {{"view/view.unnormalised.vc4", fewOnVc4},
          {"view/view.unnormalised", kFew},
          {"view/view.tangent_space", kTangent},
          {"view/view.vertex.reflection",
           [](P, N n) { return n.lightForm == LightForm::VertexWorld && n.reflection; }},
          {"view/view.vertex", lights<LightForm::VertexWorld>},
          {"view/view"}}},
    Slot{kFragment,
         kDirect,
         {{"lights/light.unnormalised.textures.vc4", twoSunsOverTextures},
          {"lights/light.unnormalised.vc4", fewOnVc4},
          {"lights/light.unnormalised", kFew},
          {"lights/light.tangent_space", kTangent},
          {"lights/light.vertex", lights<LightForm::VertexWorld>},
          {"lights/light.fp16", kFp16},
          {"lights/light.punctual.vc4",
           [](P p, N n) { return atAnyDistance(p, n) && anglesByLogarithms(p, n); }},
          {"lights/light.punctual", atAnyDistance},
          {"lights/light.vc4", anglesByLogarithms},
          {"lights/light"}}},
    Slot{kFragment,
         kDirect,
         {{"brdf/add_light.seed.reflection", [](P p, N n) { return p.brdf == Brdf::Seed && n.reflection; }},
          {"brdf/add_light.seed", kSeed},
          {"brdf/add_light.energy", kEnergy},
          {"brdf/add_light.reflection", kReflected},
          {"brdf/add_light"}}},
    Slot{kFragment, kReflected, {{"reflection/share.energy", kEnergy}, {"reflection/share"}}},
    Slot{kFragment,
         kReflected,
         {{"reflection/reflection.energy", [](P, N n) { return n.textured && n.energy; }},
          {"reflection/reflection.factors.energy", kEnergy},
          {"reflection/reflection", kTextured},
          {"reflection/reflection.factors"}}},
    // Late: while the lookup is waited for, the packed texel takes a register already.
    Slot{kFragment, [](P p, N n) { return packedOcclusion(p, n) && n.reflection; }, {{"occlusion/packed"}}},
    Slot{kFragment,
         [](P, N n) { return n.reflection && n.occlusion; },
         {{"occlusion/occlude.energy", kEnergy}, {"occlusion/occlude.reflection"}}},
    Slot{kFragment, kReflected, {{"reflection/reflected.energy", kEnergy}, {"reflection/reflected"}}},
    Slot{kFragment, [](P, N n) { return n.direct && n.reflection; }, {{"reflection/sum"}}},
    Slot{kFragment,
         [](P, N n) { return n.direct && n.energy; },
         {{"energy/lookup", kReflected},
          {"energy/textures.fp16", [](P p, N n) { return kTextured(p, n) && kFp16(p, n); }},
          {"energy/textures", kTextured},
          {"energy/factors"}}},
    Slot{kFragment,
         kDirect,
         {{"lights/sun.tangent_space", kTangent},
          {"lights/sun.vertex", lights<LightForm::VertexWorld>},
          {"lights/sun.punctual", atAnyDistance},
          {"lights/sun"}},
         Each::Sun},
    Slot{kFragment,
         [](P p, N n) { return n.direct && p.punctualLights > 0; },
         {{"lights/distance_attenuation.fp16", kFp16}, {"lights/distance_attenuation"}}},
    Slot{kFragment,
         [](P p, N n) { return n.direct && p.punctualLights > 0 && p.spots; },
         {{"lights/cone_attenuation.fp16", kFp16}, {"lights/cone_attenuation"}}},
    Slot{kFragment,
         kDirect,
         {{"lights/punctual.spot.fp16", spotsInFp16},
          {"lights/punctual.spot", is<&Permutation::spots, true>},
          {"lights/punctual.fp16", kFp16},
          {"lights/punctual"}},
         Each::Punctual},

    Slot{kFragment, twoSunsOverTextures, {{"occlusion/packed"}}},
    Slot{kFragment, twoSunsOverTextures, {{"ambient/add_occluded"}}},

    // What is shown. A sky's reflection without lights is shown already.
    Slot{kFragment,
         [](P, N n) { return n.direct || !n.reflection; },
         {{"shading/skybox.fp16",
           [](P p, N) { return p.program == Program::Sky && p.precision == Precision::Fp16; }},
          {"shading/skybox", is<&Permutation::program, Program::Sky>},
          {"shading/view_normal", views<View::Normal>},
          {"shading/view_metallic_roughness", views<View::RoughnessMetallic>},
          {"shading/view_occlusion", [](P p, N n) { return views<View::Occlusion>(p, n) && n.occlusion; }},
          {"shading/view_unoccluded", views<View::Occlusion>},
          {"shading/sum.reflection", kReflected},
          {"shading/sum.energy", kEnergy},
          {"shading/sum", kDirect},
          {"shading/ambient", needs<&Needs::ambient>},
          {"shading/black", [](P p, N n) { return n.material && n.shaded && p.shading == Shading::Lit; }},
          {"shading/unlit"}}},
    Slot{kFragment,
         [](P p, N n) { return n.emissive && !twoSunsOverTextures(p, n); },
         {{"emissive/factor", is<&Permutation::emissive, Emissive::Factor>},
          {"emissive/texture.linear", [](P, N n) { return !n.decode; }, &Permutation::emissiveUv},
          {"emissive/texture.approximate_srgb", is<&Permutation::decode, Decode::Fast>,
           &Permutation::emissiveUv},
          {"emissive/texture", always, &Permutation::emissiveUv}}},

    Slot{kFragment, needs<&Needs::lightHook>, {{"effect/light"}}, Each::Effect},

    Slot{kFragment,
         [](P p, N n) { return toneMapped(p, n) && p.precision == Precision::Fp16; },
         {{"shading/limit.fp16"}}},
    Slot{kFragment,
         toneMapped,
         {{"output/tone_reinhard", is<&Permutation::toneMap, ToneMap::Reinhard>},
          {"output/tone_aces", is<&Permutation::toneMap, ToneMap::Aces>},
          {"output/tone_neutral"}}},
    Slot{kFragment, toneMapped, {{"output/tone_map"}}},
    Slot{kFragment,
         needs<&Needs::encode>,
         {{"output/linear_to_srgb", is<&Permutation::output, Output::Srgb>},
          {"output/gamma22", is<&Permutation::output, Output::Pow22>},
          // Not the background's, which it makes dearer.
          {"output/approximate_linear_to_srgb.vc4", [](P p, N n) { return onVc4(p) && n.material; }},
          {"output/approximate_linear_to_srgb"}}},
    Slot{kFragment, needs<&Needs::encode>, {{"output/encode"}}},
    Slot{kFragment, is<&Permutation::dither, Dither::Ordered>, {{"output/dither"}}},
    Slot{kFragment,
         always,
         {{"output/write_blend", [](P p, N) { return p.program != Program::Sky && p.alpha == Alpha::Blend; }},
          {"output/write_opaque"}}},
};

static_assert(kRows<kSlots>.size() <= kMaxRows);
constexpr std::size_t kVertexCount = kVertexSlots<kSlots>;
static_assert(kSlots[kVertexCount - 1].stage == kVertex);

void addFragment(P p, Needs& n, Outline& outline) {
    addSlots<kSlots, kSlots.size()>(p, n, outline, std::make_index_sequence<kSlots.size() - kVertexCount>());
}
void addVertex(P p, Needs& n, Outline& outline) {
    addSlots<kSlots, kVertexCount>(p, n, outline, std::make_index_sequence<kVertexCount>());
}

} // namespace

std::span<const Row> recipe() { return kRows<kSlots>; }

RowRange rowsOf(Stage stage) {
    constexpr std::size_t kVertexRows = kFirstRow<kSlots>[kVertexCount];
    return stage == kVertex ? RowRange{0, kVertexRows} : RowRange{kVertexRows, kRows<kSlots>.size()};
}

Outlines outlines(const Permutation& p) {
    Needs needs = needsOf(p);
    Outlines result{};
    addFragment(p, needs, result.fragment);
    addVertex(p, needs, result.vertex);
    return result;
}

Outline outline(const Permutation& p, Stage stage) {
    Needs needs = needsOf(p);
    Outline fragment{}, vertex{};
    addFragment(p, needs, fragment);
    if (stage == Stage::Fragment)
        return fragment;
    addVertex(p, needs, vertex);
    return vertex;
}

} // namespace franken
