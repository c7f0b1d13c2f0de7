// SPDX-License-Identifier: MIT
#include "support/shapes.h"

#include "franken/complete.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace franken::test {
namespace {

void addBounds(Primitive& primitive) {
    for (const glm::vec3& position : primitive.positions)
        primitive.bounds.add(position);
}

std::uint8_t toByte(float value) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0f, 1.0f)));
}

} // namespace

Primitive sphere(int rings) {
    Primitive primitive;
    const int columns = 2 * rings;
    for (int row = 0; row <= rings; ++row)
        for (int column = 0; column <= columns; ++column) {
            const float u = static_cast<float>(column) / static_cast<float>(columns);
            const float v = static_cast<float>(row) / static_cast<float>(rings);
            const float longitude = glm::two_pi<float>() * u, polar = glm::pi<float>() * v;
            const glm::vec3 normal(std::sin(polar) * std::sin(longitude), std::cos(polar),
                                   std::sin(polar) * std::cos(longitude));
            primitive.positions.push_back(normal);
            primitive.normals.push_back(normal);
            primitive.tangents.emplace_back(std::cos(longitude), 0, -std::sin(longitude), 1);
            primitive.uv[0].emplace_back(u, v);
        }
    const auto index = [&](int row, int column) {
        return static_cast<std::uint32_t>(row * (columns + 1) + column);
    };
    for (int row = 0; row < rings; ++row)
        for (int column = 0; column < columns; ++column)
            for (const std::uint32_t corner :
                 {index(row, column), index(row + 1, column), index(row + 1, column + 1), index(row, column),
                  index(row + 1, column + 1), index(row, column + 1)})
                primitive.indices.push_back(corner);
    addBounds(primitive);
    return primitive;
}

Primitive square() { return plane({2, 2}); }

Image paint(int size, const std::function<glm::vec4(glm::vec2)>& color) {
    Image image{"painted", size, size, {}};
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const glm::vec4 texel = color((glm::vec2(x, y) + 0.5f) / static_cast<float>(size));
            for (int channel = 0; channel < 4; ++channel)
                image.rgba.push_back(toByte(texel[channel]));
        }
    return image;
}

Image checkers(int size, int count, const glm::vec4& even, const glm::vec4& odd) {
    return paint(size, [&](glm::vec2 uv) {
        const glm::vec2 square = uv * static_cast<float>(count);
        return (static_cast<int>(square.x) + static_cast<int>(square.y)) % 2 == 0 ? even : odd;
    });
}

Image bumps(int size, int count) {
    return paint(size, [&](glm::vec2 uv) {
        const glm::vec2 place = glm::fract(uv * static_cast<float>(count)) * 2.0f - 1.0f;
        const float height2 = 1 - glm::dot(place, place);
        const glm::vec3 normal = height2 > 0
                                     ? glm::normalize(glm::vec3(place.x, -place.y, std::sqrt(height2) + 0.7f))
                                     : glm::vec3(0, 0, 1);
        return glm::vec4(0.5f * normal + 0.5f, 1);
    });
}

int SceneBuilder::addTexture(Image image, Filter minFilter, Wrap wrap) {
    scene.images.push_back(std::move(image));
    scene.textures.push_back({.image = static_cast<int>(scene.images.size()) - 1,
                              .wrapS = wrap,
                              .wrapT = wrap,
                              .minFilter = minFilter});
    return static_cast<int>(scene.textures.size()) - 1;
}

int SceneBuilder::addMaterial(const Material& material) {
    scene.materials.push_back(material);
    return static_cast<int>(scene.materials.size()) - 1;
}

void SceneBuilder::add(Primitive primitive, int material, const glm::mat4& world) {
    primitive.material = material;
    scene.meshes.push_back({"", {std::move(primitive)}});
    scene.instances.push_back({.name = "",
                               .mesh = static_cast<int>(scene.meshes.size()) - 1,
                               .world = world,
                               .mirrored = glm::determinant(glm::mat3(world)) < 0});
}

void SceneBuilder::addSun(const glm::vec3& direction, const glm::vec3& color, float lux) {
    scene.lights.push_back(
        {.name = "sun", .color = color, .intensity = lux, .direction = glm::normalize(direction)});
}

Material tiledMaterial(SceneBuilder& builder) {
    Material material;
    material.textures[TextureRole::BaseColor].texture =
        builder.addTexture(checkers(8, 4, {1, 0.6f, 0.2f, 1}, {0.9f, 0.9f, 0.8f, 1}));
    material.textures[TextureRole::Normal].texture =
        builder.addTexture(bumps(16, 2), Filter::LinearMipmapLinear, Wrap::MirroredRepeat);
    material.textures[TextureRole::MetallicRoughness].texture = builder.addTexture(
        checkers(8, 2, {1, 0.5f, 0, 1}, {1, 0.9f, 1, 1}), Filter::Linear, Wrap::ClampToEdge);
    return material;
}

} // namespace franken::test
