// SPDX-License-Identifier: MIT
#pragma once

#include "franken/environment.h"
#include "franken/generator/texture_role.h"
#include "franken/image.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <vector>

namespace franken::gallery {

/// A vertex with all attributes that programs know.
struct Vertex {
    glm::vec3 position, normal;
    glm::vec4 tangent;
    glm::vec2 uv0, uv1; ///< The second stream has twice as many tiles.
    glm::vec4 color;
    glm::vec4 joints;  ///< Indices, the joint with the most weight first.
    glm::vec4 weights; ///< They add up to 1.
};

struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint16_t> indices;
};

/// Joints of the sphere, one above the other.
inline constexpr int kJoints = 5;

/// The height of a joint, from -1 to 1.
float heightOf(int joint);

/// A unit sphere around the origin, whose vertices so many joints move, 0 to 4. An open one has no cap, so
/// that its inner side is seen from above.
Mesh sphere(bool open, int influences);

/// A square from (-0.8, -0.8) to (0.8, 0.8), for overlays.
Mesh square();

/// What the texture of a material's role shows on it.
Image textureOf(TextureRole role);

/// An evening: blue above, orange at the horizon, dark ground, and a low sun.
Environment sky();

} // namespace franken::gallery
