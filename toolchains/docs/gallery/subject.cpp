// SPDX-License-Identifier: MIT
#include "subject.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

namespace franken::gallery {
namespace {

constexpr int kRings = 48;
constexpr int kSize = 512; // Of textures, texels.

std::uint8_t toByte(float value) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0f, 1.0f)));
}

Image paint(const std::function<glm::vec4(glm::vec2)>& color) {
    Image image{"", kSize, kSize, {}};
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const glm::vec4 texel = color((glm::vec2(x, y) + 0.5f) / static_cast<float>(kSize));
            for (int channel = 0; channel < 4; ++channel)
                image.rgba.push_back(toByte(texel[channel]));
        }
    return image;
}

/// The sphere is covered with tiles, this many around it; half as many from pole to pole.
constexpr glm::vec2 kTiles = {12, 6};

/// Where a point lies in its tile, from -1 to 1.
glm::vec2 inTile(glm::vec2 uv) { return 2.0f * glm::fract(uv * kTiles) - 1.0f; }

bool isOdd(glm::vec2 uv) {
    const glm::vec2 tile = glm::floor(uv * kTiles);
    return static_cast<int>(tile.x + tile.y) % 2 != 0;
}

/// A boss in the middle of each tile, of that height over its tile.
float heightAt(glm::vec2 uv) {
    const float distance = glm::length(inTile(uv));
    return 1 - glm::smoothstep(0.45f, 0.85f, distance);
}

bool isGilded(glm::vec2 uv) { return isOdd(uv) && glm::length(inTile(uv)) < 0.6f; }

glm::vec4 baseColorAt(glm::vec2 uv) {
    const float alpha = isOdd(uv) ? 1 : 0.3f;
    if (isGilded(uv))
        return {0.95f, 0.75f, 0.35f, alpha};
    return isOdd(uv) ? glm::vec4(0.10f, 0.36f, 0.62f, alpha) : glm::vec4(0.92f, 0.88f, 0.80f, alpha);
}

/// Red points along u, green against v, as in glTF.
glm::vec4 normalAt(glm::vec2 uv) {
    constexpr float kStep = 0.5f / kSize, kDepth = 0.012f;
    const float dx = heightAt(uv + glm::vec2(kStep, 0)) - heightAt(uv - glm::vec2(kStep, 0));
    const float dy = heightAt(uv + glm::vec2(0, kStep)) - heightAt(uv - glm::vec2(0, kStep));
    const glm::vec3 normal = glm::normalize(glm::vec3(-dx, dy, 2 * kStep / kDepth / 6));
    return glm::vec4(0.5f * normal + 0.5f, 1);
}

/// The boss's foot is in its own shadow.
float occlusionAt(glm::vec2 uv) {
    const float foot = (glm::length(inTile(uv)) - 0.75f) / 0.25f;
    return 1 - 0.9f * std::exp(-foot * foot);
}

float roughnessAt(glm::vec2 uv) { return isGilded(uv) ? 0.25f : isOdd(uv) ? 0.15f : 0.7f; }

/// glTF's packing: occlusion, roughness, metalness.
glm::vec4 packedAt(glm::vec2 uv) { return {occlusionAt(uv), roughnessAt(uv), isGilded(uv) ? 1 : 0, 1}; }

glm::vec4 emissiveAt(glm::vec2 uv) {
    const float glow = isGilded(uv) ? glm::smoothstep(0.5f, 0.2f, glm::length(inTile(uv))) : 0;
    return glm::vec4(glm::vec3(1.0f, 0.45f, 0.1f) * glow, 1);
}

/// The joints that are nearest to a height, and their weights: tents over two heights of joints.
void bind(Vertex& vertex, int influences) {
    std::array<int, kJoints> order{};
    std::iota(order.begin(), order.end(), 0);
    const auto distance = [&](int joint) { return std::abs(vertex.position.y - heightOf(joint)); };
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return distance(a) < distance(b); });
    float sum = 0;
    for (int i = 0; i < std::max(influences, 1); ++i) {
        vertex.joints[i] = static_cast<float>(order[static_cast<std::size_t>(i)]);
        vertex.weights[i] = std::max(1 - distance(order[static_cast<std::size_t>(i)]), 0.01f);
        sum += vertex.weights[i];
    }
    vertex.weights /= sum;
}

