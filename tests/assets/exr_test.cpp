// SPDX-License-Identifier: MIT
// OpenEXR skies: what tinyexr writes is read again, and what is broken is refused.
#include <algorithm>
#include <array>
#include <fstream>

#include <gtest/gtest.h>

#include "exr_file.h"
#include "franken/environment.h"
#include "image/exr.h"
#include "support/shell.h"

namespace franken {
namespace {

using test::exrBytes;
using test::ExrFile;
using test::int32;

constexpr std::size_t kRoom = std::size_t{64} << 20;

std::span<const std::uint8_t> bytesOf(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

std::string errorOf(const std::string& file, int maxSize = 8192, std::size_t room = kRoom) {
    const auto image = decodeExr(bytesOf(file), maxSize, room);
    return image ? "none" : image.error().code + ": " + image.error().what;
}

glm::vec3 written(int x, int y) {
    return {test::exrValue(3, x, y), test::exrValue(2, x, y), test::exrValue(1, x, y)};
}

void expectTexels(const FloatImage& image, int left = 0, int top = 0) {
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            ASSERT_EQ(image.texels[static_cast<std::size_t>(y * image.width + x)], written(x - left, y - top))
                << x << ", " << y;
}

/// The channel R of the first texel of a file that is not compressed, of floats.
std::string withFirstTexel(const ExrFile& file, const std::string& value) {
    std::string bytes = exrBytes(file);
    const std::size_t line = 8 + 4 * file.channels.size() * static_cast<std::size_t>(file.width);
    const std::size_t red = static_cast<std::size_t>(4 * 3 * file.width);
    return bytes.replace(bytes.size() - line * static_cast<std::size_t>(file.height) + 8 + red, 4, value);
}

class Compressed : public testing::TestWithParam<int> {};

TEST_P(Compressed, HalvesAndFloatsAreExact) {
    for (const bool half : {true, false}) {
        const auto image =
            decodeExr(bytesOf(exrBytes({.compression = GetParam(), .half = half})), 8192, kRoom);
        ASSERT_TRUE(image) << toString(image.error());
        ASSERT_EQ(image->width, 62);
        ASSERT_EQ(image->height, 31);
        expectTexels(*image);
    }
}

TEST_P(Compressed, TilesAreExact) {
    const ExrFile tiled{.width = 64, .height = 32, .compression = GetParam(), .tile = 16};
    const auto image = decodeExr(bytesOf(exrBytes(tiled)), 8192, kRoom);
    ASSERT_TRUE(image) << toString(image.error());
    ASSERT_EQ(image->width, 64);
    expectTexels(*image);
}

// Each start of a file, and each byte of the header and of some chunks turned over: an error or a picture.
TEST_P(Compressed, BrokenFilesAreRefused) {
    const std::string sound = exrBytes({.compression = GetParam()});
    for (std::size_t part = 0; part < 50; ++part)
        EXPECT_NE(errorOf(sound.substr(0, sound.size() * part / 50)), "none") << part << " of 50";
    EXPECT_NE(errorOf(sound.substr(0, sound.size() - 1)), "none");
    for (std::size_t at = 0; at < std::min<std::size_t>(sound.size(), 700); ++at)
        for (const unsigned flip : {0x01u, 0xFFu}) {
            std::string broken = sound;
            broken[at] = static_cast<char>(static_cast<unsigned char>(broken[at]) ^ flip);
            const auto image = decodeExr(bytesOf(broken), 8192, kRoom);
            if (image) {
                EXPECT_EQ(image->texels.size(),
                          static_cast<std::size_t>(image->width) * static_cast<std::size_t>(image->height));
            } else {
                EXPECT_FALSE(image.error().code.empty());
            }
        }
}

std::string compressionName(const testing::TestParamInfo<int>& row) {
    constexpr std::array kNames{"None", "Rle", "ZipLine", "Zip", "Piz"};
    return kNames[static_cast<std::size_t>(row.param)];
}

INSTANTIATE_TEST_SUITE_P(All, Compressed, testing::Range(0, 5), compressionName);

TEST(Exr, IsLoadedAsASky) {
    const auto path = test::testFolder() / "sky.exr";
    std::ofstream(path, std::ios::binary) << exrBytes({.compression = 3});
    const auto sky = loadEnvironment(path);
    ASSERT_TRUE(sky) << toString(sky.error());
    EXPECT_EQ(sky->layout, Environment::Layout::Equirect);
    EXPECT_EQ(sky->texels[62 * 7 + 5], written(5, 7));
}

TEST(Exr, GreyIsOneChannel) {
    const auto image = decodeExr(bytesOf(exrBytes({.channels = {"Y"}})), 8192, kRoom);
    ASSERT_TRUE(image) << toString(image.error());
    EXPECT_EQ(image->texels[62 + 3], glm::vec3(test::exrValue(0, 3, 1)));
}

// Both windows moved, the stored texels' alone, and a picture that is larger than what is stored.
TEST(Exr, WindowsHaveTheirPlaces) {
    for (const int compression : {0, 3, 4}) {
        const ExrFile file{.compression = compression};
        const std::string moved = test::movedData(exrBytes(file), file, -5, 40);
        const auto alone = decodeExr(bytesOf(moved), 8192, kRoom);
        ASSERT_TRUE(alone) << toString(alone.error());
        expectTexels(*alone);
        const auto both =
            decodeExr(bytesOf(test::withAttribute(moved, "displayWindow",
                                                  int32(-5) + int32(40) + int32(56) + int32(70))),
                      8192, kRoom);
        ASSERT_TRUE(both) << toString(both.error());
        expectTexels(*both);
        const auto larger =
            decodeExr(bytesOf(test::withAttribute(moved, "displayWindow",
                                                  int32(-7) + int32(39) + int32(60) + int32(80))),
                      8192, kRoom);
        ASSERT_TRUE(larger) << toString(larger.error());
        EXPECT_EQ(larger->width, 68);
        EXPECT_EQ(larger->texels[0], glm::vec3(0));
        EXPECT_EQ(larger->texels[68 + 1], glm::vec3(0));
        EXPECT_EQ(larger->texels[68 + 2], written(0, 0));
    }
}

TEST(Exr, TexelsOutOfRange) {
    const ExrFile floats{.half = false};
    const auto texel = [&](const std::string& value) {
        const auto image = decodeExr(bytesOf(withFirstTexel(floats, value)), 8192, kRoom);
        return image ? image->texels[0].r : -1.0f;
    };
    EXPECT_EQ(texel(int32(0x3F800000)), 1);
    EXPECT_EQ(texel(int32(static_cast<int>(0xBF800000))), 0) << "below 0";
    EXPECT_EQ(texel(int32(0x7F7FFFFF)), 1e9f) << "the largest float";
    EXPECT_EQ(errorOf(withFirstTexel(floats, int32(0x7F800000))), "exr.format: a texel is not finite");
    EXPECT_EQ(errorOf(withFirstTexel(floats, int32(0x7FC00000))), "exr.format: a texel is not finite");
}

TEST(Exr, WhatIsNotReadIsRefusedByName) {
    const std::string sound = exrBytes({});
    const auto version = [&](unsigned char flags) {
        std::string bytes = sound;
        bytes[5] = static_cast<char>(flags);
        return errorOf(bytes);
    };
    EXPECT_NE(version(0x08).find("deep"), std::string::npos);
    EXPECT_NE(version(0x10).find("several parts"), std::string::npos);
    EXPECT_NE(version(0x02).find("tiles"), std::string::npos);
    for (const auto& [code, name] :
         {std::pair{5, "PXR24"}, {6, "B44"}, {7, "B44A"}, {8, "DWAA"}, {9, "DWAB"}})
        EXPECT_NE(errorOf(test::withAttribute(sound, "compression", std::string(1, static_cast<char>(code))))
                      .find(std::string(" ") + name + ","),
                  std::string::npos)
            << name;
    EXPECT_NE(errorOf(exrBytes({.channels = {"Z"}})).find("no channels R, G and B"), std::string::npos);
    EXPECT_NE(errorOf(exrBytes({.channels = {"B", "R"}})).find("no channels R, G and B"), std::string::npos);
    EXPECT_NE(errorOf(exrBytes({.channels = std::vector<std::string>(17, "R")})).find("occurs twice"),
              std::string::npos);
}

TEST(Exr, LimitsHold) {
    const std::string sound = exrBytes({});
    EXPECT_EQ(errorOf(sound, 62), "none");
    EXPECT_EQ(errorOf(sound, 61).substr(0, 9), "exr.size:");
    EXPECT_EQ(errorOf(sound, 8192, 100000).substr(0, 10), "sky.limit:");
    const auto window = [&](int left, int right) {
        return errorOf(
            test::withAttribute(sound, "dataWindow", int32(left) + int32(0) + int32(right) + int32(30)));
    };
    EXPECT_EQ(window(0, 9000).substr(0, 9), "exr.size:");
    EXPECT_EQ(window(5, 4).substr(0, 9), "exr.size:");
    EXPECT_EQ(window(-2147483647, 2147483647).substr(0, 11), "exr.format:");
}

} // namespace
} // namespace franken
