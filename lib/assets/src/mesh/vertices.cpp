// SPDX-License-Identifier: MIT
#include "mesh/vertices.h"

#include <glm/geometric.hpp>

#include "franken/tangents.h"

namespace franken {

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
