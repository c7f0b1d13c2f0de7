// SPDX-License-Identifier: MIT
#include "world.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace {

/// A grid of quads over u and v, 0 to 1 each.
template<typename At>
Mesh grid(int columns, int rows, At at) {
    Mesh mesh;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column)
            mesh.vertices.push_back(at(static_cast<float>(column) / static_cast<float>(columns),
                                       static_cast<float>(row) / static_cast<float>(rows)));
    const auto index = [&](int row, int column) {
        return static_cast<std::uint16_t>(row * (columns + 1) + column);
    };
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            for (const std::uint16_t corner :
                 {index(row, column), index(row + 1, column), index(row + 1, column + 1), index(row, column),
                  index(row + 1, column + 1), index(row, column + 1)})
                mesh.triangles.push_back(corner);
    return mesh;
}

/// A ring around Z; u goes along it, v around its tube.
Mesh ring(float radius, float thickness) {
    return grid(96, 48, [=](float u, float v) {
        const float along = glm::two_pi<float>() * u, around = -glm::two_pi<float>() * v;
        const glm::vec3 outwards(std::cos(along), std::sin(along), 0);
        const glm::vec3 normal = outwards * std::cos(around) + glm::vec3(0, 0, std::sin(around));
        const glm::vec4 tangent(-std::sin(along), std::cos(along), 0, 1);
        return Vertex{radius * outwards + thickness * normal, normal, tangent, {8 * u, 3 * v}};
    });
}

Mesh floor(float halfSide) {
    return grid(1, 1, [=](float u, float v) {
        const glm::vec3 position(halfSide * (2 * u - 1), 0, halfSide * (2 * v - 1));
        return Vertex{position, {0, 1, 0}, {1, 0, 0, 1}, {u, v}};
    });
}

Mesh ball(float radius) {
    return grid(64, 32, [=](float u, float v) {
        const float east = glm::two_pi<float>() * u, south = glm::pi<float>() * v;
        const glm::vec3 normal(std::sin(south) * std::sin(east), std::cos(south),
                               std::sin(south) * std::cos(east));
        return Vertex{radius * normal, normal, {std::cos(east), 0, -std::sin(east), 1}, {u, v}};
    });
}

template<typename At>
Bitmap paint(int size, At at) {
    Bitmap bitmap{size, {}};
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const glm::vec3 color = at((glm::vec2(x, y) + 0.5f) / static_cast<float>(size));
            for (int channel = 0; channel < 3; ++channel)
                bitmap.texels.push_back(static_cast<std::uint8_t>(std::lround(255 * color[channel])));
            bitmap.texels.push_back(255);
        }
    return bitmap;
}

} // namespace

World makeWorld() {
    World world;
    world.things.push_back({ring(0.9f, 0.34f), {glm::vec3(1), 0, 0.45f, true}});
    world.things.push_back({ball(0.35f), {{1, 0.77f, 0.34f}, 1, 0.3f, false}, glm::mat4(1)});
    world.things.push_back(
        {floor(2.2f), {{0.35f, 0.38f, 0.42f}, 0, 0.6f, false}, glm::translate(glm::mat4(1), {0, -1.3f, 0})});
    world.tiles = paint(64, [](glm::vec2 uv) {
        const bool even = (uv.x < 0.5f) == (uv.y < 0.5f);
        return even ? glm::vec3(0.85f, 0.35f, 0.25f) : glm::vec3(0.9f, 0.85f, 0.75f);
    });
    world.ridges = paint(64, [](glm::vec2 uv) {
        const float slope = 0.35f * std::sin(4 * glm::pi<float>() * uv.y);
        return 0.5f * glm::normalize(glm::vec3(0, slope, 1)) + 0.5f;
    });
    animate(world, 0);
    return world;
}

void animate(World& world, float seconds) {
    glm::mat4 place = glm::rotate(glm::mat4(1), 0.8f * seconds, {0, 1, 0});
    world.things[0].place = glm::rotate(place, -0.3f, {1, 0, 0});
    const float turn = 0.5f * seconds;
    world.lampPosition = {1.6f * std::cos(turn), 0.9f, 1.6f * std::sin(turn) + 0.4f};
}
