// SPDX-License-Identifier: MIT
#include "franken/baked_sky.h"
#include "support/shell.h"

#include <bit>
#include <cmath>
#include <limits>

#include <sys/stat.h>

namespace franken {
namespace {

namespace fs = std::filesystem;

// Where numbers lie in the file.
constexpr std::size_t kVersion = 8, kCoefficients = 12, kHasSun = 120, kSun = 124, kFaceSize = 152,
                      kFaceRange = 156, kSize = 160, kRange = 164, kHead = 168;

Image pattern(int width, int height, unsigned seed) {
    Image image{"", width, height, {}};
    for (int i = 0; i < 4 * width * height; ++i)
        image.rgba.push_back(static_cast<std::uint8_t>((seed = seed * 1664525u + 1013904223u) >> 24));
    return image;
}

/// One whose parts all differ.
BakedSky makeSky() {
    BakedSky sky;
    for (std::size_t i = 0; i < 27; ++i)
        sky.coefficients[i / 3][i % 3] = static_cast<float>(i) - 9.25f;
    sky.sun = Sun{{0.1f, -0.9f, 0.3f}, {1, 0.5f, 0.25f}, 12345};
    sky.skybox = {4, 77, {}};
    for (unsigned face = 0; face < 6; ++face)
        sky.skybox.images[face] = pattern(4, 4, face);
    sky.reflection.atlas = {pattern(2 * kMinReflectionSize, reflectionHeight(kMinReflectionSize), 7), 66};
    sky.reflection.lookup = pattern(kLookupWidth, kLookupHeight, 8);
    return sky;
}

const std::vector<std::uint8_t>& bytes() {
    static const std::vector<std::uint8_t> all = encodeBakedSky(makeSky());
    return all;
}

std::string errorOf(const std::vector<std::uint8_t>& file) {
    const auto sky = decodeBakedSky(file);
    return sky ? "none" : sky.error().code;
}

std::vector<std::uint8_t> with(std::size_t offset, std::uint32_t value) {
    std::vector<std::uint8_t> file = bytes();
    for (std::size_t byte = 0; byte < 4; ++byte)
        file[offset + byte] = static_cast<std::uint8_t>(value >> (8 * byte));
    return file;
}

std::vector<std::uint8_t> with(std::size_t offset, float value) {
    return with(offset, std::bit_cast<std::uint32_t>(value));
}

TEST(BakedSky, ReadsBackWhatWasWritten) {
    const BakedSky written = makeSky();
    const auto read = decodeBakedSky(bytes());
    ASSERT_TRUE(read) << toString(read.error());
    EXPECT_EQ(read->coefficients, written.coefficients);
    ASSERT_TRUE(read->sun);
    EXPECT_EQ(read->sun->direction, written.sun->direction);
    EXPECT_EQ(read->sun->color, written.sun->color);
    EXPECT_EQ(read->sun->illuminance, written.sun->illuminance);
    EXPECT_EQ(read->skybox.size, 4);
    EXPECT_EQ(read->skybox.range, 77);
    for (std::size_t face = 0; face < 6; ++face)
        EXPECT_EQ(read->skybox.images[face].rgba, written.skybox.images[face].rgba);
    EXPECT_EQ(read->reflection.atlas.range, 66);
    EXPECT_EQ(read->reflection.atlas.image.width, written.reflection.atlas.image.width);
    EXPECT_EQ(read->reflection.atlas.image.height, written.reflection.atlas.image.height);
    EXPECT_EQ(read->reflection.atlas.image.rgba, written.reflection.atlas.image.rgba);
    EXPECT_EQ(read->reflection.lookup.rgba, written.reflection.lookup.rgba);
    EXPECT_EQ(encodeBakedSky(*read), bytes());
}

TEST(BakedSky, SunAndBackdropMayBeMissing) {
    BakedSky sky = makeSky();
    sky.sun.reset();
    sky.skybox = {};
    const auto read = decodeBakedSky(encodeBakedSky(sky));
    ASSERT_TRUE(read) << toString(read.error());
    EXPECT_FALSE(read->sun);
    EXPECT_EQ(read->skybox.size, 0);
}

TEST(BakedSky, RefusesAFileOfAnyOtherLength) {
    for (std::size_t length = 0; length <= kHead; ++length)
        EXPECT_EQ(errorOf({bytes().begin(), bytes().begin() + static_cast<std::ptrdiff_t>(length)}),
                  "sky.baked")
            << length;
    for (const std::size_t length : {kHead + 384, bytes().size() / 2, bytes().size() - 1})
        EXPECT_EQ(errorOf({bytes().begin(), bytes().begin() + static_cast<std::ptrdiff_t>(length)}),
                  "sky.baked")
            << length;
    std::vector<std::uint8_t> longer = bytes();
    longer.push_back(0);
    EXPECT_EQ(errorOf(longer), "sky.baked");
}

TEST(BakedSky, RefusesNumbersThatMeanNothing) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    for (std::size_t offset = kCoefficients; offset < kHead; offset += 4) {
        if (offset == kHasSun || offset == kFaceSize || offset == kSize)
            continue;
        for (const float value : {kNan, kInfinity, -kInfinity, 3e12f})
            EXPECT_EQ(errorOf(with(offset, value)), "sky.baked") << offset << " " << value;
    }
    for (const std::size_t offset : {kSun + 12, kSun + 24, kFaceRange, kRange})
        EXPECT_EQ(errorOf(with(offset, -1.0f)), "sky.baked") << offset;
    for (const std::uint32_t size : {0u, 255u, 257u, 1025u, 0x7FFFFFFFu, 0x80000000u, 0xFFFFFFFFu})
        EXPECT_EQ(errorOf(with(kSize, size)), "sky.baked") << size;
    for (const std::uint32_t size : {3u, 5u, 2048u, 2049u, 0x10000u, 0xFFFFFFFFu})
        EXPECT_EQ(errorOf(with(kFaceSize, size)), "sky.baked") << size;
    EXPECT_EQ(errorOf(with(kHasSun, 2u)), "sky.baked");
    EXPECT_EQ(errorOf(with(kVersion, 2u)), "sky.baked");
    EXPECT_EQ(errorOf(with(kVersion, 4u)), "sky.baked");
    EXPECT_EQ(errorOf(with(0, 0u)), "sky.baked");
}

TEST(BakedSky, LoadsFromAFileAndNamesIt) {
    const fs::path path = test::testFolder() / "baked.sky";
    const auto write = [&](const std::vector<std::uint8_t>& file) {
        std::ofstream(path, std::ios::binary)
            .write(reinterpret_cast<const char*>(file.data()), static_cast<std::streamsize>(file.size()));
    };
    write(bytes());
    const auto sky = loadSky(path);
    ASSERT_TRUE(sky) << toString(sky.error());
    EXPECT_EQ(encodeBakedSky(*sky), bytes());
    write(with(kRange, -1.0f));
    const auto broken = loadSky(path);
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.error().code, "sky.baked");
    EXPECT_EQ(broken.error().where, path.string());
    const auto missing = loadSky("no/such.sky");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, "sky.file");
}

TEST(BakedSky, APipeIsNotWaitedFor) {
    const fs::path pipe = test::emptyTestFolder() / "pipe.sky";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const auto sky = loadSky(pipe);
    ASSERT_FALSE(sky);
    EXPECT_EQ(sky.error().code, "sky.file");
}

} // namespace
} // namespace franken
