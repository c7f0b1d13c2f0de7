// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "model.h"

namespace make_model {

/// A surface by two numbers, each from 0 to 1: u across, v along; metres.
using Shape = std::function<glm::dvec3(double u, double v)>;

/// What is not its shape: how a vertex is painted, and what holds it.
struct Held {
    glm::u8vec4 colour; ///< Linear, 255 = 1.
    glm::u8vec4 joints;
    glm::u8vec4 weights; ///< 255 = 1; they add up to 255.
};

/// Appends `rows` times `columns` quads of a surface; its front is where dS/dv x dS/du points: seen from
/// there with v downwards, u runs to the right. Normals are by differences of 1/1024 in u and v.
void appendSheet(Mesh& mesh, const Shape& shape, int rows, int columns,
                 const std::function<Held(double u, double v)>& held);

/// Appends to a target of the mesh what leads from a surface to another one of the same rows and columns.
void appendChange(Target& target, const Shape& from, const Shape& to, int rows, int columns);

/// A colour of 0 to 1 as bytes, and opaque.
glm::u8vec4 paint(glm::dvec3 linear);

/// One joint alone.
Held heldBy(int joint, glm::dvec3 colour);

/// Two joints, `share` of the second.
Held heldBy(int first, int second, double share, glm::dvec3 colour);

} // namespace make_model
