// SPDX-License-Identifier: MIT
#include "franken/environment.h"
#include "support/shell.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "sky_sampling.h"
#include "sky_shader.h"

namespace franken {
namespace {

namespace fs = std::filesystem;

const fs::path kSkies = fs::path(FRANKEN_SOURCE_DIR) / ".." / "shared" / "assets" / "env";

/// The six main directions, in the order of a cube map's faces, and a colour for each.
const std::array<glm::vec3, 6> kAxes = {glm::vec3{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                        glm::vec3{0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
const std::array<glm::vec3, 6> kColors = {glm::vec3{1, 0, 0}, {0, 1, 1}, {0, 1, 0},
                                          glm::vec3{1, 0, 1}, {0, 0, 1}, {1, 1, 0}};

glm::vec3 colorOf(const glm::vec3& direction) {
    const auto nearest = std::max_element(kAxes.begin(), kAxes.end(), [&](const auto& a, const auto& b) {
        return glm::dot(a, direction) < glm::dot(b, direction);
    });
    return kColors[static_cast<std::size_t>(nearest - kAxes.begin())];
}

/// A sky by a formula, on the picture that the header of Environment describes.
Environment makeSky(int width, const std::function<glm::vec3(const glm::vec3&)>& radiance) {
    Environment sky{Environment::Layout::Equirect, width, width / 2, {}};
    for (int y = 0; y < sky.height; ++y)
        for (int x = 0; x < width; ++x)
            sky.texels.push_back(radiance(test::equirectDirection(width, x, y)));
    return sky;
}

LightsBlock pack(const Environment& sky) {
    LightsBlock block{};
    block.ambient = packAmbient({.kind = Ambient::Sky, .sky = skyCoefficients(sky)}, 1);
    return block;
}

/// Irradiance / pi, by a sum over all texels of an equirectangular sky.
glm::dvec3 irradianceByTexels(const Environment& sky, const glm::vec3& normal) {
    glm::dvec3 sum(0);
    for (int y = 0; y < sky.height; ++y) {
        const double polar = (y + 0.5) * std::numbers::pi / sky.height;
        const double area =
            std::sin(polar) * 2 * std::numbers::pi * std::numbers::pi / sky.width / sky.height;
        for (int x = 0; x < sky.width; ++x) {
            const double azimuth = ((x + 0.5) / sky.width - 0.5) * 2 * std::numbers::pi;
            const glm::dvec3 d(std::sin(polar) * std::sin(azimuth), std::cos(polar),
                               -std::sin(polar) * std::cos(azimuth));
            const double cosine = glm::dot(d, glm::dvec3(normal));
            if (cosine > 0)
                sum += glm::dvec3(sky.texels[static_cast<std::size_t>(y * sky.width + x)]) * (cosine * area);
        }
    }
    return sum / std::numbers::pi;
}

/// What shade_sky.glsl makes of a texel.
glm::vec3 decode(const SkyboxMap& cube, std::size_t face, int x, int y) {
    const std::uint8_t* texel = &cube.images[face].rgba[static_cast<std::size_t>(4 * (y * cube.size + x))];
    const glm::vec3 root =
        glm::vec3(texel[0], texel[1], texel[2]) * (static_cast<float>(texel[3]) / 65025.0f);
    return root * root * cube.range;
}

fs::path writeFile(const std::string& name, const std::string& bytes) {
    const fs::path path = test::testFolder() / name;
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
}

std::string hdrHeader(int width, int height) {
    return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " +
           std::to_string(width) + "\n";
}

/// A picture of squares, one texel each; a letter of the text is the index of a colour, others are black.
std::string hdrOfSquares(int width, const std::string& squares) {
    std::string bytes = hdrHeader(width, static_cast<int>(squares.size()) / width);
    for (const char square : squares) {
        const glm::vec3 color =
            square >= '0' && square <= '5' ? kColors[static_cast<std::size_t>(square - '0')] : glm::vec3(0);
        for (int i = 0; i < 3; ++i)
            bytes += static_cast<char>(color[i] > 0 ? 128 : 0);
        bytes += static_cast<char>(129);
    }
    return bytes;
}

std::string errorOf(const std::string& bytes) {
    const auto sky = loadEnvironment(writeFile("broken.hdr", bytes));
    return sky ? "none" : sky.error().code;
}

void expectAxes(const Environment& sky) {
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_EQ(radianceFrom(sky, kAxes[i] * 3.0f), kColors[i]) << "direction " << i;
}

TEST(Environment, EquirectHasItsDirections) {
    expectAxes(makeSky(64, colorOf));
    // The header's own example: +X lies at three quarters of the width.
    const Environment sky = makeSky(64, colorOf);
    EXPECT_EQ(sky.texels[static_cast<std::size_t>(16 * 64 + 48)], kColors[0]);
}

TEST(Environment, CrossesHaveTheirDirections) {
    const auto wide = loadEnvironment(writeFile("wide.hdr", hdrOfSquares(4, ".2.."
                                                                            "1405"
                                                                            ".3..")));
    ASSERT_TRUE(wide) << toString(wide.error());
    expectAxes(*wide);
    const auto high = loadEnvironment(writeFile("high.hdr", hdrOfSquares(3, ".2."
                                                                            "140"
                                                                            ".3."
                                                                            ".5.")));
    ASSERT_TRUE(high) << toString(high.error());
    expectAxes(*high);
}

TEST(Environment, FolderOfFaces) {
    const std::array<std::string, 6> names{"px", "nx", "py", "ny", "pz", "nz"};
    const fs::path folder = test::emptyTestFolder() / "faces";
    for (std::size_t i = 0; i < 6; ++i)
        writeFile("faces/sky_" + names[i] + ".hdr", hdrOfSquares(1, std::to_string(i)));
    const auto sky = loadEnvironment(folder);
    ASSERT_TRUE(sky) << toString(sky.error());
    expectAxes(*sky);

    writeFile("faces/other-px.hdr", hdrOfSquares(1, "0"));
    const auto twice = loadEnvironment(folder);
    ASSERT_FALSE(twice);
    EXPECT_EQ(twice.error().code, "sky.shape");
}

TEST(Environment, RunLengthCodedRows) {
    std::string bytes = hdrHeader(16, 8);
    for (int y = 0; y < 8; ++y)
        bytes += std::string("\x02\x02\x00\x10", 4) + // 16 texels in four channels
                 "\x90\x40"
                 "\x88\x20\x88\x80"
                 "\x10" +
                 "0123456789ABCDEF" + "\x90\x80";
    const auto sky = loadEnvironment(writeFile("runs.hdr", bytes));
    ASSERT_TRUE(sky) << toString(sky.error());
    EXPECT_EQ(sky->texels[0], glm::vec3(64, 32, '0') / 256.0f);
    EXPECT_EQ(sky->texels[127], glm::vec3(64, 128, 'F') / 256.0f);
}

TEST(Environment, BrokenFilesAreRefused) {
    const std::string good = hdrHeader(2, 1) + std::string(8, '\x40');
    EXPECT_EQ(errorOf(good), "none");
    EXPECT_EQ(errorOf(""), "image.format");
    EXPECT_EQ(errorOf("#?RADIANCE\n"), "hdr.format");
    EXPECT_EQ(errorOf(good.substr(0, good.size() - 1)), "hdr.format");
    EXPECT_EQ(errorOf(hdrHeader(100000, 50000)), "hdr.size");
    EXPECT_EQ(errorOf(hdrHeader(0, 0)), "hdr.size");
    EXPECT_EQ(errorOf(hdrHeader(8192, 4096) + std::string(1000, 'x')), "hdr.format");
    EXPECT_EQ(errorOf("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 2\n12345678"), "hdr.format");
    EXPECT_EQ(errorOf("#?RADIANCE\n\n+Y 1 +X 2\n12345678"), "hdr.format");
    EXPECT_EQ(errorOf(hdrHeader(8, 4) + std::string("\x02\x02\x00\x08\xff\x40", 6) + std::string(99, '\xff')),
              "hdr.format");
    EXPECT_EQ(errorOf(hdrOfSquares(5, "01234")), "sky.shape");
    const auto missing = loadEnvironment("no/such/sky.hdr");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, "sky.file");
    EXPECT_EQ(missing.error().where, "no/such/sky.hdr");
}

TEST(Environment, CoefficientsOfPlainSkies) {
    const LightsBlock grey = pack(makeSky(256, [](const glm::vec3&) { return glm::vec3(0.5f); }));
    const LightsBlock slope = pack(makeSky(256, [](const glm::vec3& d) { return glm::vec3(1.0f) + d; }));
    for (const glm::vec3& n : test::directions(20))
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(test::irradianceByCoefficients(grey, n)[i], 0.5, 1e-4);
            // A cosine lobe keeps 2/3 of what is linear in the direction.
            EXPECT_NEAR(test::irradianceByCoefficients(slope, n)[i], 1 + n[i] * 2 / 3, 2e-4);
        }
}

TEST(Environment, CubeHasItsDirections) {
    const SkyboxMap cube = encodeSkybox(makeSky(128, colorOf), 8);
    EXPECT_EQ(cube.range, kMinSkyRange);
    for (std::size_t face = 0; face < 6; ++face) {
        const glm::vec3 seen = decode(cube, face, 4, 4);
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(seen[i], kColors[face][i], 0.02f) << "face " << face;
    }
}

TEST(Environment, CubeKeepsTheLight) {
    const glm::vec3 bright = glm::normalize(glm::vec3(1, 2, 3));
    const Environment sky = makeSky(256, [&](const glm::vec3& d) {
        return glm::vec3(0.01f, 1.0f, 100.0f) * (0.5f + 0.5f * glm::dot(d, bright));
    });
    const SkyboxMap cube = encodeSkybox(sky, 32);
    EXPECT_NEAR(cube.range, 100.0f, 0.1f);
    for (std::size_t face = 0; face < 6; ++face)
        for (int i = 0; i < 32 * 32; ++i) {
            const glm::vec3 root = glm::sqrt(decode(cube, face, i % 32, i / 32) / cube.range);
            // Half a code of an 8-bit root, and as much of the brightest channel's.
            EXPECT_NEAR(root.g * 10, root.b, 6.0f / 255);
            EXPECT_NEAR(root.r * 100, root.b, 51.0f / 255);
        }
}

TEST(Environment, SunIsHandedOver) {
    const glm::vec3 towards = glm::normalize(glm::vec3(1, 2, -3));
    Environment sky = makeSky(512, [&](const glm::vec3& d) {
        return glm::dot(d, towards) > 0.9998f ? glm::vec3(10000, 8000, 5000) : glm::vec3(0.5f);
    });
    const LightsBlock before = pack(sky);
    const auto sun = takeSun(sky);
    ASSERT_TRUE(sun);
    EXPECT_NEAR(sun->color[0], 1, 1e-5);
    EXPECT_NEAR(sun->color[1], 0.8, 0.01);
    EXPECT_GT(-glm::dot(glm::vec3(sun->direction[0], sun->direction[1], sun->direction[2]), towards),
              0.99995f);
    // The sky lost what the sun has: its zeroth coefficient times 2 sqrt(pi) is the light from everywhere.
    const float lost = (before.ambient.sky[0][0] - pack(sky).ambient.sky[0][0]) * 4 *
                       std::numbers::pi_v<float> * kDielectricScatters;
    EXPECT_NEAR(lost / sun->illuminance, 1, 0.001);
    EXPECT_EQ(radianceFrom(sky, -towards), glm::vec3(0.5f));
    EXPECT_LT(radianceFrom(sky, towards).r, 100);
}

class RealSky : public testing::TestWithParam<const char*> {};

/// Two percent, because nine coefficients leave out 1-2 % of the power of a cosine lobe's light.
TEST_P(RealSky, CoefficientsMatchBruteForce) {
    const fs::path file = kSkies / GetParam();
    if (!fs::exists(file))
        GTEST_SKIP() << file << " is not there";
    const auto sky = loadEnvironment(file);
    ASSERT_TRUE(sky) << toString(sky.error());
    const LightsBlock block = pack(*sky);
    double error = 0, power = 0;
    for (const glm::vec3& n : test::directions(64)) {
        const glm::dvec3 truth = irradianceByTexels(*sky, n);
        const glm::dvec3 difference = test::irradianceByCoefficients(block, n) - truth;
        error += glm::dot(difference, difference);
        power += glm::dot(truth, truth);
    }
    RecordProperty("relative_rmse", std::to_string(std::sqrt(error / power)));
    EXPECT_LE(std::sqrt(error / power), 0.02);
}

INSTANTIATE_TEST_SUITE_P(Skies, RealSky, testing::Values("venice.hdr", "sunset.hdr"),
                         [](const auto& row) { return fs::path(row.param).stem().string(); });

/// The same sky as a panorama and as faces: clipped to 1, the panorama looks like the faces.
TEST(Environment, FacesMatchThePanorama) {
    if (!fs::exists(kSkies / "venice.hdr"))
        GTEST_SKIP() << kSkies << " is not there";
    std::array<fs::path, 6> files;
    for (std::size_t i = 0; i < 6; ++i)
        files[i] =
            kSkies / (std::string("venice_") + "pxnxpynypznz"[2 * i] + "pxnxpynypznz"[2 * i + 1] + ".png");
    const auto faces = loadEnvironment(files);
    const auto panorama = loadEnvironment(kSkies / "venice.hdr");
    ASSERT_TRUE(faces) << toString(faces.error());
    ASSERT_TRUE(panorama) << toString(panorama.error());

    const auto difference = [&](const glm::vec3& mirror) {
        double sum = 0;
        for (const glm::vec3& d : test::directions(5000)) {
            const glm::vec3 off =
                glm::abs(glm::min(radianceFrom(*panorama, d), 1.0f) - radianceFrom(*faces, d * mirror));
            sum += (off.r + off.g + off.b) / 3;
        }
        return sum / 5000;
    };
    EXPECT_LT(difference({1, 1, 1}), 0.03);
    for (const glm::vec3& mirror : {glm::vec3{-1, 1, 1}, {1, 1, -1}, {-1, 1, -1}, {1, -1, 1}})
        EXPECT_GT(difference(mirror), 0.06);
}

} // namespace
} // namespace franken
