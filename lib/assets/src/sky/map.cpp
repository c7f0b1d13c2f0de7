// SPDX-License-Identifier: MIT
#include "sky/sky.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace franken {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

struct FaceAxes {
    glm::vec3 center, right, down;
};

constexpr FaceAxes kFaces[6] = {
    {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
    {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},   {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
    {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}},
};

const glm::vec3& texelAt(const Environment& sky, int x, int y) {
    return sky.texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(sky.width) +
                      static_cast<std::size_t>(x)];
}

/// x wraps around; beyond a pole comes the same row, half way round.
const glm::vec3& equirectTexel(const Environment& sky, int x, int y) {
    if (y < 0 || y >= sky.height) {
        y = y < 0 ? -1 - y : 2 * sky.height - 1 - y;
        x += sky.width / 2;
    }
    return texelAt(sky, (x % sky.width + sky.width) % sky.width, y);
}

/// A texel beyond the edge is the nearest one of the face that lies there.
const glm::vec3& cubeTexel(const Environment& sky, int face, int x, int y) {
    const int size = sky.width;
    if (x < 0 || y < 0 || x >= size || y >= size) {
        const glm::vec2 center(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
        const FacePoint point =
            facePoint(faceDirection(face, center * (2.0f / static_cast<float>(size)) - 1.0f));
        const glm::vec2 texel = (point.st + 1.0f) * (0.5f * static_cast<float>(size));
        face = point.face;
        x = std::clamp(static_cast<int>(texel.x), 0, size - 1);
        y = std::clamp(static_cast<int>(texel.y), 0, size - 1);
    }
    return texelAt(sky, x, face * size + y);
}

/// The mean of four neighbours around a point whose texel centres are at halves.
template<typename Texel>
glm::vec3 bilinear(const glm::vec2& point, const Texel& texel) {
    const glm::vec2 corner = glm::floor(point - 0.5f);
    const glm::vec2 weight = point - 0.5f - corner;
    const int x = static_cast<int>(corner.x), y = static_cast<int>(corner.y);
    return glm::mix(glm::mix(texel(x, y), texel(x + 1, y), weight.x),
                    glm::mix(texel(x, y + 1), texel(x + 1, y + 1), weight.x), weight.y);
}

/// The solid angle between the centre of a face and a point in it, seen from the cube's centre.
double cornerSolidAngle(double s, double t) { return std::atan2(s * t, std::sqrt(s * s + t * t + 1.0)); }

} // namespace

glm::vec3 faceDirection(int face, const glm::vec2& st) {
    const FaceAxes& axes = kFaces[face];
    return axes.center + axes.right * st.x + axes.down * st.y;
}

FacePoint facePoint(const glm::vec3& direction) {
    const glm::vec3 size = glm::abs(direction);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int face = 2 * axis + (direction[axis] < 0.0f ? 1 : 0);
    const FaceAxes& axes = kFaces[face];
    return {face, glm::vec2(glm::dot(direction, axes.right), glm::dot(direction, axes.down)) / size[axis]};
}

glm::vec3 texelDirection(const Environment& sky, float x, float y) {
    const float width = static_cast<float>(sky.width);
    if (sky.layout == Environment::Layout::Cube) {
        const int face = std::min(static_cast<int>(y / width), 5);
        const glm::vec2 point(x, y - static_cast<float>(face) * width);
        return glm::normalize(faceDirection(face, point * (2.0f / width) - 1.0f));
    }
    const float azimuth = (x / width - 0.5f) * 2.0f * kPi;
    const float polar = y / static_cast<float>(sky.height) * kPi;
    const float ring = std::sin(polar);
    return {ring * std::sin(azimuth), std::cos(polar), -ring * std::cos(azimuth)};
}

double texelSolidAngle(const Environment& sky, int x, int y) {
    if (sky.layout == Environment::Layout::Cube) {
        const double step = 2.0 / sky.width;
        const double s0 = x * step - 1.0, s1 = s0 + step;
        const double t0 = (y % sky.width) * step - 1.0, t1 = t0 + step;
        return cornerSolidAngle(s0, t0) - cornerSolidAngle(s1, t0) - cornerSolidAngle(s0, t1) +
               cornerSolidAngle(s1, t1);
    }
    const double step = std::numbers::pi / sky.height;
    return (std::cos(y * step) - std::cos((y + 1) * step)) * 2.0 * std::numbers::pi / sky.width;
}

glm::vec3 radianceFrom(const Environment& sky, const glm::vec3& direction) {
    assert(!sky.texels.empty());
    if (sky.layout == Environment::Layout::Cube) {
        const FacePoint point = facePoint(direction);
        return bilinear((point.st + 1.0f) * (0.5f * static_cast<float>(sky.width)),
                        [&](int x, int y) { return cubeTexel(sky, point.face, x, y); });
    }
    const glm::vec3 d = glm::normalize(direction);
    const float u = 0.5f + std::atan2(d.x, -d.z) / (2.0f * kPi);
    const float v = std::acos(glm::clamp(d.y, -1.0f, 1.0f)) / kPi;
    return bilinear(glm::vec2(u * static_cast<float>(sky.width), v * static_cast<float>(sky.height)),
                    [&](int x, int y) { return equirectTexel(sky, x, y); });
}

} // namespace franken
