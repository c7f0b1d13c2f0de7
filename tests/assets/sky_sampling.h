// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "franken/environment.h"

/// Brute force for the tests of skies: slow, plain, and written apart from the library.
namespace franken::test {

/// `count` directions, evenly over the sphere (a Fibonacci spiral).
std::vector<glm::vec3> directions(int count);

/// The direction of a texel's centre in a picture that is twice as wide as high.
glm::vec3 equirectDirection(int width, int x, int y);

/// The unit direction of a texel's centre in a face of a cube map (OpenGL ES 2.0, table 3.21).
glm::vec3 faceTexelDirection(int size, int face, int x, int y);

/// Scales an equirectangular sky so that its mean luminance over the sphere is `mean`.
void expose(Environment& sky, float mean);

/// An equirectangular file without its sun, exposed so that a white surface is 0.5 in the mean.
Result<Environment> loadExposed(const std::filesystem::path& file);

/// A right-handed frame around z, turned about it by `angle` radians.
struct Frame {
    Frame(const glm::vec3& normal, float angle);
    glm::vec3 toWorld(const glm::vec3& local) const { return x * local.x + y * local.y + z * local.z; }

    glm::vec3 x, y, z;
};

/// How much of a white sky glTF's specular BRDF reflects: F0's factor and the rest.
glm::vec2 whiteSky(float nDotV, float roughness, int samples);

/// The sky's light off a surface: what F0 multiplies, and the rest.
struct Reflected {
    glm::vec3 byF0{0}, besides{0};
};

/// By glTF's specular BRDF; the eye lies towards +X of the frame.
Reflected reflected(const Environment& sky, const Frame& frame, float nDotV, float roughness);

struct Hit {
    glm::vec3 normal, toCamera;
};

/// Where the ray of a pixel meets the unit sphere, as ../shared/reference/sky has it: camera at (0, 0, 4), a
/// vertical angle of 40 degrees.
std::optional<Hit> hitSphere(int x, int y, int size);

/// A PNG; empty if it cannot be read.
Image readImage(const std::filesystem::path& path);

} // namespace franken::test
