// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
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

/// Radiance at a point of the sky's picture, between its four nearest texels. point: texels; their centres
/// are at halves.
glm::vec3 radianceAt(const Environment& sky, const glm::vec2& point);

/// Of a part of the sky: the middle in its picture (texels), the unit direction and the solid angle (sr).
using VisitPart = std::function<void(const glm::vec2& point, const glm::vec3& direction, double solidAngle)>;

/// Visits all texels, each cut into `parts` times `parts`. Their solid angles make 4 pi.
void forEachPart(const Environment& sky, int parts, const VisitPart& visit);

/// The sky as a cube, each texel the mean over its area.
Environment resampledToCube(const Environment& sky, int size);

/// The range of an encoding of these texels of a sky with that mean radiance, as SkyboxMap says.
float rangeOf(std::span<const glm::vec3> texels, const glm::vec3& mean);

/// Encodes texels as SkyboxMap says.
Image encodeRgbm(std::span<const glm::vec3> texels, int width, int height, float range);

} // namespace franken
