// SPDX-License-Identifier: MIT
#include "franken/generator/texture_role.h"

#include <algorithm>

namespace franken {
namespace {

using P = const Permutation&;
using Texel = std::array<std::uint8_t, 4>;

constexpr Texel kWhite = {255, 255, 255, 255}; // Factors alone remain.
constexpr Texel kFlat = {128, 128, 255, 255};  // The normal (0, 0, 1).
constexpr Texel kBlack = {0, 0, 0, 0};         // Nothing shines, and nothing is reflected.

constexpr TextureRoleRow kRoles[] = {
    {TextureRole::BaseColor, "base colour", "basecolor", "uBaseColorTexture", 0, &Permutation::baseColorUv,
     [](P p) { return p.baseColorTexture; }, TextureContents::Color, kWhite, true,
     "/pbrMetallicRoughness/baseColorTexture"},
    {TextureRole::Normal, "normal", "normal", "uNormalTexture", 1, &Permutation::normalUv,
     [](P p) { return p.normal == Normal::Map; }, TextureContents::Normals, kFlat, true, "/normalTexture"},
    {TextureRole::MetallicRoughness, "metallic-roughness", "metalrough", "uMetallicRoughnessTexture", 2,
     &Permutation::metallicRoughnessUv, [](P p) { return p.metallicRoughness == MetallicRoughness::Packed; },
     TextureContents::Numbers, kWhite, true, "/pbrMetallicRoughness/metallicRoughnessTexture"},
    {TextureRole::Metallic, "metallic", "metalrough-separate", "uMetallicTexture", 2,
     &Permutation::metallicRoughnessUv,
     [](P p) { return p.metallicRoughness == MetallicRoughness::Separate; }, TextureContents::Numbers, kWhite,
     true, ""},
    {TextureRole::Roughness, "roughness", "metalrough-separate", "uRoughnessTexture", 3,
     &Permutation::metallicRoughnessUv,
     [](P p) { return p.metallicRoughness == MetallicRoughness::Separate; }, TextureContents::Numbers, kWhite,
     true, ""},
    {TextureRole::Occlusion, "occlusion", "occlusion", "uOcclusionTexture", 4, &Permutation::occlusionUv,
     [](P p) { return p.occlusion == Occlusion::Texture; }, TextureContents::Numbers, kWhite, true,
     "/occlusionTexture"},
    {TextureRole::Emissive, "emissive", "emissive", "uEmissiveTexture", 5, &Permutation::emissiveUv,
     [](P p) { return p.emissive == Emissive::Texture; }, TextureContents::Color, kWhite, true,
     "/emissiveTexture"},
    {TextureRole::Skybox, "skybox", "sky", "uSkyTexture", 6, nullptr,
     [](P p) { return p.program == Program::Sky; }, TextureContents::Numbers, kBlack, false, ""},
    {TextureRole::Reflection, "reflection", "reflection", "uReflectionTexture", 6, nullptr,
     [](P p) { return p.reflection != Reflection::None; }, TextureContents::Numbers, kBlack, false, ""},
    {TextureRole::ReflectionLookup, "reflection's lookup", "reflection", "uReflectionLookup", 7, nullptr,
     [](P p) { return p.reflection != Reflection::None; }, TextureContents::Numbers, kBlack, false, ""},
};

constexpr bool isSound(const TextureRoleRow& row) {
    const bool inOrder = &row - kRoles == static_cast<std::ptrdiff_t>(row.role);
    return inOrder && row.unit < kUsedTextureUnits && isMaterials(row.role) == (row.unit < kMaterialUnits);
}
static_assert(std::all_of(std::begin(kRoles), std::end(kRoles), isSound));
static_assert(kUsedTextureUnits <= kTextureUnits);

} // namespace

std::span<const TextureRoleRow> textureRoles() { return kRoles; }
const TextureRoleRow& rowOf(TextureRole role) { return kRoles[static_cast<std::size_t>(role)]; }

const TextureRoleRow* findTextureRole(std::string_view sampler) {
    for (const TextureRoleRow& row : kRoles)
        if (row.sampler == sampler)
            return &row;
    return nullptr;
}

} // namespace franken
