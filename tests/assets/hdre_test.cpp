// SPDX-License-Identifier: MIT
// HDRE environments, written by the test as their description says.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>

#include "sky/hdre.h"
#include "support/shell.h"

namespace franken {
namespace {

constexpr std::size_t kRoom = std::size_t{16} << 20;

struct HdreFile {
    float version = 3;
    int width = 16, height = 16, channels = 3, bits = 32, headerBytes = 256, type = 3;
};

void put(std::string& bytes, std::uint32_t value, int count) {
    for (int i = 0; i < count; ++i)
        bytes += static_cast<char>(value >> 8 * i);
}

void put(std::string& bytes, float value) { put(bytes, std::bit_cast<std::uint32_t>(value), 4); }

/// Of a channel of a texel: each face has a colour, each channel another share of it, and levels differ.
float valueOf(int level, int face, int channel) {
    return static_cast<float>(100 * level + 10 * face + channel);
}

std::string headerBytes(const HdreFile& file) {
    std::string bytes = "HDRE";
    put(bytes, file.version);
    for (const int size : {file.width, file.height})
        put(bytes, static_cast<std::uint32_t>(size), 2);
    put(bytes, 0.0f);
    for (const int number : {file.channels, file.bits, file.headerBytes, 0})
        put(bytes, static_cast<std::uint32_t>(number), 2);
    put(bytes, 55.0f);
    put(bytes, static_cast<std::uint32_t>(file.type), 2);
    return bytes;
}

std::string hdreBytes(const HdreFile& file) {
    std::string bytes = headerBytes(file);
    bytes.resize(static_cast<std::size_t>(file.headerBytes));
    for (int level = 0; level < 6; ++level) {
        const int width = std::max(file.width >> level, file.version <= 2 ? 8 : 1);
        for (int face = 0; face < 6; ++face)
            for (int i = 0; i < width * width * file.channels; ++i)
                put(bytes, valueOf(level, face, i % file.channels));
    }
    return bytes;
}

Result<Environment> decode(const std::string& bytes, std::size_t room = kRoom) {
    return decodeHdre({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, 2048, room);
}

std::string errorOf(const std::string& bytes, std::size_t room = kRoom) {
    const auto sky = decode(bytes, room);
    return sky ? "none" : sky.error().code;
}

std::string errorOf(const HdreFile& claims) {
    const std::string header = headerBytes(claims);
    return errorOf(hdreBytes({}).replace(0, header.size(), header));
}

TEST(Hdre, EachVersionHasItsDirections) {
    for (const HdreFile& file :
         {HdreFile{.version = 1.5f, .headerBytes = 128}, HdreFile{.version = 1.5f, .headerBytes = 164},
          HdreFile{.version = 2}, HdreFile{.version = 2.5f, .channels = 4}, HdreFile{}}) {
        const auto sky = decode(hdreBytes(file));
        ASSERT_TRUE(sky) << file.version << ": " << toString(sky.error());
        ASSERT_EQ(sky->layout, Environment::Layout::Cube);
        ASSERT_EQ(sky->texels.size(), 6u * 16 * 16);
        const glm::vec3 axes[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
        for (int face = 0; face < 6; ++face)
            EXPECT_EQ(radianceFrom(*sky, axes[face]),
                      glm::vec3(valueOf(0, face, 0), valueOf(0, face, 1), valueOf(0, face, 2)));
    }
}

TEST(Hdre, IsLoadedAsASky) {
    const auto path = test::testFolder() / "sky.hdre";
    std::ofstream(path, std::ios::binary) << hdreBytes({});
    const auto sky = loadEnvironment(path);
    ASSERT_TRUE(sky) << toString(sky.error());
    EXPECT_EQ(sky->width, 16);
    // As one of six faces it is refused, with the file's name.
    const auto face = loadEnvironment(std::array{path, path, path, path, path, path});
    ASSERT_FALSE(face);
    EXPECT_EQ(face.error().code, "sky.shape");
    EXPECT_EQ(face.error().where, path.string());
}

TEST(Hdre, WhatIsNotReadIsRefused) {
    EXPECT_EQ(errorOf(HdreFile{}), "none");
    for (const float version : {0.0f, 0.9f, 4.0f, -3.0f, std::numeric_limits<float>::quiet_NaN(), 1e30f})
        EXPECT_EQ(errorOf(HdreFile{.version = version}), "hdre.format") << version;
    for (const int size : {0, -16, 15, 2049, 32767})
        EXPECT_EQ(errorOf(HdreFile{.width = size}), "hdre.size") << size;
    EXPECT_EQ(errorOf(HdreFile{.width = 2049, .height = 2049}), "hdre.size");
    EXPECT_EQ(errorOf(HdreFile{.width = 2048, .height = 2048}), "hdre.format") << "claims more than it has";
    for (const int channels : {0, 1, 2, 5, -3})
        EXPECT_EQ(errorOf(HdreFile{.channels = channels}), "hdre.format") << channels;
    EXPECT_EQ(errorOf(HdreFile{.type = 2}), "hdre.format");
    EXPECT_EQ(errorOf(HdreFile{.bits = 16}), "hdre.format");
    for (const int bytes : {0, 32, 128, 164, 255, 32767})
        EXPECT_EQ(errorOf(HdreFile{.headerBytes = bytes}), "hdre.format") << bytes;
}

TEST(Hdre, CutOffIsRefused) {
    const std::string sound = hdreBytes({});
    for (std::size_t part = 0; part < 50; ++part)
        EXPECT_EQ(errorOf(sound.substr(0, sound.size() * part / 50)), "hdre.format") << part << " of 50";
    EXPECT_EQ(errorOf(sound.substr(0, sound.size() - 1)), "hdre.format");
    EXPECT_EQ(errorOf(sound + "behind"), "none");
    EXPECT_EQ(errorOf(sound, 1000), "sky.limit");
}

TEST(Hdre, TexelsOutOfRange) {
    const auto with = [](float value) {
        std::string bytes = hdreBytes({}), number;
        put(number, value);
        return bytes.replace(256, 4, number);
    };
    EXPECT_EQ(errorOf(with(std::numeric_limits<float>::infinity())), "hdre.format");
    EXPECT_EQ(errorOf(with(std::numeric_limits<float>::quiet_NaN())), "hdre.format");
    EXPECT_EQ(decode(with(-1))->texels[0].r, 0);
    EXPECT_EQ(decode(with(1e30f))->texels[0].r, 1e9f);
}

} // namespace
} // namespace franken
