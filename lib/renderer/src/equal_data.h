// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/texture_role.h"
#include "franken/scene.h"

#include <cstddef>
#include <unordered_map>

// Finds data that is there already. Every byte is hashed, and compared where hashes are equal.
namespace franken {

struct GeometryHash {
    std::size_t operator()(const Primitive* primitive) const;
};
struct GeometryEqual {
    bool operator()(const Primitive* a, const Primitive* b) const;
};
/// By vertices and indices, whatever the material.
using MapOfGeometry = std::unordered_map<const Primitive*, std::size_t, GeometryHash, GeometryEqual>;

/// What the mips of a roughness texture hold of the normal map beside it.
struct Widening {
    std::size_t normals = kNone; ///< ScenePlan::textures; kNone: nothing.
    float scale = 0;             ///< Of the normal map.
    float factor = 0;            ///< Of roughness.
    std::size_t channel = 0;     ///< That holds roughness.

    static constexpr std::size_t kNone = ~std::size_t{0};
    bool operator==(const Widening&) const = default;
};

/// An image as a texture: GLES2 has no samplers apart from textures.
struct SampledImage {
    const Image* image;
    Texture sampling;
    TextureContents contents;
    Widening widening = {};
};
struct SampledImageHash {
    std::size_t operator()(const SampledImage& texture) const;
};
struct SampledImageEqual {
    bool operator()(const SampledImage& a, const SampledImage& b) const;
};
/// By pixels and sampling, whatever the image's name.
using MapOfSampledImages = std::unordered_map<SampledImage, std::size_t, SampledImageHash, SampledImageEqual>;

} // namespace franken
