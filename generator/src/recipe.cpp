// SPDX-License-Identifier: MIT
#include "recipe.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

namespace franken {
namespace {

using P = const Permutation&;
using N = const Needs&;
using Condition = bool (*)(P, N);
constexpr Stage kVertex = Stage::Vertex;
constexpr Stage kFragment = Stage::Fragment;

constexpr bool always(P, N) { return true; }

/// One way to fill a slot.
struct Form {
    std::string_view snippet;
    Condition when = always;
    UvStream Permutation::*uv = nullptr;
};

constexpr std::size_t kMaxForms = 9;

/// A place in the text. Where `when` holds, the first form that applies stands there.
struct Slot {
    constexpr Slot(Stage stage_, Condition when_, std::initializer_list<Form> forms_, Each each_ = Each::Once)
        : stage(stage_), when(when_), count(forms_.size()), each(each_) {
        std::copy(forms_.begin(), forms_.end(), forms.begin());
    }

    Stage stage;
    Condition when;
    std::array<Form, kMaxForms> forms;
    std::size_t count;
    Each each;
};

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
bool lightsPerVertex(N n) {
    return n.lightForm == LightForm::VertexWorld || n.lightForm == LightForm::VertexTangent;
}

constexpr Condition kDirect = needs<&Needs::direct>;
constexpr Condition kReflected = needs<&Needs::reflection>;
constexpr Condition kTextured = needs<&Needs::textured>;
constexpr Condition kNormal = needs<&Needs::normal>;
constexpr Condition kFew = lights<LightForm::PixelFew>;
constexpr Condition kTangent = lights<LightForm::VertexTangent>;
bool fewOnVc4(P p, N n) { return n.lightForm == LightForm::PixelFew && p.target == Target::Vc4; }
// What more than one slot asks.
constexpr Condition kOnVc4 = is<&Permutation::target, Target::Vc4>;
constexpr Condition kSeed = is<&Permutation::brdf, Brdf::Seed>;
bool texturedBase(P p, N n) { return n.base && p.baseColorTexture; }
bool coloured(P p, N n) { return n.base && p.vertexColor; }
bool normalVarying(P, N n) { return n.normal && n.lightForm != LightForm::VertexTangent; }
bool cameraVarying(P, N n) { return n.toCamera && !lightsPerVertex(n); }
bool cubic(P p, N n) { return n.color && n.decode && p.decode == Decode::Fast; }
bool packed(P p) { return p.metallicRoughness == MetallicRoughness::Packed; }
bool packedOcclusion(P p, N n) { return n.occlusion && p.occlusion == Occlusion::Packed; }
bool looked(P p, N n) { return n.material && p.view == View::RoughnessMetallic; }
template<View V>
bool views(P p, N n) {
    return n.material && p.view == V;
}
bool toneMapped(P p, N n) {
    return p.toneMap != ToneMap::None && (p.program == Program::Sky || n.direct || n.ambient || n.emissive);
}

// Whether vectors are made unit that go into a highlight's width (README.md, Roots on VideoCore IV).
bool exactLengths(N n) {
    return n.lightForm == LightForm::PixelUnit || n.lightForm == LightForm::VertexWorld;
}
bool looseLengths(P p, N n) { return p.target == Target::Vc4 && !exactLengths(n); }
// Not the seed's, whose order of products was searched with the other form.
bool anglesByLogarithms(P p, N n) {
    return p.target == Target::Vc4 && p.brdf != Brdf::Seed && n.lightForm == LightForm::PixelUnit;
}
// Where it was found to pay (README.md, One division a light).
bool lobeByLogarithms(P p, N n) {
    const bool shorter =
        n.lightForm == LightForm::VertexTangent || (n.lightForm == LightForm::PixelUnit && n.reflection);
    return p.target == Target::Vc4 && p.brdf == Brdf::Gltf && shorter;
}
bool roots(P p, N n) {
    return n.lightForm == LightForm::PixelFew ||
           (n.lightForm == LightForm::PixelUnit && !anglesByLogarithms(p, n)) ||
           (n.direct && p.brdf == Brdf::Gltf);
}

constexpr std::array kSlots = {
    Slot{kVertex, needs<&Needs::material>, {{"position"}}},
    Slot{kVertex, is<&Permutation::program, Program::Overlay>, {{"overlay"}}},
    Slot{kVertex, is<&Permutation::program, Program::Sky>, {{"sky"}}},
    Slot{kVertex, needs<&Needs::uv0>, {{"uv0_transform", is<&Permutation::uv0Transform, true>}, {"uv0"}}},
    Slot{kVertex, needs<&Needs::uv1>, {{"uv1_transform", is<&Permutation::uv1Transform, true>}, {"uv1"}}},
    Slot{kVertex, coloured, {{"color"}}},
    Slot{kVertex, kNormal, {{"normal"}}},
    Slot{kVertex, normalVarying, {{"normal_varying"}}},
    Slot{kVertex,
         [](P, N n) { return n.toCamera || n.normalMap; },
         {{"world", needs<&Needs::toCamera>}, {"model"}}},
    Slot{kVertex, cameraVarying, {{"camera_varying"}}},
    Slot{kVertex, needs<&Needs::normalMap>, {{"tangent"}}},
    Slot{kVertex, needs<&Needs::normalMap>, {{"tangent_frame", kTangent}, {"tangent_varying"}}},
    Slot{kVertex, kTangent, {{"sun_tangent"}}, Each::Sun},
    Slot{kVertex, lights<LightForm::VertexWorld>, {{"sun_angles"}}},
    Slot{kVertex, lights<LightForm::VertexWorld>, {{"sun_angle"}}, Each::Sun},
    Slot{kVertex, lights<LightForm::VertexWorld>, {{"sun_fresnel"}}},

    Slot{kFragment, always, {{"precision"}}},
    Slot{kFragment, needs<&Needs::uv0>, {{"uv0_varying"}}},
    Slot{kFragment, needs<&Needs::uv1>, {{"uv1_varying"}}},
    Slot{kFragment, coloured, {{"color_varying"}}},
    Slot{kFragment, normalVarying, {{"normal_varying"}}},
    Slot{kFragment, cameraVarying, {{"camera_varying"}}},
    Slot{kFragment, is<&Permutation::program, Program::Sky>, {{"direction_varying"}}},

    Slot{kFragment, [](P p, N n) { return n.decode && p.decode == Decode::Exact; }, {{"decode_exact"}}},
    Slot{kFragment, roots, {{"root.vc4", kOnVc4}, {"root"}}},
    Slot{kFragment, kNormal, {{"inverse_root.vc4", looseLengths}, {"inverse_root"}}},
    Slot{kFragment,
         [](P p, N n) { return n.reflection || (n.direct && !lobeByLogarithms(p, n)); },
         {{"inverse.vc4", kOnVc4}, {"inverse"}}},

    Slot{kFragment,
         needs<&Needs::base>,
         {{"base_texture", is<&Permutation::baseColorTexture, true>, &Permutation::baseColorUv},
          {"base_factor"}}},
    Slot{kFragment,
         [](P p, N n) { return n.color && p.baseColorTexture && n.decode && p.decode == Decode::Exact; },
         {{"base_decode"}}},
    Slot{kFragment, texturedBase, {{"base_cubic", cubic}, {"base_tint"}}},
    Slot{kFragment,
         [](P p, N n) { return texturedBase(p, n) && cubic(p, n) && p.alpha != Alpha::Opaque; },
         {{"base_alpha"}}},
    Slot{kFragment, coloured, {{"base_color"}}},
    Slot{kFragment, [](P p, N n) { return n.material && p.alpha == Alpha::Mask; }, {{"mask"}}},

    Slot{kFragment,
         kNormal,
         {{"normal_tangent", kTangent, &Permutation::normalUv},
          {"normal_map.few", [](P, N n) { return n.normalMap && n.lightForm == LightForm::PixelFew; },
           &Permutation::normalUv},
          {"normal_map", needs<&Needs::normalMap>, &Permutation::normalUv},
          {"normal_vertex.few", kFew},
          {"normal_vertex"}}},
    Slot{kFragment,
         needs<&Needs::turned>,
         {{"double_sided.facing", is<&Permutation::facingWorkaround, true>}, {"double_sided"}}},

    Slot{kFragment,
         [](P p, N n) { return packed(p) && (n.metallic || n.roughness || packedOcclusion(p, n)); },
         {{"orm", always, &Permutation::metallicRoughnessUv}}},
    Slot{kFragment,
         [](P p, N n) { return (n.textured && (n.metallic || n.roughness)) || looked(p, n); },
         {{"metallic_roughness"}}},
    Slot{kFragment,
         [](P p, N n) { return n.metallic && (n.textured || looked(p, n)); },
         {{"metallic_packed", is<&Permutation::metallicRoughness, MetallicRoughness::Packed>},
          {"metallic_separate", kTextured, &Permutation::metallicRoughnessUv},
          {"metallic_factor"}}},
    Slot{kFragment,
         [](P p, N n) { return n.roughness && (n.textured || looked(p, n)); },
         {{"roughness_packed", is<&Permutation::metallicRoughness, MetallicRoughness::Packed>},
          {"roughness_separate", kTextured, &Permutation::metallicRoughnessUv},
          {"roughness_factor"}}},
    // A packed occlusion waits where the sky is reflected: see below.
    Slot{kFragment,
         [](P p, N n) { return n.occlusion && !(packedOcclusion(p, n) && n.reflection); },
         {{"occlusion_packed", packedOcclusion}, {"occlusion", always, &Permutation::occlusionUv}}},

    Slot{kFragment, kReflected, {{"sky_irradiance"}}},
    Slot{kFragment, kDirect, {{"surface.seed", kSeed}, {"surface"}}},
    Slot{kFragment,
         kDirect,
         {{"gltf.vc4", lobeByLogarithms},
          {"gltf", is<&Permutation::brdf, Brdf::Gltf>},
          {"seed", kSeed},
          {"fast", is<&Permutation::brdf, Brdf::Fast>},
          {"schlick"}}},
    Slot{kFragment,
         kDirect,
         {{"add_light.seed.reflection", [](P p, N n) { return p.brdf == Brdf::Seed && n.reflection; }},
          {"add_light.seed", kSeed},
          {"add_light.reflection", kReflected},
          {"add_light"}}},
    Slot{kFragment,
         [](P, N n) { return n.material && n.shaded && n.metallic && !n.textured; },
         {{"reflectance_uniform"}}},
    Slot{kFragment,
         kDirect,
         {{"surface_factors.seed", [](P p, N n) { return !n.textured && p.brdf == Brdf::Seed; }},
          {"surface_factors", [](P, N n) { return !n.textured; }},
          {"surface_gltf.texture", is<&Permutation::brdf, Brdf::Gltf>},
          {"surface_seed.texture", kSeed},
          {"surface_fast.texture", is<&Permutation::brdf, Brdf::Fast>},
          {"surface_schlick.texture"}}},

    Slot{kFragment,
         [](P, N n) { return (n.direct || n.ambient) && !n.reflection; },
         {{"ambient_sky", needs<&Needs::skyLit>}, {"ambient_color", needs<&Needs::ambient>}, {"dark"}}},
    Slot{kFragment, kReflected, {{"sky_atlas"}}},
    Slot{kFragment,
         [](P, N n) { return n.skyLit && !n.reflection; },
         {{"sky_reflectance", kTextured}, {"sky_reflectance.factors"}}},
    Slot{kFragment, [](P, N n) { return n.ambient && n.occlusion && !n.reflection; }, {{"occlude"}}},
    Slot{kFragment, [](P, N n) { return n.direct && !n.reflection; }, {{"specular"}}},
    Slot{kFragment,
         [](P, N n) { return (n.direct || n.reflection) && !lightsPerVertex(n); },
         {{"eye.few.vc4", fewOnVc4}, {"eye.few", kFew}, {"eye"}}},
    Slot{kFragment,
         [](P, N n) { return n.direct && n.lightForm != LightForm::VertexTangent; },
         {{"angles.few.vc4", fewOnVc4},
          {"angles.few", kFew},
          {"angles.vc4", anglesByLogarithms},
          {"angles", lights<LightForm::PixelUnit>},
          {"sun_angles"}}},
    Slot{kFragment, kTangent, {{"sun_tangent_varyings"}}, Each::Sun},
    Slot{kFragment, kTangent, {{"tangent_angles"}}},
    Slot{kFragment, [](P, N n) { return n.reflection && lightsPerVertex(n); }, {{"eye_vertex"}}},
    Slot{kFragment, kReflected, {{"sky_specular", kTextured}, {"sky_specular.factors"}}},
    // Late: while the lookup is waited for, the packed texel takes a register already.
    Slot{kFragment, [](P p, N n) { return packedOcclusion(p, n) && n.reflection; }, {{"occlusion_packed"}}},
    Slot{kFragment, [](P, N n) { return n.reflection && n.occlusion; }, {{"occlude.reflection"}}},
    Slot{kFragment, kReflected, {{"sky_sum"}}},
    Slot{kFragment,
         kDirect,
         {{"sun.few.vc4", fewOnVc4},
          {"sun.few", kFew},
          {"sun_tangent", kTangent},
          {"sun_vertex.reflection",
           [](P, N n) { return n.lightForm == LightForm::VertexWorld && n.reflection; }},
          {"sun_vertex", lights<LightForm::VertexWorld>},
          {"sun.reflection", kReflected},
          {"sun"}},
         Each::Sun},
    Slot{kFragment, [](P p, N n) { return n.direct && p.punctualLights > 0; }, {{"punctual_point"}}},
    Slot{
        kFragment, [](P p, N n) { return n.direct && p.punctualLights > 0 && p.spots; }, {{"punctual_cone"}}},
    Slot{kFragment, kDirect, {{"punctual"}}, Each::Punctual},
    Slot{kFragment, [](P p, N n) { return n.direct && p.spots; }, {{"punctual_spot"}}, Each::Punctual},
    Slot{kFragment, kDirect, {{"punctual_add.reflection", kReflected}, {"punctual_add"}}, Each::Punctual},

    // What is shown. A sky's reflection has its sum already.
    Slot{kFragment,
         [](P, N n) { return !n.reflection; },
         {{"shade_sky", is<&Permutation::program, Program::Sky>},
          {"view_normal", views<View::Normal>},
          {"view_metallic_roughness", views<View::RoughnessMetallic>},
          {"view_occlusion", [](P p, N n) { return views<View::Occlusion>(p, n) && n.occlusion; }},
          {"view_unoccluded", views<View::Occlusion>},
          {"shade", kDirect},
          {"shade_ambient", needs<&Needs::ambient>},
          {"shade_black", [](P p, N n) { return n.material && n.shaded && p.shading == Shading::Lit; }},
          {"shade_unlit"}}},
    Slot{kFragment,
         needs<&Needs::emissive>,
         {{"emissive_factor", is<&Permutation::emissive, Emissive::Factor>},
          {"emissive_texture_linear", [](P, N n) { return !n.decode; }, &Permutation::emissiveUv},
          {"emissive_cubic", is<&Permutation::decode, Decode::Fast>, &Permutation::emissiveUv},
          {"emissive_texture", always, &Permutation::emissiveUv}}},

    Slot{kFragment,
         toneMapped,
         {{"tone_reinhard", is<&Permutation::toneMap, ToneMap::Reinhard>},
          {"tone_aces", is<&Permutation::toneMap, ToneMap::Aces>},
          {"tone_neutral"}}},
    Slot{kFragment, toneMapped, {{"tone_map"}}},
    Slot{kFragment,
         needs<&Needs::encode>,
         {{"encode_srgb", is<&Permutation::output, Output::Srgb>},
          {"encode_pow22", is<&Permutation::output, Output::Pow22>},
          // Not the background's, which it makes dearer.
          {"encode_srgb_fast.vc4", [](P p, N n) { return p.target == Target::Vc4 && n.material; }},
          {"encode_srgb_fast"}}},
    Slot{kFragment, needs<&Needs::encode>, {{"encode"}}},
    Slot{kFragment, is<&Permutation::dither, Dither::Ordered>, {{"dither"}}},
    Slot{kFragment,
         always,
         {{"write_blend", [](P p, N) { return p.program != Program::Sky && p.alpha == Alpha::Blend; }},
          {"write_opaque"}}},
};

constexpr std::size_t kSlotCount = kSlots.size();

// Where each slot's forms begin among all rows; the last is their number.
constexpr auto kFirstRow = [] {
    std::array<std::size_t, kSlotCount + 1> first{};
    for (std::size_t slot = 0; slot < kSlotCount; ++slot)
        first[slot + 1] = first[slot] + kSlots[slot].count;
    return first;
}();

constexpr auto kRows = [] {
    std::array<Row, kFirstRow[kSlotCount]> rows{};
    for (std::size_t slot = 0; slot < kSlotCount; ++slot)
        for (std::size_t form = 0; form < kSlots[slot].count; ++form)
            rows[kFirstRow[slot] + form] = {kSlots[slot].stage, kSlots[slot].forms[form].snippet,
                                            kSlots[slot].each, kSlots[slot].forms[form].uv};
    return rows;
}();
static_assert(kRows.size() <= kMaxRows);

// The slots of the vertex shader stand first.
constexpr std::size_t kVertexSlots = static_cast<std::size_t>(
    std::count_if(kSlots.begin(), kSlots.end(), [](const Slot& slot) { return slot.stage == kVertex; }));
static_assert(kSlots[kVertexSlots - 1].stage == kVertex);

template<std::size_t Index, std::size_t FormIndex>
void addForm(P p, N n, Outline& outline) {
    constexpr Form form = kSlots[Index].forms[FormIndex];
    constexpr std::size_t row = kFirstRow[Index] + FormIndex;
    if (form.when(p, n)) {
        outline.rows[row] = true;
        if constexpr (form.uv != nullptr)
            outline.readsUv1[row] = p.*form.uv == UvStream::Uv1;
    } else if constexpr (FormIndex + 1 < kSlots[Index].count) {
        addForm<Index, FormIndex + 1>(p, n, outline);
    }
}

template<std::size_t Index>
void addSlot(P p, N n, Outline& outline) {
    constexpr Slot slot = kSlots[Index];
    if (!slot.when(p, n) || repeats(p, slot.each) == 0)
        return;
    if constexpr (slot.each == Each::Sun)
        outline.suns = p.suns;
    if constexpr (slot.each == Each::Punctual)
        outline.punctualLights = p.punctualLights;
    addForm<Index, 0>(p, n, outline);
}

// Spelt out slot by slot: no loop and no calls are left, and canonicalising is mostly this.
template<std::size_t First, std::size_t... Index>
void addSlots(P p, N n, Outline& outline, std::index_sequence<Index...>) {
    (addSlot<First + Index>(p, n, outline), ...);
}

} // namespace

std::span<const Row> recipe() { return kRows; }

RowRange rowsOf(Stage stage) {
    constexpr std::size_t kVertexRows = kFirstRow[kVertexSlots];
    return stage == kVertex ? RowRange{0, kVertexRows} : RowRange{kVertexRows, kRows.size()};
}

Outline outline(const Permutation& p, Stage stage) {
    const Needs needs = needsOf(p);
    Outline result{};
    if (stage == kVertex)
        addSlots<0>(p, needs, result, std::make_index_sequence<kVertexSlots>());
    else
        addSlots<kVertexSlots>(p, needs, result, std::make_index_sequence<kSlotCount - kVertexSlots>());
    return result;
}

} // namespace franken
