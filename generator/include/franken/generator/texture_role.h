// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/permutation.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace FRANKEN_API franken {

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
    TextureRole role;
    std::string_view name;             ///< For messages: "base colour"
    std::string_view word;             ///< That asks for it in a permutation's name: "basecolor"
    std::string_view sampler;          ///< "uBaseColorTexture"
    std::size_t unit;                  ///< Fixed over all programs; below kTextureUnits
    UvStream Permutation::*stream;     ///< The choice of its texture coordinates; null where it has none
    bool (*there)(const Permutation&); ///< Whether the permutation has such a texture
    TextureContents contents;
    std::array<std::uint8_t, 4> defaultTexel; ///< What stands in for a missing texture, RGBA
    bool repeats;                             ///< Its coordinates leave 0-1; else it is clamped
    std::string_view
        gltf; ///< Where a material of a glTF file has it, a JSON pointer; empty for no such place
};

/// All roles, in the order of the enum.
std::span<const TextureRoleRow> textureRoles();

const TextureRoleRow& rowOf(TextureRole role);

/// Null for a name that is no sampler.
const TextureRoleRow* findTextureRole(std::string_view sampler);

/// A material's texture: it has a place in glTF, or stands for half of one that has.
constexpr bool isMaterials(TextureRole role) { return role < TextureRole::Skybox; }

/// The units of materials' textures are below it.
inline constexpr std::size_t kMaterialUnits = 6;

/// The units of all roles are below it.
inline constexpr std::size_t kUsedTextureUnits = 8;

/// How many roles are a material's.
inline constexpr std::size_t kMaterialRoles = static_cast<std::size_t>(TextureRole::Skybox);

} // namespace franken
