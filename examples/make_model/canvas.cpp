// SPDX-License-Identifier: MIT
#include "canvas.h"

#include <algorithm>
#include <numbers>

namespace make_model {
namespace {

template<typename Write>
Image makeImage(int size, int channels, std::size_t texels, const Write& write) {
    Image image{size, size, channels, {}};
    image.pixels.reserve(texels * static_cast<std::size_t>(channels));
    for (std::size_t i = 0; i < texels; ++i)
        write(i, image.pixels);
    return image;
}

void append(std::vector<std::uint8_t>& pixels, glm::dvec3 colour) {
    for (const double channel : {colour.x, colour.y, colour.z})
        pixels.push_back(toByte(channel));
}

} // namespace

Surface blend(const Surface& under, const Surface& over, double amount) {
    return {.colour = glm::mix(under.colour, over.colour, amount),
            .metallic = glm::mix(under.metallic, over.metallic, amount),
            .roughness = glm::mix(under.roughness, over.roughness, amount),
            .height = glm::mix(under.height, over.height, amount),
            .openness = glm::mix(under.openness, over.openness, amount),
            .glow = glm::mix(under.glow, over.glow, amount)};
}

Canvas::Canvas(const Profile& profile, int sectors, int size, const Painter& painter) : m_size(size) {
    m_texels.reserve(static_cast<std::size_t>(size) * size);
    for (int row = 0; row < size; ++row) {
        const double v = (row + 0.5) / size;
        const auto [piece, t] = profile.find(v);
        const Bezier& curve = profile.pieces()[piece].curve;
        const double width = 2.0 * std::numbers::pi * curve.at(t).x / sectors;
        const double rowsOfPiece = (profile.v(piece, 1.0) - profile.v(piece, 0.0)) * size;
        m_texelWidths.push_back(width / size);
        m_texelHeights.push_back(glm::length(curve.slope(t)) / rowsOfPiece);

        const double texel = std::max(m_texelWidths.back(), m_texelHeights.back());
        for (int column = 0; column < size; ++column)
            m_texels.push_back(
                painter({piece, (column + 0.5) / size, t, v, width, profile.length(piece), texel}));
    }
    findCrevices();
}

const Surface& Canvas::at(int column, int row) const {
    const int wrapped = (column + m_size) % m_size;
    return m_texels[static_cast<std::size_t>(std::clamp(row, 0, m_size - 1)) * m_size + wrapped];
}

// A point that lies below the mean of its surroundings sees less of the sky: 10 % per millimetre.
void Canvas::findCrevices() {
    constexpr int kReach = 4;
    constexpr double kShare = 1.0 / ((2 * kReach + 1) * (2 * kReach + 1));
    constexpr double kDarkeningPerMetre = 100.0;
    m_occlusion.reserve(m_texels.size());
    for (int row = 0; row < m_size; ++row)
        for (int column = 0; column < m_size; ++column) {
            double mean = 0.0;
            for (int y = -kReach; y <= kReach; ++y)
                for (int x = -kReach; x <= kReach; ++x)
                    mean += kShare * at(column + x, row + y).height;
            const double sunken = std::max(mean - at(column, row).height, 0.0);
            const double crevice = std::max(1.0 - kDarkeningPerMetre * sunken, 0.3);
            m_occlusion.push_back(at(column, row).openness * crevice);
        }
}

Image Canvas::baseColour() const {
    return makeImage(m_size, 3, m_texels.size(),
                     [this](std::size_t i, auto& pixels) { append(pixels, m_texels[i].colour); });
}

Image Canvas::normals() const {
    return makeImage(m_size, 3, m_texels.size(), [this](std::size_t i, auto& pixels) {
        const int row = static_cast<int>(i) / m_size;
        const int column = static_cast<int>(i) % m_size;
        const double rise = at(column + 1, row).height - at(column - 1, row).height;
        const double climb = at(column, row - 1).height - at(column, row + 1).height;
        const double byX = rise / (2.0 * m_texelWidths[static_cast<std::size_t>(row)]);
        const double byY = climb / (2.0 * m_texelHeights[static_cast<std::size_t>(row)]);
        append(pixels, 0.5 + 0.5 * glm::normalize(glm::dvec3(-byX, -byY, 1.0)));
    });
}

Image Canvas::occlusionRoughnessMetallic() const {
    return makeImage(m_size, 3, m_texels.size(), [this](std::size_t i, auto& pixels) {
        append(pixels, {m_occlusion[i], m_texels[i].roughness, m_texels[i].metallic});
    });
}

Image Canvas::occlusion() const {
    return makeImage(m_size, 1, m_texels.size(),
                     [this](std::size_t i, auto& pixels) { pixels.push_back(toByte(m_occlusion[i])); });
}

Image Canvas::emissive() const {
    return makeImage(m_size, 3, m_texels.size(),
                     [this](std::size_t i, auto& pixels) { append(pixels, m_texels[i].glow); });
}

} // namespace make_model
