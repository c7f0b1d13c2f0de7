// SPDX-License-Identifier: MIT
// What is shaded of triangles whose pixels can be counted by hand, and what textures bring from memory.
#include "price/raster.h"
#include "price/texels.h"

#include <gtest/gtest.h>

#include <cmath>

namespace price {
namespace {

using Corners = std::array<glm::dvec4, 3>;

/// A rectangle of pixels of a target of `size` pixels along each side, from its lower left corner, as two
/// triangles.
std::array<Corners, 2> rectangle(int size, double left, double lower, double right, double upper,
                                 double depth = 0) {
    const auto clip = [size](double pixel) { return 2 * pixel / size - 1; };
    const glm::dvec4 a(clip(left), clip(lower), depth, 1), b(clip(right), clip(lower), depth, 1),
        c(clip(right), clip(upper), depth, 1), d(clip(left), clip(upper), depth, 1);
    return {Corners{a, b, c}, Corners{a, c, d}};
}

Footprint draw(Raster& raster, const std::array<Corners, 2>& triangles, Faces faces = Faces::Front,
               Hides hides = Hides::Behind) {
    Footprint sum;
    for (const Corners& corners : triangles) {
        const Footprint footprint = raster.draw(corners, faces, hides);
        sum.shaded += footprint.shaded;
        sum.covered += footprint.covered;
        sum.area += footprint.area;
    }
    return sum;
}

constexpr std::size_t kAll = 128 * 128;

TEST(PriceRaster, ASquareThatFillsTheTargetShadesEachPixelOnce) {
    Raster raster(128, 128);
    const Footprint footprint = draw(raster, rectangle(128, 0, 0, 128, 128));
    EXPECT_EQ(footprint.shaded.pixels, kAll);
    EXPECT_EQ(footprint.shaded.quads, kAll / 4 + 64) << "both triangles shade the blocks of the diagonal";
    EXPECT_DOUBLE_EQ(footprint.area, kAll);
    EXPECT_EQ(raster.tiles().size(), 3u) << "of four tiles, the last triangle only touches one at its corner";
}

TEST(PriceRaster, OfThreeLayersOneIsShadedFromFrontToBackAndAllFromBackToFront) {
    for (const bool isFrontFirst : {true, false}) {
        Raster raster(128, 128);
        Shaded shaded, covered;
        for (const double depth : {-0.5, 0.0, 0.5}) {
            const Footprint layer =
                draw(raster, rectangle(128, 0, 0, 128, 128, isFrontFirst ? depth : -depth));
            shaded += layer.shaded;
            covered += layer.covered;
        }
        EXPECT_EQ(shaded.pixels, isFrontFirst ? kAll : 3 * kAll);
        EXPECT_EQ(covered.pixels, 3 * kAll);
        EXPECT_EQ(raster.drawBackground().pixels, 0u);
    }
}

TEST(PriceRaster, AMaskHidesNothingButIsHidden) {
    Raster raster(128, 128);
    EXPECT_EQ(draw(raster, rectangle(128, 0, 0, 128, 128, -0.5), Faces::Front, Hides::Nothing).shaded.pixels,
              kAll);
    EXPECT_EQ(raster.drawBackground().pixels, kAll);
    EXPECT_EQ(draw(raster, rectangle(128, 0, 0, 64, 128, 0)).shaded.pixels, kAll / 2);
    EXPECT_EQ(draw(raster, rectangle(128, 0, 0, 128, 128, 0.5), Faces::Front, Hides::Nothing).shaded.pixels,
              kAll / 2);
    EXPECT_EQ(raster.drawBackground().pixels, kAll / 2);
}

TEST(PriceRaster, BlocksOfTwoByTwoAreShadedWhole) {
    Raster raster(128, 128);
    const Footprint pixel = draw(raster, rectangle(128, 4, 4, 5, 5));
    EXPECT_EQ(pixel.shaded.pixels, 1u);
    EXPECT_EQ(pixel.shaded.quads, 1u);
    const Footprint four = draw(raster, rectangle(128, 11, 11, 13, 13));
    EXPECT_EQ(four.shaded.pixels, 4u);
    EXPECT_EQ(four.covered.pixels, 4u);
    EXPECT_GE(four.shaded.quads, 4u) << "it lies in four blocks";
}

TEST(PriceRaster, TheFacesThatAreCulledCostNothing) {
    Raster raster(128, 128);
    EXPECT_EQ(draw(raster, rectangle(128, 0, 0, 128, 128), Faces::Back).covered.pixels, 0u);
    const std::array<Corners, 2> front = rectangle(128, 0, 0, 128, 128);
    const Corners back = {front[0][0], front[0][2], front[0][1]};
    raster.draw(back, Faces::Front, Hides::Behind);
    EXPECT_TRUE(raster.tiles().empty());
    raster.draw(back, Faces::Back, Hides::Behind);
    EXPECT_FALSE(raster.tiles().empty());
    EXPECT_EQ(raster.draw(back, Faces::Both, Hides::Behind).covered.pixels,
              raster.draw(front[0], Faces::Both, Hides::Behind).covered.pixels);
}

// A fan about a point that is on no grid: neither gap nor overlap.
TEST(PriceRaster, OfACommonEdgeOneTriangleHasEachPixel) {
    Raster raster(128, 128);
    const glm::dvec4 middle(0.1234567, -0.0345678, 0, 1);
    constexpr int kSpokes = 37;
    Shaded shaded;
    const auto rim = [](int spoke) {
        const double angle = 2 * 3.14159265358979 * spoke / kSpokes;
        return glm::dvec4(3 * std::cos(angle), 3 * std::sin(angle), 0, 1);
    };
    for (int spoke = 0; spoke < kSpokes; ++spoke)
        shaded += raster.draw({middle, rim(spoke), rim((spoke + 1) % kSpokes)}, Faces::Front, Hides::Nothing)
                      .shaded;
    EXPECT_EQ(shaded.pixels, kAll);
}

// The plane z = -w cuts each edge that crosses it in the middle: half of the height, and a quarter of the
// triangle, go.
TEST(PriceRaster, WhatIsBeforeTheNearPlaneIsCutOff) {
    Raster raster(128, 128);
    const Corners whole = {glm::dvec4(-1, -1, 0, 1), {1, -1, 0, 1}, {-1, 1, 0, 1}};
    Corners cut = whole;
    cut[2].z = -2;
    const auto pixels = [&raster](const Corners& corners) {
        return static_cast<double>(raster.draw(corners, Faces::Front, Hides::Nothing).covered.pixels);
    };
    EXPECT_NEAR(pixels(whole), kAll / 2.0, 128);
    EXPECT_NEAR(pixels(cut), 0.75 * kAll / 2, 128);
    EXPECT_EQ(
        raster.draw({glm::dvec4(0, 0, 0, -1), {1, 0, 0, -1}, {0, 1, 0, -1}}, Faces::Both, Hides::Nothing)
            .covered.pixels,
        0u)
        << "behind the eye";
}

TEST(PriceRaster, ATriangleWithoutAPixelStillReachesItsTile) {
    Raster raster(200, 200);
    const std::array<Corners, 2> speck = rectangle(200, 70.6, 130.6, 70.9, 130.9);
    const Footprint footprint = raster.draw(speck[0], Faces::Front, Hides::Behind);
    EXPECT_EQ(footprint.covered.pixels, 0u);
    ASSERT_EQ(raster.tiles().size(), 1u);
    EXPECT_EQ(raster.tiles()[0], 2 * 4 + 1) << "row 2 of tiles, column 1, of 4 across";
}

TEST(PriceTexels, AreThoseOfTheLevelThatIsLookedAt) {
    using franken::Filter;
    for (const Filter filter : {Filter::Linear, Filter::LinearMipmapLinear})
        EXPECT_DOUBLE_EQ(texelsPerPixel(0.25, filter), 0.25);
    EXPECT_DOUBLE_EQ(texelsPerPixel(16, Filter::LinearMipmapLinear), 1.25)
        << "level 2, and a quarter of level 3";
    EXPECT_DOUBLE_EQ(texelsPerPixel(2, Filter::LinearMipmapLinear), 2.5)
        << "level 0, and a quarter of level 1";
    EXPECT_DOUBLE_EQ(texelsPerPixel(16, Filter::LinearMipmapNearest), 1);
    EXPECT_DOUBLE_EQ(texelsPerPixel(9, Filter::Linear), 9);
    EXPECT_DOUBLE_EQ(texelsPerPixel(900, Filter::Linear), kLineTexels)
        << "a line of the cache for each pixel";
    EXPECT_EQ(lookupsOf(Filter::LinearMipmapLinear), 2);
    EXPECT_EQ(lookupsOf(Filter::LinearMipmapNearest), 1);
}

} // namespace
} // namespace price
