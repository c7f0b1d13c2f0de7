// SPDX-License-Identifier: MIT
// What is made of meshes and images before GL gets them.
#include "franken/mipmap.h"
#include "franken/resample.h"
#include "gpu_mesh.h"
#include "gpu_texture.h"
#include "joint_influences.h"
#include "support/shapes.h"
#include "support/snake.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace franken::test {
namespace {

/// The vertices of all triangles in their order.
std::vector<std::uint8_t> unrolled(const std::vector<MeshData>& parts) {
    std::vector<std::uint8_t> bytes;
    for (const MeshData& part : parts)
        for (const std::uint32_t index : part.indices) {
            const auto from = part.vertices.begin() + static_cast<std::ptrdiff_t>(index) * part.format.stride;
            bytes.insert(bytes.end(), from, from + part.format.stride);
        }
    return bytes;
}

TEST(TextureBytes, AreThoseOfAllLevels) {
    EXPECT_EQ(textureBytes({8, 8}, false), 4u * 64);
    EXPECT_EQ(textureBytes({8, 8}, true), 4u * (64 + 16 + 4 + 1));
    EXPECT_EQ(textureBytes({8, 1}, true), 4u * (8 + 4 + 2 + 1));
    EXPECT_EQ(textureBytes({2, 16}, true), 4u * (32 + 8 + 4 + 2 + 1));
    EXPECT_EQ(textureBytes({5, 3}, true), 4u * (15 + 2 + 1)) << "halves are rounded down";
}

TEST(Split, KeepsTrianglesAndTheirOrder) {
    const MeshData whole = interleave(sphere(10));
    for (const std::size_t most : {3u, 4u, 50u, 1000u}) {
        const std::vector<MeshData> parts = split(whole, {most});
        EXPECT_EQ(unrolled(parts), unrolled({whole})) << most;
        for (const MeshData& part : parts)
            EXPECT_LE(part.vertices.size() / static_cast<std::size_t>(part.format.stride), most);
    }
    EXPECT_EQ(split(whole, {1000}).size(), 1u);
}

TEST(Split, GivesEachPartAPaletteOfItsOwn) {
    const Scene scene = sceneOf({.influences = 3, .joints = 40});
    const Primitive& primitive = scene.meshes[0].primitives[0];
    const MeshData whole = interleave(primitive, true);
    for (const std::size_t most : {12u, 13u, 32u, 64u}) {
        const std::vector<MeshData> parts = split(whole, {100'000, most});
        EXPECT_EQ(parts.size() == 1, most > 40);
        std::size_t indices = 0;
        for (const MeshData& part : parts) {
            indices += part.indices.size();
            ASSERT_LE(part.joints.size(), most);
            for (std::size_t v = 0; v < part.sources.size(); ++v) {
                const JointInfluences found = influencesAt(
                    part.format, part.vertices.data() + v * static_cast<std::size_t>(part.format.stride));
                for (std::size_t i = 0; i < 3; ++i) {
                    const Influence& influence = primitive.deformation->influences[3 * part.sources[v] + i];
                    ASSERT_EQ(part.joints.at(static_cast<std::size_t>(found.joints[i]) / 3), influence.joint);
                    ASSERT_EQ(found.weights[i], influence.weight);
                }
                ASSERT_EQ(found.weights[3], 0);
            }
        }
        EXPECT_EQ(indices, primitive.indices.size());
    }
}

TEST(Interleave, HoldsWhatThePrimitiveHas) {
    Primitive primitive = square();
    EXPECT_EQ(interleave(primitive).format.stride, 12 + 12 + 16 + 8);
    EXPECT_EQ(interleave(primitive).format.color, -1);
    primitive.colors.assign(4, glm::vec4(1, 0.5f, 2, -1));
    const MeshData data = interleave(primitive);
    ASSERT_EQ(data.format.color, 48);
    std::array<std::uint16_t, 4> color{};
    std::copy_n(data.vertices.begin() + 48, 8, reinterpret_cast<std::uint8_t*>(color.data()));
    EXPECT_EQ(color, (std::array<std::uint16_t, 4>{65535, 32768, 65535, 0}));
}

constexpr Capabilities kLeast = {.maxTextureSize = 64};

TEST(FittedSize, IsOfPowersOfTwoOnlyWhereGles2AsksForIt) {
    const Image image{"", 33, 50, {}};
    const Texture mipmapped{.image = 0};
    const Texture clamped{
        .image = 0, .wrapS = Wrap::ClampToEdge, .wrapT = Wrap::ClampToEdge, .minFilter = Filter::Linear};
    EXPECT_EQ(fittedSize(image, mipmapped, kLeast), (TextureSize{32, 64}));
    EXPECT_EQ(fittedSize(image, clamped, kLeast), (TextureSize{33, 50}));
    EXPECT_EQ(fittedSize(image, mipmapped, {.maxTextureSize = 64, .anyTextureSize = true}),
              (TextureSize{33, 50}));
}

TEST(FittedSize, KeepsTheShapeOfWhatIsTooLarge) {
    const Image image{"", 256, 100, {}};
    EXPECT_EQ(fittedSize(image, {}, {.maxTextureSize = 64, .anyTextureSize = true}), (TextureSize{64, 25}));
    EXPECT_EQ(fittedSize(image, {}, kLeast), (TextureSize{64, 32}));
}

constexpr Texture wrapping(Wrap wrap) { return {.wrapS = wrap, .wrapT = wrap}; }

constexpr std::array kWraps = {Wrap::Repeat, Wrap::ClampToEdge, Wrap::MirroredRepeat};

/// One row of grey pixels.
Image row(const std::vector<int>& codes) {
    Image image{"", static_cast<int>(codes.size()), 1, {}};
    for (const int code : codes) {
        const auto byte = static_cast<std::uint8_t>(code);
        image.rgba.insert(image.rgba.end(), {byte, byte, byte, 255});
    }
    return image;
}

std::vector<int> redOf(const Image& image) {
    std::vector<int> codes;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
        codes.push_back(image.rgba[i]);
    return codes;
}

TEST(Resampled, KeepsColoursAndSlopes) {
    const glm::vec4 color(0.2f, 0.4f, 0.6f, 0.8f);
    const Image plain = paint(10, [&](glm::vec2) { return color; });
    for (const Wrap wrap : kWraps)
        for (const TextureContents contents : {TextureContents::Color, TextureContents::Numbers})
            EXPECT_EQ(resampled(plain, 16, 4, wrapping(wrap), contents).rgba,
                      paint(8, [&](glm::vec2) { return color; }).rgba);
    const Image ramp = paint(32, [](glm::vec2 uv) { return glm::vec4(uv.x); });
    const Image half = resampled(ramp, 16, 16, wrapping(Wrap::ClampToEdge), TextureContents::Numbers);
    for (std::size_t x = 1; x < 15; ++x)
        EXPECT_NEAR(half.rgba[4 * x], 255 * (static_cast<double>(x) + 0.5) / 16, 1.1) << x;
}

TEST(Resampled, AveragesLightOfColoursAndCodesOfNumbers) {
    // Of a repeating checker of single pixels, each pixel at half the size takes as much white as black.
    const Image fine = checkers(8, 8, glm::vec4(1), glm::vec4(0, 0, 0, 1));
    const auto half = [&](TextureContents contents) {
        return resampled(fine, 4, 4, wrapping(Wrap::Repeat), contents).rgba;
    };
    const auto all = [](glm::vec4 codes) { return paint(4, [&](glm::vec2) { return codes / 255.0f; }).rgba; };
    EXPECT_EQ(half(TextureContents::Color), all({188, 188, 188, 255}));
    EXPECT_EQ(half(TextureContents::Numbers), all({128, 128, 128, 255}));
    // Alpha is a number in colours as well.
    const Image holes = checkers(8, 8, glm::vec4(1), glm::vec4(1, 1, 1, 0));
    EXPECT_EQ(resampled(holes, 4, 4, wrapping(Wrap::Repeat), TextureContents::Color).rgba,
              all({255, 255, 255, 128}));
}

TEST(Resampled, EveryCodeThatIsAloneStays) {
    std::vector<int> codes(256);
    std::iota(codes.begin(), codes.end(), 0);
    for (const TextureContents contents : {TextureContents::Color, TextureContents::Numbers})
        for (const int code : codes)
            EXPECT_EQ(redOf(resampled(row({code, code, code}), 4, 1, {}, contents)),
                      std::vector<int>(4, code));
}

TEST(Resampled, GoesOnBeyondItsEdgesAsTheTextureDoes) {
    // Eight pixels to two: the tent is four pixels wide either way, and beyond each edge it weighs 3/32 and
    // 1/32.
    const auto scaled = [](const std::vector<int>& codes, Wrap wrap) {
        return redOf(resampled(row(codes), 2, 1, wrapping(wrap), TextureContents::Numbers));
    };
    const std::vector<int> second = {0, 255, 0, 0, 0, 0, 0, 0}; // Weighs 7/32 by itself.
    EXPECT_EQ(scaled(second, Wrap::ClampToEdge), (std::vector<int>{56, 0}));
    EXPECT_EQ(scaled(second, Wrap::Repeat), (std::vector<int>{56, 8}));
    EXPECT_EQ(scaled(second, Wrap::MirroredRepeat), (std::vector<int>{64, 0}));
    const std::vector<int> first = {255, 0, 0, 0, 0, 0, 0, 0}; // Weighs 5/32 by itself.
    EXPECT_EQ(scaled(first, Wrap::ClampToEdge), (std::vector<int>{72, 0}));
    EXPECT_EQ(scaled(first, Wrap::Repeat), (std::vector<int>{40, 24}));
    EXPECT_EQ(scaled(first, Wrap::MirroredRepeat), (std::vector<int>{64, 0}));
}

TEST(Resampled, EachAxisGoesOnByItsOwnWrap) {
    Image corner = paint(8, [](glm::vec2) { return glm::vec4(0, 0, 0, 1); });
    corner.rgba[0] = 255;
    const Texture texture = {.wrapS = Wrap::Repeat, .wrapT = Wrap::ClampToEdge};
    // 5/32 and 3/32 across, 9/32 and 0 down.
    EXPECT_EQ(redOf(resampled(corner, 2, 2, texture, TextureContents::Numbers)),
              (std::vector<int>{11, 7, 0, 0}));
}

TEST(Resampled, WhatRepeatsMayBeginAnywhere) {
    // Twelve columns to eight: three columns on are two columns on.
    const auto tile = [](float shift) {
        return paint(12, [=](glm::vec2 uv) {
            const float turn = 6.2831853f * (uv.x + shift);
            return glm::vec4(0.5f + 0.5f * std::sin(turn), 0.5f + 0.5f * std::cos(3 * turn), uv.y, 1);
        });
    };
    const auto scaled = [&](float shift, Wrap wrap) {
        return resampled(tile(shift), 8, 8, wrapping(wrap), TextureContents::Color);
    };
    const auto differsMost = [&](Wrap wrap) {
        const Image plain = scaled(0, wrap), shifted = scaled(0.25f, wrap);
        int most = 0;
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x)
                for (int channel = 0; channel < 4; ++channel)
                    most = std::max(most, std::abs(plain.rgba[4 * (8 * y + (x + 2) % 8) + channel] -
                                                   shifted.rgba[4 * (8 * y + x) + channel]));
        return most;
    };
    EXPECT_LE(differsMost(Wrap::Repeat), 1) << "the sines round differently";
    EXPECT_GT(differsMost(Wrap::ClampToEdge), 5);
}

TEST(Resampled, NormalsStayUnitVectors) {
    // Two slopes of 45 degrees against each other are flat in the mean, and not short.
    const Image ridge =
        checkers(8, 8, {0.5f + 0.3536f, 0.5f, 0.8536f, 1}, {0.5f - 0.3536f, 0.5f, 0.8536f, 1});
    const Image mean = resampled(ridge, 4, 4, wrapping(Wrap::Repeat), TextureContents::Normals);
    EXPECT_EQ(mean.rgba, paint(4, [](glm::vec2) { return glm::vec4(128, 128, 255, 255) / 255.0f; }).rgba);
    EXPECT_EQ(resampled(ridge, 4, 4, wrapping(Wrap::Repeat), TextureContents::Numbers).rgba[2], 218);

    const Image bumpy = resampled(bumps(48, 5), 32, 64, wrapping(Wrap::Repeat), TextureContents::Normals);
    for (std::size_t i = 0; i < bumpy.rgba.size(); i += 4) {
        const glm::vec3 normal(bumpy.rgba[i], bumpy.rgba[i + 1], bumpy.rgba[i + 2]);
        EXPECT_NEAR(glm::length(normal / 127.5f - 1.0f), 1, 0.007) << "half a code a channel";
    }
}

TEST(Mipmaps, AverageLightNotCodes) {
    const Image fine = checkers(4, 4, glm::vec4(1), glm::vec4(0, 0, 0, 1));
    const std::vector<Image> levels = mipmaps(fine, TextureContents::Color);
    ASSERT_EQ(levels.size(), 2u);
    EXPECT_EQ(levels[0].width, 2);
    EXPECT_EQ(levels[1].width, 1);
    // Half the light of white is code 188; half its code would be 128.
    EXPECT_EQ(std::vector<std::uint8_t>(levels[0].rgba.begin(), levels[0].rgba.begin() + 4),
              (std::vector<std::uint8_t>{188, 188, 188, 255}));
    EXPECT_EQ(levels[1].rgba[0], 188);
}

TEST(Mipmaps, OfNumbersAverageTheCodes) {
    const Image fine = checkers(4, 4, glm::vec4(1), glm::vec4(0, 0, 0, 1));
    for (const TextureContents contents : {TextureContents::Numbers, TextureContents::Normals}) {
        const std::vector<Image> levels = mipmaps(fine, contents);
        ASSERT_EQ(levels.size(), 2u);
        EXPECT_EQ(std::vector<std::uint8_t>(levels[0].rgba.begin(), levels[0].rgba.begin() + 4),
                  (std::vector<std::uint8_t>{128, 128, 128, 255}));
    }
}

TEST(Mipmaps, OddSizesLeaveNothingOut) {
    Image row{"", 5, 1, std::vector<std::uint8_t>(20, 0)};
    row.rgba[16] = row.rgba[19] = 255; // The last pixel is red.
    const std::vector<Image> levels = mipmaps(row, TextureContents::Color);
    ASSERT_EQ(levels.size(), 2u);
    ASSERT_EQ(levels[0].width, 2);
    EXPECT_EQ(levels[0].rgba[0], 0);
    EXPECT_EQ(levels[0].rgba[4], 170); // 2 / 5 of the light of the right half's 2.5 pixels.
    EXPECT_EQ(levels[1].rgba[0], 124); // A fifth of the whole row's.
}

TEST(Mipmaps, KeepEveryCodeThatIsAlone) {
    for (int code = 0; code < 256; ++code) {
        const auto byte = static_cast<std::uint8_t>(code);
        const Image flat{"", 3, 1, {byte, byte, byte, byte, byte, byte, byte, byte, byte, byte, byte, byte}};
        EXPECT_EQ(mipmaps(flat, TextureContents::Color)[0].rgba,
                  (std::vector<std::uint8_t>{byte, byte, byte, byte}))
            << code;
    }
}

} // namespace
} // namespace franken::test
