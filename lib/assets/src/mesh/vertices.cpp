// SPDX-License-Identifier: MIT
#include "mesh/vertices.h"

#include <glm/geometric.hpp>

#include "franken/tangents.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace franken {
namespace {

/// `each` elements belong to a vertex.
template<typename T>
void gather(std::vector<T>& attribute, std::span<const std::uint32_t> vertices, std::size_t each = 1) {
    if (attribute.empty())
        return;
    std::vector<T> gathered;
    gathered.reserve(vertices.size() * each);
    for (const std::uint32_t vertex : vertices)
        for (std::size_t i = 0; i < each; ++i)
            gathered.push_back(attribute[vertex * each + i]);
    attribute = std::move(gathered);
}

template<typename Arrays>
void gatherArrays(Arrays& arrays, std::span<const std::uint32_t> vertices) {
    gather(arrays.positions, vertices);
    gather(arrays.normals, vertices);
    gather(arrays.tangents, vertices);
    gather(arrays.uv[0], vertices);
    gather(arrays.uv[1], vertices);
    gather(arrays.colors, vertices);
}

} // namespace

void gather(Primitive& primitive, std::span<const std::uint32_t> vertices) {
    gatherArrays(primitive, vertices);
    if (!primitive.deformation)
        return;
    auto deformation = std::make_shared<Deformation>(*primitive.deformation);
    gatherArrays(deformation->bind, vertices);
    for (Vertices& target : deformation->targets)
        gatherArrays(target, vertices);
    gather(deformation->influences, vertices, deformation->influencesPerVertex);
    primitive.deformation = std::move(deformation);
}

Vertices bindOf(const Primitive& primitive) {
    const std::vector<Vertices>& targets = primitive.deformation->targets;
    const auto anyTarget = [&](auto member) {
        return std::any_of(targets.begin(), targets.end(),
                           [&](const Vertices& target) { return !member(target).empty(); });
    };
    Vertices vertices{
        .positions = primitive.positions, .normals = primitive.normals, .tangents = primitive.tangents};
    for (std::size_t set = 0; set < std::size(vertices.uv); ++set)
        if (anyTarget([set](const Vertices& target) -> auto& { return target.uv[set]; }))
            vertices.uv[set] = primitive.uv[set];
    if (anyTarget([](const Vertices& target) -> auto& { return target.colors; }))
        vertices.colors = primitive.colors;
    return vertices;
}

void bind(Primitive& primitive) {
    Deformation deformation = *primitive.deformation;
    deformation.bind = bindOf(primitive);
    measure(deformation);
    primitive.deformation = std::make_shared<const Deformation>(std::move(deformation));
}

Box boundsOf(const std::vector<glm::vec3>& positions) {
    Box bounds;
    for (const glm::vec3& position : positions)
        bounds.add(position);
    return bounds;
}

glm::vec3 unitOr(const glm::vec3& vector, const glm::vec3& otherwise) {
    const glm::dvec3 exact(vector); // whose square no float under- or overflows
    const double length = glm::length(exact);
    return length > 0.0 ? glm::vec3(exact / length) : otherwise;
}

bool fillTangents(Primitive& primitive, const TextureRef& normalTexture) {
    if (!primitive.tangents.empty())
        return true;
    const std::vector<glm::vec2> uv = sampledUv(primitive, normalTexture);
    if (!uv.empty())
        computeTangents(primitive, uv);
    return !uv.empty();
}

} // namespace franken
