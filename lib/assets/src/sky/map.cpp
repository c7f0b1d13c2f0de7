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

void visitEquirect(const Environment& sky, int parts, const VisitPart& visit) {
    const int width = sky.width * parts, height = sky.height * parts;
    const float part = 1.0f / static_cast<float>(parts);
    std::vector<glm::vec2> columns; // x and z on the horizon
    for (int x = 0; x < width; ++x) {
        const double azimuth = ((x + 0.5) / width - 0.5) * 2.0 * std::numbers::pi;
        columns.emplace_back(std::sin(azimuth), -std::cos(azimuth));
    }
    const double step = std::numbers::pi / height;
    for (int y = 0; y < height; ++y) {
        const double solidAngle =
            (std::cos(y * step) - std::cos((y + 1) * step)) * 2.0 * std::numbers::pi / width;
        const float ring = static_cast<float>(std::sin((y + 0.5) * step));
        const float up = static_cast<float>(std::cos((y + 0.5) * step));
        for (int x = 0; x < width; ++x) {
            const glm::vec2 around = ring * columns[static_cast<std::size_t>(x)];
            visit((glm::vec2(x, y) + 0.5f) * part, {around.x, up, around.y}, solidAngle);
        }
    }
}

void visitCube(const Environment& sky, int parts, const VisitPart& visit) {
    const int size = sky.width * parts;
    const double step = 2.0 / size;
    const float part = 1.0f / static_cast<float>(parts);
    std::vector<double> above(static_cast<std::size_t>(size) + 1), below = above; // solid angles to corners
    const auto fill = [&](std::vector<double>& corners, int y) {
        for (int x = 0; x <= size; ++x)
            corners[static_cast<std::size_t>(x)] = cornerSolidAngle(x * step - 1.0, y * step - 1.0);
    };
    fill(below, 0);
    for (int y = 0; y < size; ++y) {
        above.swap(below);
        fill(below, y + 1);
        for (int x = 0; x < size; ++x) {
            const std::size_t i = static_cast<std::size_t>(x);
            const double solidAngle = above[i] - above[i + 1] - below[i] + below[i + 1];
            const glm::vec2 point = glm::vec2(x, y) + 0.5f;
            for (int face = 0; face < 6; ++face)
                visit(point * part + glm::vec2(0, face * sky.width),
                      glm::normalize(faceDirection(face, point * static_cast<float>(step) - 1.0f)),
                      solidAngle);
        }
    }
}

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

void forEachPart(const Environment& sky, int parts, const VisitPart& visit) {
    sky.layout == Environment::Layout::Cube ? visitCube(sky, parts, visit) : visitEquirect(sky, parts, visit);
}

glm::vec3 radianceAt(const Environment& sky, const glm::vec2& point) {
    if (sky.layout == Environment::Layout::Equirect)
        return bilinear(point, [&](int x, int y) { return equirectTexel(sky, x, y); });
    const int face = std::min(static_cast<int>(point.y) / sky.width, 5);
    return bilinear(point - glm::vec2(0, face * sky.width),
                    [&](int x, int y) { return cubeTexel(sky, face, x, y); });
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
    return radianceAt(sky, {u * static_cast<float>(sky.width), v * static_cast<float>(sky.height)});
}

} // namespace franken
