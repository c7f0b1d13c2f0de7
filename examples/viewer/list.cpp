// SPDX-License-Identifier: MIT
#include "list.h"

#include "franken/printable.h"

#include <array>
#include <cstdio>

using namespace franken;

namespace {

std::string line(const char* kind, std::size_t index, const std::string& name, const std::string& more = "") {
    return std::string(kind) + " " + std::to_string(index) + ": " +
           (name.empty() ? "(without a name)" : printableLines(name)) + (more.empty() ? "" : ", " + more) +
           "\n";
}

std::size_t trianglesOf(const Mesh& mesh) {
    std::size_t triangles = 0;
    for (const Primitive& primitive : mesh.primitives)
        triangles += primitive.indices.size() / 3;
    return triangles;
}

std::string toString(const glm::dvec3& vector) {
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), "%.6g %.6g %.6g", vector.x, vector.y, vector.z);
    return text.data();
}

const char* kindOf(const Light& light) {
    return light.kind == Light::Kind::Directional ? "sun"
           : light.kind == Light::Kind::Point     ? "point"
                                                  : "spot";
}

} // namespace

std::string listOf(const Scene& scene) {
    std::string list;
    for (const Camera& camera : scene.cameras)
        list += line("camera", static_cast<std::size_t>(camera.index), camera.name,
                     camera.node.empty() ? "" : "on node " + printableLines(camera.node));
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        list += line("light", i, scene.lights[i].name, kindOf(scene.lights[i]));
    for (std::size_t i = 0; i < scene.variants.size(); ++i)
        list += line("variant", i, scene.variants[i]);
    for (const Animation& animation : scene.animations)
        list += line("animation", static_cast<std::size_t>(animation.index), animation.name,
                     std::to_string(animation.duration) + " s");
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
        list += line("material", i, scene.materials[i].name);
    for (std::size_t i = 0; i < scene.images.size(); ++i)
        list += line("image", i, scene.images[i].name,
                     std::to_string(scene.images[i].width) + "x" + std::to_string(scene.images[i].height));
    for (std::size_t i = 0; i < scene.instances.size(); ++i)
        list += line(
            "node", i, scene.instances[i].name,
            std::to_string(trianglesOf(scene.meshes[static_cast<std::size_t>(scene.instances[i].mesh)])) +
                " triangles");
    return list;
}

std::string listOf(const Scene& scene, const std::optional<Hit>& hit) {
    if (!hit)
        return "nothing\n";
    const auto node = static_cast<std::size_t>(hit->instance),
               material = static_cast<std::size_t>(hit->material);
    return line("node", node, scene.instances[node].name) +
           line("material", material, scene.materials[material].name) + "primitive " +
           std::to_string(hit->primitive) + ", triangle " + std::to_string(hit->triangle) + ", at " +
           toString(hit->barycentric) + "\npoint " + toString(hit->point) + "\n";
}
