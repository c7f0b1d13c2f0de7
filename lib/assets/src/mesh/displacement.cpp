// SPDX-License-Identifier: MIT
#include "franken/displacement.h"

#include "franken/pose.h"
#include "franken/tangents.h"
#include "mesh/vertices.h"
#include "wrapped.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>

namespace franken {
namespace {

/// Which texels lie around a coordinate, and how much of the second is taken.
struct Taps {
    std::array<int, 2> texel;
    float share;
};

Taps tapsAt(float coordinate, int size, Wrap wrap) {
    const float place = coordinate * static_cast<float>(size) - 0.5f;
    const float low = std::floor(place);
    const int texel = static_cast<int>(low);
    return {{wrapped(texel, size, wrap), wrapped(texel + 1, size, wrap)}, place - low};
}

/// Numbers things: equal ones get the same number, in the order in which they are first seen.
template<std::size_t count>
class Numbering {
public:
    std::size_t numberOf(const std::array<float, count>& thing) {
        std::array<std::uint32_t, count> bits{};
        std::transform(thing.begin(), thing.end(), bits.begin(),
                       [](float value) { return std::bit_cast<std::uint32_t>(value + 0.0f); }); // -0 is 0.
        return m_numbers.emplace(bits, m_numbers.size()).first->second;
    }
    std::size_t size() const { return m_numbers.size(); }

private:
    std::map<std::array<std::uint32_t, count>, std::size_t> m_numbers;
};

/// For each vertex: the number of its place, and of its place with its normal.
struct Groups {
    std::vector<std::size_t> place, corner;
    std::size_t places = 0, corners = 0;
};

Groups groupsOf(const Primitive& primitive) {
    Groups groups;
    Numbering<3> places;
    Numbering<6> corners;
    for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
        const glm::vec3& p = primitive.positions[i];
        const glm::vec3& n = primitive.normals[i];
        groups.place.push_back(places.numberOf({p.x, p.y, p.z}));
        groups.corner.push_back(corners.numberOf({p.x, p.y, p.z, n.x, n.y, n.z}));
    }
    groups.places = places.size();
    groups.corners = corners.size();
    return groups;
}

void move(Primitive& primitive, const HeightMap& map, const Groups& groups) {
    struct Sum {
        glm::dvec3 normal{0};
        double height = 0, count = 0;
    };
    std::vector<Sum> sums(groups.places);
    const std::vector<glm::vec2>& uv = primitive.uv[map.uvSet];
    for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
        Sum& sum = sums[groups.place[i]];
        sum.normal += glm::dvec3(primitive.normals[i]);
        sum.height += static_cast<double>(heightAt(map, uv[i])) - map.ground;
        sum.count += 1;
    }
    for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
        const Sum& sum = sums[groups.place[i]];
        if (const double length = glm::length(sum.normal); length > 0)
            primitive.positions[i] += glm::vec3(map.scale * sum.height / sum.count / length * sum.normal);
    }
}

void computeNormals(Primitive& primitive, const Groups& groups) {
    std::vector<glm::dvec3> sums(groups.corners, glm::dvec3(0));
    for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const auto at = [&](std::size_t n) {
                return glm::dvec3(primitive.positions[primitive.indices[i + (corner + n) % 3]]);
            };
            const glm::dvec3 left = at(1) - at(0), right = at(2) - at(0);
            const glm::dvec3 normal = glm::cross(left, right);
            const double doubleArea = glm::length(normal);
            if (doubleArea > 0)
                sums[groups.corner[primitive.indices[i + corner]]] +=
                    normal / doubleArea * std::atan2(doubleArea, glm::dot(left, right));
        }
    for (std::size_t i = 0; i < primitive.normals.size(); ++i)
        if (const glm::dvec3& sum = sums[groups.corner[i]]; glm::length(sum) > 0)
            primitive.normals[i] = glm::vec3(glm::normalize(sum));
}

} // namespace

float heightAt(const HeightMap& map, const glm::vec2& uv) {
    const Taps s = tapsAt(uv.x, map.image.width, map.wrapS), t = tapsAt(uv.y, map.image.height, map.wrapT);
    const auto height = [&](int x, int y) {
        const auto texel = static_cast<std::size_t>(y) * static_cast<std::size_t>(map.image.width) +
                           static_cast<std::size_t>(x);
        return static_cast<float>(map.image.rgba[4 * texel]) / 255;
    };
    const auto row = [&](int y) {
        return height(s.texel[0], y) * (1 - s.share) + height(s.texel[1], y) * s.share;
    };
    return row(t.texel[0]) * (1 - t.share) + row(t.texel[1]) * t.share;
}

Result<void> displace(Primitive& primitive, const HeightMap& map, std::span<const glm::vec2> tangentUv) {
    if (map.image.width < 1 || map.image.height < 1)
        return Error{"height.image", map.image.name, "the height map is empty", "load a picture into it"};
    if (primitive.uv[map.uvSet].size() != primitive.positions.size())
        return Error{"height.uv", "TEXCOORD_" + std::to_string(map.uvSet),
                     "a primitive lacks the texture coordinates of the height map",
                     "choose the other stream, or export the model with texture coordinates"};
    deform(primitive, {}); // What will be moved is displaced before it is.
    const Groups groups = groupsOf(primitive);
    move(primitive, map, groups);
    computeNormals(primitive, groups);
    if (!primitive.tangents.empty())
        computeTangents(primitive, tangentUv);
    primitive.bounds = boundsOf(primitive.positions);
    if (primitive.deformation)
        bind(primitive);
    return {};
}

Result<void> displace(Scene& scene, const HeightMap& map, int material) {
    bool deforms = false;
    for (Mesh& mesh : scene.meshes)
        for (Primitive& primitive : mesh.primitives) {
            if (material != kNone && primitive.material != material)
                continue;
            const Material& of = scene.materials[static_cast<std::size_t>(primitive.material)];
            const std::vector<glm::vec2> uv = sampledUv(primitive, of.textures[TextureRole::Normal]);
            if (Result<void> displaced = displace(primitive, map, uv); !displaced)
                return displaced;
            deforms = deforms || primitive.deformation;
        }
    return deforms ? applyPose(scene, restPose(scene)) : Result<void>();
}

} // namespace franken
