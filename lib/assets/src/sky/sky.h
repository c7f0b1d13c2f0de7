// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "franken/environment.h"

namespace franken {

/// As readFile(), but fails with "sky.file".
Result<std::vector<std::uint8_t>> readSkyFile(const std::filesystem::path& path, std::size_t maxBytes);

/// A point on one side of a cube map: s to the right and t down, both -1 to 1 within the face.
struct FacePoint {
    int face; ///< 0-5: +X, -X, +Y, -Y, +Z, -Z
    glm::vec2 st;
};

/// The direction of a point in a face's plane (OpenGL ES 2.0, table 3.21), not normalised; with s or t
/// outside -1 to 1 it lies beyond the face's edge.
glm::vec3 faceDirection(int face, const glm::vec2& st);

/// Where a direction (any length but 0) leaves the cube.
FacePoint facePoint(const glm::vec3& direction);

/// The unit direction of a point in the sky's picture. x, y: texels; centres are at halves.
glm::vec3 texelDirection(const Environment& sky, float x, float y);

/// The solid angle of a texel, sr. All together make 4 pi.
double texelSolidAngle(const Environment& sky, int x, int y);

/// The sky as a cube, each texel the mean over its area.
Environment resampledToCube(const Environment& sky, int size);

/// The range of an encoding of these texels: the largest channel, or kMinSkyRange if that is more.
float rangeOf(std::span<const glm::vec3> texels);

/// Encodes texels as SkyCube says.
Image encodeRgbm(std::span<const glm::vec3> texels, int width, int height, float range);

} // namespace franken
