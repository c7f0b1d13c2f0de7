// SPDX-License-Identifier: MIT
#include "draw_counter.h"

#include "texels.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <utility>

using namespace franken;

namespace price {
namespace {

using Corners = std::array<std::uint32_t, 3>;

/// A material's texture, as far as it costs memory.
struct Sampled {
    const std::vector<glm::vec2>* uv;
    double texels; ///< Of the largest level, times what KHR_texture_transform stretches.
    Filter filter;
};

std::vector<Sampled> texturesOf(const Scene& scene, const Primitive& primitive, const MaterialPlan& plan) {
    const Material& material = scene.materials[static_cast<std::size_t>(primitive.material)];
    std::vector<Sampled> textures;
    for (const TextureRoleRow& role : textureRoles()) {
        if (!isMaterials(role.role) || !role.there(plan.permutation) || !material.textures[role.role])
            continue;
        const TextureRef& ref = material.textures[role.role];
        const Texture& texture = scene.textures[static_cast<std::size_t>(ref.texture)];
        const Image& image = scene.images[static_cast<std::size_t>(texture.image)];
        const double stretch = std::abs(glm::determinant(glm::dmat2(glm::mat2(ref.transform))));
        textures.push_back({&primitive.uv[static_cast<std::size_t>(ref.uvSet)],
                            stretch * image.width * image.height, texture.minFilter});
    }
    return textures;
}

/// Of its texture coordinates.
double areaOf(const std::vector<glm::vec2>& uv, const Corners& corners) {
    const glm::dvec2 a = uv[corners[0]], b = uv[corners[1]], c = uv[corners[2]];
    return 0.5 * std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

TexelBytes texelBytes(const std::vector<Sampled>& textures, const Corners& corners,
                      const Footprint& footprint) {
    TexelBytes bytes;
    if (footprint.shaded.pixels == 0)
        return bytes;
    const double pixels = static_cast<double>(footprint.shaded.pixels);
    for (const Sampled& texture : textures) {
        const double density = areaOf(*texture.uv, corners) * texture.texels / footprint.area;
        bytes.whole += kTexelBytes * pixels * texelsPerPixel(density, texture.filter);
        bytes.halved += kTexelBytes * pixels * texelsPerPixel(density / 4, texture.filter);
    }
    return bytes;
}

int vertexBytes(const Primitive& primitive, const MaterialPlan& plan) {
    constexpr int kFloat = 4, kColor = 8, kJoints = 32;
    return kFloat * (3 + (primitive.normals.empty() ? 0 : 3) + (primitive.tangents.empty() ? 0 : 4) +
                     (primitive.uv[0].empty() ? 0 : 2) + (primitive.uv[1].empty() ? 0 : 2)) +
           (primitive.colors.empty() ? 0 : kColor) + (plan.permutation.influences > 0 ? kJoints : 0);
}

template<typename Value>
void keepDifferent(std::vector<Value>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

template<typename Value>
std::size_t countDifferent(std::vector<Value> values) {
    keepDifferent(values);
    return values.size();
}

/// As the pixels of the picture's middle see it: texels of a face under a pixel.
double skyDensity(const FrameContents& frame) {
    const auto direction = [&frame](double x, double y) {
        return glm::normalize(frame.viewpoint.clipToSky * glm::dvec3(x, y, 1));
    };
    const glm::dvec3 middle = direction(0, 0);
    const double across = glm::length(direction(2.0 / frame.width, 0) - middle),
                 down = glm::length(direction(0, 2.0 / frame.height) - middle);
    return across * down * (frame.skyboxSize / 2.0) *
           (frame.skyboxSize / 2.0); // A face spans 2 at a distance of 1.
}

Faces turned(Faces faces) {
    return faces == Faces::Front ? Faces::Back : faces == Faces::Back ? Faces::Front : faces;
}

} // namespace

bool isBesideTheView(std::span<const glm::dvec4> places) {
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0})
            if (std::all_of(places.begin(), places.end(),
                            [&](const glm::dvec4& place) { return side * place[axis] > place.w; }))
                return true;
    return false;
}

void DrawCounter::add(const Instance& instance, const Primitive& primitive, const MaterialPlan& plan,
                      Faces faces) {
    const glm::dmat4 toClip = m_frame.viewpoint.viewProjection * instance.world;
    std::vector<glm::dvec4> places;
    places.reserve(primitive.positions.size());
    for (const glm::vec3& position : primitive.positions)
        places.push_back(toClip * glm::dvec4(position, 1));
    if (isBesideTheView(places))
        return;
    Draw draw;
    draw.plan = plan;
    draw.isMasked = plan.permutation.alpha == Alpha::Mask;
    draw.vertices = countDifferent(primitive.indices);
    draw.vertexBytes = vertexBytes(primitive, plan);
    const std::vector<Sampled> textures = texturesOf(m_frame.scene, primitive, plan);
    for (const Sampled& texture : textures)
        draw.lookups += lookupsOf(texture.filter);
    const Hides hides = plan.permutation.alpha == Alpha::Opaque ? Hides::Behind : Hides::Nothing;
    std::vector<std::uint64_t> tileVertices;
    std::size_t room = std::size_t{1} << 20U; // Of 64-bit numbers, before those that are there twice go.
    for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
        const Corners corners = {primitive.indices[i], primitive.indices[i + 1], primitive.indices[i + 2]};
        const Footprint footprint =
            m_raster.draw({places[corners[0]], places[corners[1]], places[corners[2]]},
                          instance.mirrored ? turned(faces) : faces, hides);
        draw.shaded += footprint.shaded;
        draw.covered += footprint.covered;
        const TexelBytes bytes = texelBytes(textures, corners, footprint);
        draw.texels.whole += bytes.whole;
        draw.texels.halved += bytes.halved;
        for (const int tile : m_raster.tiles())
            for (const std::uint32_t vertex : corners)
                tileVertices.push_back(static_cast<std::uint64_t>(tile) << 32U | vertex);
        if (tileVertices.size() > room) {
            keepDifferent(tileVertices);
            room = std::max(room, 2 * tileVertices.size());
        }
    }
    draw.tileVertices = countDifferent(std::move(tileVertices));
    m_counts.draws.push_back(std::move(draw));
}

void DrawCounter::addSkybox() {
    if (m_frame.skyboxSize == 0)
        return;
    const auto tilesAlong = [](int pixels) { return static_cast<std::size_t>((pixels + kTile - 1) / kTile); };
    const auto along = [](int pixels) { return static_cast<std::size_t>(pixels); };
    Draw draw;
    draw.isSkybox = true;
    draw.shaded = m_raster.drawBackground();
    draw.covered = {along(m_frame.width) * along(m_frame.height),
                    along((m_frame.width + 1) / 2) * along((m_frame.height + 1) / 2)};
    draw.vertices = 3;
    draw.tileVertices = 3 * tilesAlong(m_frame.width) * tilesAlong(m_frame.height);
    draw.vertexBytes = 12;
    const double bytes = kTexelBytes * static_cast<double>(draw.shaded.pixels) *
                         texelsPerPixel(skyDensity(m_frame), Filter::Linear);
    draw.texels = {bytes, bytes};
    draw.lookups = lookupsOf(Filter::Linear);
    m_counts.draws.push_back(draw);
}

} // namespace price
