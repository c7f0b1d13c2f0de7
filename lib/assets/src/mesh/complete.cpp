// SPDX-License-Identifier: MIT
#include "franken/complete.h"

#include "franken/pose.h"
#include "franken/scene_check.h"
#include "franken/tangents.h"
#include "mesh/vertices.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

namespace franken {
namespace {

template<typename Function>
void eachPrimitive(Scene& scene, Function function) {
    for (Mesh& mesh : scene.meshes)
        for (Primitive& primitive : mesh.primitives)
            function(primitive);
}

void giveMaterials(Scene& scene) {
    const bool none = scene.materials.empty();
    int added = kNone;
    eachPrimitive(scene, [&](Primitive& primitive) {
        if (primitive.material != kNone && !(none && primitive.material == 0))
            return;
        if (added == kNone) {
            added = static_cast<int>(scene.materials.size());
            scene.materials.emplace_back();
        }
        primitive.material = added;
    });
}

void giveIndices(Scene& scene) {
    eachPrimitive(scene, [](Primitive& primitive) {
        if (!primitive.indices.empty())
            return;
        primitive.indices.resize(primitive.positions.size());
        std::iota(primitive.indices.begin(), primitive.indices.end(), 0u);
    });
}

/// Stands in until the rest is known to be sound; which ones had none.
std::vector<const Primitive*> giveAnyNormals(Scene& scene) {
    std::vector<const Primitive*> given;
    eachPrimitive(scene, [&](Primitive& primitive) {
        if (!primitive.normals.empty())
            return;
        primitive.normals.assign(primitive.positions.size(), {0, 0, 1});
        given.push_back(&primitive);
    });
    return given;
}

/// Of the first of its materials that has one.
const TextureRef* normalTextureOf(const Scene& scene, const Primitive& primitive) {
    const auto of = [&](int material) {
        const TextureRef& texture =
            scene.materials[static_cast<std::size_t>(material)].textures[TextureRole::Normal];
        return texture ? &texture : nullptr;
    };
    const TextureRef* texture = of(primitive.material);
    for (const int material : primitive.variantMaterials)
        if (texture == nullptr && material != kNone)
            texture = of(material);
    return texture;
}

/// Deformations that say what moves the vertices, and leave it to the arrays what they are before.
std::vector<const Primitive*> giveAnyBinds(Scene& scene) {
    std::vector<const Primitive*> given;
    eachPrimitive(scene, [&](Primitive& primitive) {
        if (!primitive.deformation || !primitive.deformation->bind.positions.empty())
            return;
        auto deformation = std::make_shared<Deformation>(*primitive.deformation);
        deformation->bind = bindOf(primitive);
        primitive.deformation = std::move(deformation);
        given.push_back(&primitive);
    });
    return given;
}

void turnToNormals(Primitive& primitive) {
    for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
        std::uint32_t* const corner = primitive.indices.data() + i;
        const auto position = [&](int n) { return glm::dvec3(primitive.positions[corner[n]]); };
        const glm::dvec3 front = glm::cross(position(1) - position(0), position(2) - position(0));
        const auto isBehind = [&](std::uint32_t vertex) {
            return glm::dot(front, glm::dvec3(primitive.normals[vertex])) < 0;
        };
        if (std::all_of(corner, corner + 3, isBehind))
            std::swap(corner[1], corner[2]);
    }
}

} // namespace

Result<Scene> complete(Scene scene, Normals normals) {
    giveMaterials(scene);
    giveIndices(scene);
    const std::vector<const Primitive*> withoutNormals = giveAnyNormals(scene);
    const std::vector<const Primitive*> withoutBinds = giveAnyBinds(scene);
    if (Result<void> checked = check(scene); !checked)
        return checked.error();
    eachPrimitive(scene, [&](Primitive& primitive) {
        const bool hasNone =
            std::find(withoutNormals.begin(), withoutNormals.end(), &primitive) != withoutNormals.end();
        if (hasNone)
            normals == Normals::Smooth ? computeSmoothNormals(primitive) : computeFlatNormals(primitive);
        for (glm::vec3& normal : primitive.normals)
            normal = unitOr(normal, normal); // check() has seen that each has a length.
        turnToNormals(primitive);
        if (const TextureRef* const normalTexture = normalTextureOf(scene, primitive))
            fillTangents(primitive, *normalTexture);
        primitive.bounds = boundsOf(primitive.positions);
        if (std::find(withoutBinds.begin(), withoutBinds.end(), &primitive) != withoutBinds.end())
            bind(primitive);
    });
    for (Instance& instance : scene.instances)
        instance.mirrored = glm::determinant(glm::dmat3(instance.world)) < 0;
    if (!withoutBinds.empty())
        if (Result<void> posed = applyPose(scene, restPose(scene)); !posed)
            return posed.error();
    return scene;
}

} // namespace franken
