// SPDX-License-Identifier: MIT
// What is made of meshes and images before GL gets them.
#include "gpu_mesh.h"
#include "gpu_texture.h"
#include "mipmap.h"
#include "resample.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

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

TEST(Split, KeepsTrianglesAndTheirOrder) {
    const MeshData whole = interleave(sphere(10));
    for (const std::size_t most : {3u, 4u, 50u, 1000u}) {
        const std::vector<MeshData> parts = split(whole, most);
        EXPECT_EQ(unrolled(parts), unrolled({whole})) << most;
        for (const MeshData& part : parts)
            EXPECT_LE(part.vertices.size() / static_cast<std::size_t>(part.format.stride), most);
    }
    EXPECT_EQ(split(whole, 1000).size(), 1u);
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

TEST(Resampled, KeepsColoursAndSlopes) {
    const glm::vec4 color(0.2f, 0.4f, 0.6f, 0.8f);
    const Image plain = paint(10, [&](glm::vec2) { return color; });
    EXPECT_EQ(resampled(plain, 16, 4).rgba, paint(8, [&](glm::vec2) { return color; }).rgba);
    const Image ramp = paint(32, [](glm::vec2 uv) { return glm::vec4(uv.x); });
    const Image half = resampled(ramp, 16, 16);
    for (std::size_t x = 1; x < 15; ++x)
        EXPECT_NEAR(half.rgba[4 * x], 255 * (static_cast<double>(x) + 0.5) / 16, 1.1) << x;
}

TEST(SrgbMipmaps, AverageLightNotCodes) {
    const Image fine = checkers(4, 4, glm::vec4(1), glm::vec4(0, 0, 0, 1));
    const std::vector<Image> levels = srgbMipmaps(fine);
    ASSERT_EQ(levels.size(), 2u);
    EXPECT_EQ(levels[0].width, 2);
    EXPECT_EQ(levels[1].width, 1);
    // Half the light of white is code 188; half its code would be 128.
    EXPECT_EQ(std::vector<std::uint8_t>(levels[0].rgba.begin(), levels[0].rgba.begin() + 4),
              (std::vector<std::uint8_t>{188, 188, 188, 255}));
    EXPECT_EQ(levels[1].rgba[0], 188);
}

TEST(SrgbMipmaps, OddSizesLeaveNothingOut) {
    Image row{"", 5, 1, std::vector<std::uint8_t>(20, 0)};
    row.rgba[16] = row.rgba[19] = 255; // The last pixel is red.
    const std::vector<Image> levels = srgbMipmaps(row);
    ASSERT_EQ(levels.size(), 2u);
    ASSERT_EQ(levels[0].width, 2);
    EXPECT_EQ(levels[0].rgba[0], 0);
    EXPECT_EQ(levels[0].rgba[4], 170); // 2 / 5 of the light of the right half's 2.5 pixels.
    EXPECT_EQ(levels[1].rgba[0], 124); // A fifth of the whole row's.
}

TEST(SrgbMipmaps, KeepEveryCodeThatIsAlone) {
    for (int code = 0; code < 256; ++code) {
        const auto byte = static_cast<std::uint8_t>(code);
        const Image flat{"", 3, 1, {byte, byte, byte, byte, byte, byte, byte, byte, byte, byte, byte, byte}};
        EXPECT_EQ(srgbMipmaps(flat)[0].rgba, (std::vector<std::uint8_t>{byte, byte, byte, byte})) << code;
    }
}

} // namespace
} // namespace franken::test
