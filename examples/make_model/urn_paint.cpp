// SPDX-License-Identifier: MIT
#include "urn.h"

#include <algorithm>
#include <cmath>

#include "numbers.h"
#include "ornament.h"

namespace make_model {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr dvec3 kTeal(0.05, 0.29, 0.35);
constexpr dvec3 kDeepTeal(0.02, 0.15, 0.21);
constexpr dvec3 kTurquoise(0.16, 0.55, 0.55);
constexpr dvec3 kIvory(0.93, 0.88, 0.76);
constexpr dvec3 kCobalt(0.09, 0.19, 0.47);
constexpr dvec3 kCoral(0.74, 0.24, 0.15);
constexpr dvec3 kGold(1.00, 0.83, 0.50);

Surface glaze(dvec3 colour, const Spot& spot) {
    const double pooling = noise({spot.u * 12.0, spot.v * 24.0}, 12, 11);
    return {.colour = colour * (0.88 + 0.24 * pooling), .roughness = 0.24};
}

Surface gilding(double height = 0.0) {
    return {.colour = kGold, .metallic = 1.0, .roughness = 0.40, .height = height};
}

Surface hammeredGold(const Spot& spot) {
    const double dent = std::min(dents({spot.u * 64.0, spot.y() / 0.017}, 64, 21), 1.0);
    return {.colour = kGold, .metallic = 1.0, .roughness = 0.34, .height = 0.004 * dent};
}

// Inlaid wire along an outline, standing a little proud.
void inlay(Surface& surface, double distance, double width, double texel) {
    const double arc = std::max(1.0 - std::abs(distance) / width, 0.0);
    surface = blend(surface, gilding(surface.height + 0.003 * arc), stroke(distance, width, texel));
}

void enamel(Surface& surface, double distance, dvec3 colour, double texel) {
    const Surface fill{
        .colour = colour, .roughness = 0.29, .height = surface.height + 0.0015 * swell(distance, 0.01)};
    surface = blend(surface, fill, cover(distance, texel));
}

void petal(Surface& surface, double distance, dvec3 rim, dvec3 heart, const Spot& spot) {
    const double depth = ramp(0.0, 0.03, -distance);
    Surface fill = glaze(glm::mix(rim, heart, depth), spot);
    fill.height = 0.004 * swell(distance, 0.02);
    surface = blend(surface, fill, cover(distance, spot.texel));
    inlay(surface, distance, 0.008, spot.texel);
}

Surface paintLid(const Spot& spot) {
    Surface surface = glaze(kDeepTeal, spot);
    const dvec2 point = repeat({spot.x(), spot.y()}, spot.width / 4.0);
    petal(surface, leaf(point - dvec2(0.0, -0.015), 0.042, 0.12), kTeal, kTurquoise, spot);
    enamel(surface, disc(repeat({spot.x() + spot.width / 8.0, spot.y() + 0.11}, spot.width / 4.0), 0.011),
           kIvory, spot.texel);
    return surface;
}

Surface paintNeck(const Spot& spot) {
    const double ridge = 0.5 + 0.5 * cosTurns(kFlutesPerSector * spot.u);
    Surface surface = glaze(glm::mix(kDeepTeal, kTurquoise, 0.8 * ridge), spot);
    surface.openness = ramp(-0.3, 0.4, spot.t) * (0.7 + 0.3 * ridge);
    return surface;
}

// A vine that winds along the band, a blossom in each of its bays, and leaves where it crosses the middle.
void vine(Surface& surface, dvec2 point, double bay, double texel) {
    enamel(surface, wave(point, 0.052, 2.0 * bay) - 0.005, kCobalt, texel);

    const double side = static_cast<int>(std::floor(point.x / bay)) % 2 == 0 ? 1.0 : -1.0;
    const dvec2 inBay = repeat(point, bay) * dvec2(1.0, side);
    for (const double hand : {-1.0, 1.0}) {
        const dvec2 right(cosTurns(0.13 * hand), -sinTurns(0.13 * hand));
        const dvec2 up(-right.y, right.x);
        const dvec2 away = inBay - dvec2(0.088 * hand, -0.045);
        const dvec2 tilted(glm::dot(away, right), glm::dot(away, up));
        enamel(surface, leaf(tilted, 0.012, 0.038), kTeal, texel);
    }
    const dvec2 blossom = inBay - dvec2(0.0, -0.022);
    enamel(surface, rosette(blossom, 0.056), kCoral, texel);
    inlay(surface, disc(blossom, 0.006), 0.014, texel);
}

Surface paintShoulder(const Spot& spot) {
    const double y = spot.y();
    Surface surface = glaze(kTeal, spot);

    const dvec2 hanging = repeat({spot.x(), y - 0.15}, spot.width / kFlutesPerSector);
    petal(surface, leaf(hanging, 0.034, 0.085), kDeepTeal, kTurquoise, spot);

    const double band = std::abs(y + 0.055) - 0.105;
    Surface ivory = glaze(kIvory, spot);
    ivory.roughness = 0.29;
    vine(ivory, {spot.x(), y + 0.055}, spot.width / 4.0, spot.texel);
    surface = blend(surface, ivory, cover(band, spot.texel));
    inlay(surface, band, 0.012, spot.texel);

    const dvec2 pearl = repeat({spot.x(), y + 0.187}, spot.width / 24.0);
    enamel(surface, disc(pearl, 0.011), kIvory, spot.texel);
    return surface;
}

Surface paintUpperBand(const Spot& spot) {
    Surface surface = hammeredGold(spot);
    surface.height += 0.012 * dome(repeat({spot.x(), spot.y()}, spot.width / 24.0), 0.019);
    return surface;
}

// Panes of amber glass in a diamond lattice. The light stands low in the middle of the window.
Surface paintGlass(dvec2 point, const Spot& spot) {
    constexpr double kPane = 0.046;
    const dvec2 lattice((point.x + 0.6 * point.y) / kPane, (point.x - 0.6 * point.y) / kPane);
    const dvec2 pane = glm::floor(lattice);
    const dvec2 toCentre = glm::abs(lattice - pane - 0.5);
    const double toLead = (0.5 - std::max(toCentre.x, toCentre.y)) * kPane * 0.8;

    const double far = glm::length(point - dvec2(0.0, -0.03)) / 0.13;
    const double light = 1.0 / (1.0 + far * far);
    const dvec3 amber = glm::mix(dvec3(0.90, 0.30, 0.04), dvec3(1.0, 0.82, 0.36), ramp(0.3, 0.9, light));
    const dvec3 flame = glm::mix(amber, dvec3(1.0, 0.97, 0.80), ramp(0.75, 1.0, light));
    const double tint = hash(static_cast<int>(pane.x), static_cast<int>(pane.y), 31);
    const dvec3 glow = flame * glm::mix(dvec3(1.0), dvec3(0.98, 0.84, 0.74), tint);

    Surface glass{.colour = 0.3 * glow, .roughness = 0.12, .height = -0.008, .glow = glow};
    glass.height += 0.003 * swell(-toLead, 0.012);
    const Surface lead{.colour = 0.55 * kGold, .metallic = 1.0, .roughness = 0.45, .height = -0.005};
    return blend(glass, lead, cover(toLead - 0.0025, spot.texel));
}

// A pointed panel between two windows, with a red stone in a gold setting.
void panel(Surface& surface, dvec2 point, const Spot& spot) {
    petal(surface, leaf(point, 0.062, 0.15), kDeepTeal, kTeal, spot);
    for (const double hand : {-1.0, 1.0})
        enamel(surface, leaf(point - dvec2(0.0, 0.072 * hand), 0.013, 0.036), kIvory, spot.texel);

    const double stone = disc(point, 0.024);
    const Surface ruby{.colour = {0.62, 0.03, 0.05},
                       .roughness = 0.11,
                       .height = 0.012 * dome(point, 0.024),
                       .glow = {0.35, 0.02, 0.03}};
    surface = blend(surface, ruby, cover(stone, spot.texel));
    inlay(surface, stone, 0.010, spot.texel);
}

Surface paintBelly(const Spot& spot) {
    constexpr double kFrame = 0.016;
    const double pitch = spot.width / 2.0;
    const dvec2 point = repeat({spot.x() + pitch / 2.0, spot.y()}, pitch) - dvec2(0.0, -0.025);
    const double window = arch(point, 0.115, 0.165, 0.11);

    Surface surface = glaze(kTeal, spot);
    panel(surface, repeat({spot.x(), spot.y()}, pitch), spot);
    const dvec2 star = repeat({spot.x(), spot.y() - 0.115}, pitch / 2.0);
    const double petals = rosette(star, 0.032);
    surface = blend(surface, gilding(0.006 * swell(petals, 0.012)), cover(petals, spot.texel));
    const double spill = std::max(window, 0.0) / 0.04;
    surface.glow += dvec3(0.50, 0.25, 0.08) / (1.0 + spill * spill);

    surface = blend(surface, paintGlass(point, spot), cover(window, spot.texel));
    const double arc = 1.0 - std::min(std::abs(window) / kFrame, 1.0);
    return blend(surface, gilding(0.010 * std::sqrt(arc)), stroke(window, kFrame, spot.texel));
}

Surface paintLowerBand(const Spot& spot) {
    Surface surface = glaze(kIvory, spot);
    const double pitch = spot.width / 12.0;
    const dvec2 lying = repeat({spot.x(), spot.y()}, pitch);
    enamel(surface, leaf({lying.y, lying.x}, 0.012, 0.026), kCoral, spot.texel);
    enamel(surface, disc(repeat({spot.x() + pitch / 2.0, spot.y()}, pitch), 0.007), kCobalt, spot.texel);
    inlay(surface, std::abs(spot.y()) - 0.5 * spot.length + 0.005, 0.010, spot.texel);
    return surface;
}

Surface paintCup(const Spot& spot) {
    const double pitch = spot.width / kFlutesPerSector;
    const dvec2 point = repeat({spot.x() + pitch / 2.0, spot.y()}, pitch);
    Surface surface = glaze(kDeepTeal, spot);
    petal(surface, leaf(point, 0.44 * pitch, 0.49 * spot.length), kTeal, kTurquoise, spot);
    surface.openness = 1.0 - 0.6 * ramp(0.3, 1.0, spot.t);
    return surface;
}

} // namespace

Surface paintUrn(const Spot& spot) {
    switch (spot.piece) {
    case kLid:
        return paintLid(spot);
    case kNeck:
        return paintNeck(spot);
    case kShoulder:
        return paintShoulder(spot);
    case kUpperBand:
        return paintUpperBand(spot);
    case kBelly:
        return paintBelly(spot);
    case kLowerBand:
        return paintLowerBand(spot);
    default:
        return paintCup(spot);
    }
}

} // namespace make_model
