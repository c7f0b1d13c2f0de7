// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/permutation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace FRANKEN_API franken {

// Texture roles: all that is known of them, beside their words (choices.cpp) and their snippets (recipe.cpp).

/// What a texture is for. The first ones are a material's.
enum class TextureRole : std::uint8_t {
    BaseColor,
    Normal,
    MetallicRoughness,
    Metallic, ///< Where metalness and roughness have a texture each.
    Roughness,
    Occlusion,
    Emissive,
    Skybox,
    Reflection,
    ReflectionLookup,
};

/// What the colour channels of a texture hold. Alpha is always a number.
enum class TextureContents : std::uint8_t {
    Color,   ///< sRGB codes.
    Numbers, ///< 0 to 1.
    Normals, ///< Unit vectors, -1 to 1 as 0 to 255.
};

/// Texture units that roles can have: what VideoCore IV has. A GPU may have fewer (budget.h).
inline constexpr std::size_t kTextureUnits = 16;

/// All that is known of a role. Roles share a unit where no program has both.
struct TextureRoleRow {
    TextureRole role;                  ///< Its place in the table.
    std::string_view name;             ///< For messages: "base colour"
    std::string_view word;             ///< That asks for it in a permutation's name: "basecolor"
    std::string_view sampler;          ///< "uBaseColorTexture"
    std::size_t unit;                  ///< Fixed over all programs; below kTextureUnits
    UvStream Permutation::*stream;     ///< The choice of its texture coordinates; null where it has none
    bool (*there)(const Permutation&); ///< Whether the permutation has such a texture
    TextureContents contents;          ///< How texels are read.
    std::array<std::uint8_t, 4> defaultTexel; ///< What stands in for a missing texture, RGBA
    bool repeats;                             ///< Its coordinates leave 0-1; else it is clamped
    std::string_view
        gltf; ///< Where a material of a glTF file has it, a JSON pointer; empty for no such place
};

namespace roles {

/// Short names for the table below.
using P = const Permutation&;
using Texel = std::array<std::uint8_t, 4>;

inline constexpr Texel kWhite = {255, 255, 255, 255}; ///< Factors alone remain.
inline constexpr Texel kFlat = {128, 128, 255, 255};  ///< The normal (0, 0, 1).
inline constexpr Texel kBlack = {0, 0, 0, 0};         ///< Nothing shines.
inline constexpr Texel kLossless = {255, 0, 0, 0};    ///< A mirror: nothing is scattered between facets.

/// The table: textureRoles() returns it.
inline constexpr TextureRoleRow kRows[] = {
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
     [](P p) { return p.reflection != Reflection::None; }, TextureContents::Numbers, kLossless, false, ""},
};

} // namespace roles

/// All roles, in the order of the enum.
constexpr std::span<const TextureRoleRow> textureRoles() { return roles::kRows; }

/// Costs an index into the table.
constexpr const TextureRoleRow& rowOf(TextureRole role) {
    return textureRoles()[static_cast<std::size_t>(role)];
}

/// Null for a name that is no sampler.
constexpr const TextureRoleRow* findTextureRole(std::string_view sampler) {
    for (const TextureRoleRow& row : textureRoles())
        if (row.sampler == sampler)
            return &row;
    return nullptr;
}

/// A material's texture: it has a place in glTF, or stands for half of one that has.
constexpr bool isMaterials(TextureRole role) { return role < TextureRole::Skybox; }

/// How many roles are a material's.
inline constexpr std::size_t kMaterialRoles = static_cast<std::size_t>(TextureRole::Skybox);

/// The first role that has the unit; null where none has. Roles that share a unit are alike to samplers.
constexpr const TextureRoleRow* findRoleAt(std::size_t unit) {
    for (const TextureRoleRow& row : textureRoles())
        if (row.unit == unit)
            return &row;
    return nullptr;
}

/// Whether materials' textures are bound to the unit.
constexpr bool isMaterialsUnit(std::size_t unit) {
    const TextureRoleRow* const row = findRoleAt(unit);
    return row != nullptr && isMaterials(row->role);
}

/// The units of all roles are below it.
inline constexpr std::size_t kUsedTextureUnits =
    std::max_element(std::begin(roles::kRows), std::end(roles::kRows),
                     [](const TextureRoleRow& a, const TextureRoleRow& b) { return a.unit < b.unit; })
        ->unit +
    1;
static_assert(kUsedTextureUnits <= kTextureUnits);

namespace roles {

/// What holds for each row; checked when this header is compiled.
constexpr bool isSound(const TextureRoleRow& row) {
    const TextureRoleRow& first = *findRoleAt(row.unit);
    return &row == &rowOf(row.role) && isMaterials(row.role) == isMaterials(first.role) &&
           row.contents == first.contents && row.defaultTexel == first.defaultTexel;
}
static_assert(std::all_of(std::begin(kRows), std::end(kRows), isSound));

} // namespace roles

} // namespace franken
