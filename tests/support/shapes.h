// SPDX-License-Identifier: MIT
#pragma once

#include "franken/scene.h"

#include <functional>

namespace franken::test {

/// A unit sphere with normals, tangents and one UV stream (u to the east, v from the north pole down), of
/// 2 * rings by rings quads.
Primitive sphere(int rings);

/// A square of 2 x 2 in the plane z = 0 that faces +Z, with the same attributes; v grows downwards.
Primitive square();

/// A colour as materials have it.
inline Float4 toFloat4(const glm::vec4& color) { return {color.r, color.g, color.b, color.a}; }

/// A picture of that size, from texture coordinates (0 to 1, v down) to 0..1.
Image paint(int size, const std::function<glm::vec4(glm::vec2)>& color);

/// Squares of two colours, so many along each side.
Image checkers(int size, int count, const glm::vec4& even, const glm::vec4& odd);

/// A normal map of round bumps, so many along each side.
Image bumps(int size, int count);

/// Puts things into a scene that begins empty.
class SceneBuilder {
public:
    int addTexture(Image image, Filter minFilter = Filter::LinearMipmapLinear, Wrap wrap = Wrap::Repeat);
    int addMaterial(const Material& material);
    /// The primitive with that material, in a mesh and an instance of its own.
    void add(Primitive primitive, int material, const glm::mat4& world = glm::mat4(1));
    void addSun(const glm::vec3& direction, const glm::vec3& color, float lux);

    Scene scene;
};

/// Tiles of colour, bumps, and roughness by a texture, each wrapped in another way. The textures are added to
/// the scene; the material is not.
Material tiledMaterial(SceneBuilder& builder);

} // namespace franken::test
