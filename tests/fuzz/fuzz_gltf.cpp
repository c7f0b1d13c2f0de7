// SPDX-License-Identifier: MIT
// Any bytes as a model: a scene in which all indices are in range, or an error with a known code and a place.
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "franken/gltf.h"
#include "require.h"

namespace {

using namespace franken;

constexpr std::array<std::string_view, 13> kCodes{
    "gltf.buffer",    "gltf.container",    "gltf.json",   "gltf.schema", "gltf.version",
    "gltf.extension", "gltf.index-range",  "gltf.bounds", "gltf.type",   "gltf.value",
    "gltf.node-tree", "gltf.vertex-range", "gltf.limit"};

void check(const Primitive& primitive, const Scene& scene) {
    const std::size_t count = primitive.positions.size();
    require(static_cast<std::size_t>(primitive.material) < scene.materials.size(), "a material");
    require(primitive.indices.size() % 3 == 0, "whole triangles");
    require(std::all_of(primitive.indices.begin(), primitive.indices.end(),
                        [&](std::uint32_t i) { return i < count; }),
            "indices below the vertex count");
    require(primitive.normals.size() == count, "a normal for each vertex");
    for (const std::size_t size :
         {primitive.tangents.size(), primitive.uv[0].size(), primitive.uv[1].size(), primitive.colors.size()})
        require(size == 0 || size == count, "an attribute for each vertex, or none");
    for (const glm::vec3& position : primitive.positions)
        require(std::isfinite(position.x) && std::isfinite(position.y) && std::isfinite(position.z),
                "finite positions");
}

void check(const Scene& scene) {
    for (const Mesh& mesh : scene.meshes)
        for (const Primitive& primitive : mesh.primitives)
            check(primitive, scene);
    for (const Instance& instance : scene.instances)
        require(static_cast<std::size_t>(instance.mesh) < scene.meshes.size(), "a mesh");
    for (const Texture& texture : scene.textures)
        require(texture.image == -1 || static_cast<std::size_t>(texture.image) < scene.images.size(),
                "an image");
    for (const Material& material : scene.materials)
        for (const TextureRef& ref : material.textures)
            require(!ref || static_cast<std::size_t>(ref.texture) < scene.textures.size(), "a texture");
    for (const Image& image : scene.images)
        require(image.rgba.size() ==
                    std::size_t{4} * static_cast<unsigned>(image.width) * static_cast<unsigned>(image.height),
                "all pixels");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    // Small limits, so that it tries many files and not few large ones.
    const LoadOptions options{
        .maxFileBytes = std::size_t{1} << 20, .maxMemoryBytes = std::size_t{32} << 20, .maxImageSize = 512};
    const auto scene = loadGltf({data, size}, "input", options, [](LogLevel, std::string_view) {});
    if (scene) {
        check(*scene);
        return 0;
    }
    const Error& error = scene.error();
    require(std::find(kCodes.begin(), kCodes.end(), error.code) != kCodes.end(), "a documented code");
    require(error.where.starts_with("input"), "a place");
    require(!error.what.starts_with("the parser"), "tinygltf refuses nothing that the gate lets through");
    const bool aboutAll = error.code == "gltf.json" || error.code == "gltf.container" ||
                          error.code == "gltf.version" || error.code == "gltf.limit";
    require(aboutAll || error.where.find(": /") != std::string::npos, "a JSON path");
    return 0;
}