Vertex vertexAt(glm::vec2 uv, float top, int influences) {
    const float longitude = glm::two_pi<float>() * uv.x, polar = glm::mix(top, glm::pi<float>(), uv.y);
    Vertex vertex{};
    vertex.normal = {std::sin(polar) * std::sin(longitude), std::cos(polar),
                     std::sin(polar) * std::cos(longitude)};
    vertex.position = vertex.normal;
    vertex.tangent = {std::cos(longitude), 0, -std::sin(longitude), 1};
    vertex.uv0 = {uv.x, polar / glm::pi<float>()};
    vertex.uv1 = 2.0f * vertex.uv0;
    vertex.color = glm::vec4(glm::mix(glm::vec3(1.0f, 0.35f, 0.25f), glm::vec3(0.35f, 1.0f, 0.55f),
                                      0.5f + 0.5f * vertex.position.y),
                             1);
    bind(vertex, influences);
    return vertex;
}

/// Two triangles for each square of a grid with so many columns.
std::vector<std::uint16_t> gridIndices(int rows, int columns) {
    std::vector<std::uint16_t> indices;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const int a = row * (columns + 1) + column, below = a + columns + 1;
            for (const int corner : {a, below, below + 1, a, below + 1, a + 1})
                indices.push_back(static_cast<std::uint16_t>(corner));
        }
    return indices;
}

} // namespace

float heightOf(int joint) { return 2.0f * static_cast<float>(joint) / (kJoints - 1) - 1; }

Mesh sphere(bool open, int influences) {
    constexpr float kOpening = 0.8f; // Radians from the pole.
    Mesh mesh;
    for (int row = 0; row <= kRings; ++row)
        for (int column = 0; column <= 2 * kRings; ++column)
            mesh.vertices.push_back(
                vertexAt({static_cast<float>(column) / (2 * kRings), static_cast<float>(row) / kRings},
                         open ? kOpening : 0, influences));
    mesh.indices = gridIndices(kRings, 2 * kRings);
    return mesh;
}

Mesh square() {
    Mesh mesh;
    for (const float y : {0.8f, -0.8f})
        for (const float x : {-0.8f, 0.8f}) {
            Vertex vertex{};
            vertex.position = {x, y, 0};
            vertex.uv0 = vertex.uv1 = {0.25f + 0.25f * x, 0.5f - 0.5f * y};
            vertex.color = {0.5f + 0.5f * x, 0.6f, 0.5f - 0.5f * y, 1};
            mesh.vertices.push_back(vertex);
        }
    mesh.indices = gridIndices(1, 1);
    return mesh;
}

Image textureOf(TextureRole role) {
    switch (role) {
    case TextureRole::BaseColor:
        return paint(baseColorAt);
    case TextureRole::Normal:
        return paint(normalAt);
    case TextureRole::MetallicRoughness:
        return paint(packedAt);
    case TextureRole::Metallic:
        return paint([](glm::vec2 uv) { return glm::vec4(packedAt(uv).z); });
    case TextureRole::Roughness:
        return paint([](glm::vec2 uv) { return glm::vec4(packedAt(uv).y); });
    case TextureRole::Occlusion:
        return paint([](glm::vec2 uv) { return glm::vec4(occlusionAt(uv)); });
    case TextureRole::Emissive:
        return paint(emissiveAt);
    default:
        return paint([role](glm::vec2) {
            const auto& texel = rowOf(role).defaultTexel;
            return glm::vec4(texel[0], texel[1], texel[2], texel[3]) / 255.0f;
        });
    }
}

Environment sky() {
    Environment sky{Environment::Layout::Equirect, 128, 64, {}};
    const glm::vec3 sun = glm::normalize(glm::vec3(-0.6f, 0.35f, 0.7f));
    for (int y = 0; y < sky.height; ++y)
        for (int x = 0; x < sky.width; ++x) {
            const float azimuth = glm::two_pi<float>() * ((static_cast<float>(x) + 0.5f) / 128 - 0.5f);
            const float polar = glm::pi<float>() * (static_cast<float>(y) + 0.5f) / 64;
            const glm::vec3 direction(std::sin(polar) * std::sin(azimuth), std::cos(polar),
                                      -std::sin(polar) * std::cos(azimuth));
            const float up = direction.y;
            const glm::vec3 above = glm::mix(glm::vec3(0.50f, 0.28f, 0.12f), glm::vec3(0.05f, 0.13f, 0.33f),
                                             std::sqrt(std::max(up, 0.0f)));
            const float disc = glm::smoothstep(0.985f, 0.995f, glm::dot(direction, sun));
            sky.texels.push_back(up < 0 ? glm::vec3(0.03f, 0.025f, 0.02f)
                                        : above + 15.0f * disc * glm::vec3(1.0f, 0.8f, 0.5f));
        }
    return sky;
}

} // namespace franken::gallery
