// SPDX-License-Identifier: MIT
#include "franken/reflection.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <gtest/gtest.h>

#include "sky_sampling.h"
#include "sky_shader.h"

namespace franken {
namespace {

namespace fs = std::filesystem;

const fs::path kShared = fs::path(FRANKEN_SOURCE_DIR) / ".." / "shared";

/// A white sky comes back as the lookup says, whatever the direction and the level.
TEST(Reflection, WhiteSkyStaysWhite) {
    Environment white{Environment::Layout::Equirect, 64, 32, std::vector<glm::vec3>(64 * 32, glm::vec3(1))};
    const ReflectionAtlas atlas = filterReflection(white);
    for (const glm::vec3& n : test::directions(50))
        for (const float roughness : {0.0625f, 0.2f, 0.5f, 1.0f})
            EXPECT_NEAR(test::skyThroughLobe(atlas, n, 2 * std::log2(roughness) + 8).g, 1, 0.01f);
}

/// The filter's footprint stays within a square, and the squares' edges meet: a smooth sky shows no seam.
TEST(Reflection, NoSeams) {
    Environment smooth{Environment::Layout::Equirect, 256, 128, {}};
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 256; ++x)
            smooth.texels.push_back(glm::vec3(1) + 0.5f * test::equirectDirection(256, x, y));
    const ReflectionAtlas atlas = filterReflection(smooth);
    for (const glm::vec3& d : test::directions(2000)) {
        const glm::vec2 around = glm::normalize(glm::vec2(d.x, d.z));
        const glm::vec3 horizon(around.x, 0.001f, around.y);
        for (const float level : {0.0f, 3.5f, 7.99f}) {
            const glm::vec3 above = test::skyThroughLobe(atlas, horizon, level),
                            below = test::skyThroughLobe(atlas, horizon * glm::vec3(1, -1, 1), level);
            EXPECT_LT(glm::length(above - below), 0.02f);
        }
    }
}

/// Against brute force with 4,096 samples. Within half a code of 8 bits, a step of the filter between texels
/// and what the sampling leaves; at grazing angles the reflectance bends too much for a texel's width.
TEST(Reflection, LookupMatchesBruteForce) {
    const Image lookup = reflectionLookup();
    for (const float roughness : {0.1f, 0.3f, 0.5f, 0.8f, 1.0f})
        for (const float nDotV : {0.03f, 0.1f, 0.3f, 0.6f, 1.0f}) {
            const glm::vec4 look = test::sample(lookup, {nDotV, roughness});
            const glm::vec2 truth = test::whiteSky(nDotV, roughness, 4096);
            EXPECT_NEAR(look.r, truth.x, 0.0045f) << roughness << " " << nDotV;
            EXPECT_NEAR(look.g, truth.y, 0.0045f) << roughness << " " << nDotV;
        }
}

class LitBySky : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        const fs::path file = kShared / "assets" / "env" / GetParam();
        if (!fs::exists(file))
            GTEST_SKIP() << file << " is not there";
        auto loaded = test::loadExposed(file);
        ASSERT_TRUE(loaded);
        sky = std::move(*loaded);
    }

    Environment sky; ///< Without its sun; a white surface is 0.5 in the mean.
};

/// What the sky sends to a surface that faces n, over pi: the sum over all of its texels.
glm::vec3 sumOfTexels(const Environment& sky, const glm::vec3& n) {
    constexpr float kPi = std::numbers::pi_v<float>;
    glm::vec3 sum(0);
    for (int y = 0; y < sky.height; ++y) {
        const float area = std::sin((static_cast<float>(y) + 0.5f) / static_cast<float>(sky.height) * kPi) *
                           2 * kPi * kPi / static_cast<float>(sky.width * sky.height);
        for (int x = 0; x < sky.width; ++x)
            sum += sky.texels[static_cast<std::size_t>(y * sky.width + x)] * area *
                   std::max(glm::dot(n, test::equirectDirection(sky.width, x, y)), 0.0f);
    }
    return sum / kPi;
}

/// The goal of the nine coefficients holds for the texels as well.
TEST_P(LitBySky, IrradianceMatchesBruteForce) {
    const ReflectionAtlas atlas = filterReflection(sky);
    double error = 0, light = 0;
    for (const glm::vec3& n : test::directions(64)) {
        const glm::vec3 truth = sumOfTexels(sky, n), off = test::skyLight(atlas, n) - truth;
        error += static_cast<double>(glm::dot(off, off));
        light += static_cast<double>(glm::dot(truth, truth));
    }
    const double relative = std::sqrt(error / light);
    RecordProperty("relative_rmse", std::to_string(relative));
    EXPECT_LE(relative, 0.02);
}

TEST_P(LitBySky, SpecularMatchesBruteForce) {
    for (const test::SkyError& error : test::skyErrors(sky, 100)) {
        const std::string row = error.material + ", roughness " +
                                std::to_string(error.roughness).substr(0, 3) + ", N.V " +
                                std::to_string(error.nDotV).substr(0, 3);
        RecordProperty(row, std::to_string(error.codes));
        EXPECT_LE(error.codes, test::goal(error)) << row;
    }
}

INSTANTIATE_TEST_SUITE_P(Skies, LitBySky, testing::Values("venice.hdr", "sunset.hdr"),
                         [](const auto& row) { return fs::path(row.param).stem().string(); });

/// The spheres of ../shared/reference/sky, and what the Khronos viewer's split sum leaves there.
TEST(Reflection, SpheresMatchTheReference) {
    const fs::path folder = kShared / "reference" / "sky";
    if (!fs::exists(folder))
        GTEST_SKIP() << folder << " is not there";
    const auto environment = loadEnvironment(kShared / "assets" / "env" / "venice.hdr");
    ASSERT_TRUE(environment);
    const ReflectionMaps sky{filterReflection(*environment), reflectionLookup()};
    struct Row {
        const char* file;
        float roughness;
        double khronos;
    };
    for (const Row& row : {Row{"metal_r0.1", 0.1f, 4.13},
                           {"metal_r0.4", 0.4f, 5.90},
                           {"metal_r0.6", 0.6f, 9.54},
                           {"metal_r1.0", 1.0f, 13.2}}) {
        const Image truth = test::readImage(folder / (std::string(row.file) + ".numpy.png"));
        ASSERT_EQ(truth.width, 256);
        double sum = 0;
        int count = 0;
        for (int i = 0; i < 256 * 256; i += 3) {
            const auto hit = test::hitSphere(i % 256, i / 256, 256);
            if (!hit || glm::dot(hit->normal, hit->toCamera) <= 0.05f)
                continue;
            const glm::vec3 seen = glm::round(test::codes(test::reflectedByShader(
                sky, hit->normal, hit->toCamera, row.roughness, test::skyMaterials().front())));
            for (int c = 0; c < 3; ++c)
                sum +=
                    std::abs(seen[c] - static_cast<float>(truth.rgba[static_cast<std::size_t>(4 * i + c)]));
            count += 3;
        }
        RecordProperty(row.file, std::to_string(sum / count));
        EXPECT_LE(sum / count, 0.5 * row.khronos) << row.file;
    }
}

TEST(Reflection, SameOnEveryRun) {
    Environment sky{Environment::Layout::Equirect, 64, 32, {}};
    for (int i = 0; i < 64 * 32; ++i)
        sky.texels.emplace_back(i % 7, i % 5, i % 3);
    float done = 0;
    const ReflectionAtlas first = filterReflection(sky, kReflectionSize, [&](float share) { done = share; });
    EXPECT_EQ(done, 1);
    EXPECT_EQ(first.image.rgba, filterReflection(sky).image.rgba);
}

/// The numbers of "const float kName = 1.0;" or "const vec2 kName = vec2(1.0, 2.0);" in a snippet.
std::vector<float> constantIn(const std::string& glsl, const std::string& name) {
    const std::size_t begin = glsl.find(" " + name + " = ") + name.size() + 4;
    std::string value = glsl.substr(begin, glsl.find(';', begin) - begin);
    for (const std::string cut : {"vec2(", ")", ","})
        if (const std::size_t at = value.find(cut); at != std::string::npos)
            value.replace(at, cut.size(), " ");
    std::istringstream numbers(value);
    return {std::istream_iterator<float>(numbers), {}};
}

/// The constants of the snippets are those of the atlas' layout.
TEST(Reflection, SnippetsKnowTheAtlas) {
    const auto snippet = [](const char* name) {
        std::ifstream file(std::string(FRANKEN_SOURCE_DIR "/generator/glsl/fragment/reflection/") + name);
        return std::string{std::istreambuf_iterator<char>(file), {}};
    };
    const std::string atlas = snippet("atlas.glsl"), irradiance = snippet("irradiance.glsl");
    const auto expect = [](const std::string& glsl, const char* name, std::vector<double> expected) {
        const std::vector<float> found = constantIn(glsl, name);
        ASSERT_EQ(found.size(), expected.size()) << name;
        for (std::size_t i = 0; i < found.size(); ++i)
            EXPECT_NEAR(found[i], expected[i], 1e-7) << name;
    };
    const double ratio = std::sqrt(0.5), all = 1 - std::pow(ratio, kReflectionLevels);
    expect(atlas, "kAtlasPoint", {1 / all});
    expect(atlas, "kAtlasHalf", {0.25, 0.5 * (1 - ratio) / all});
    expect(atlas, "kAtlasNext", {ratio});
    expect(atlas, "kAtlasInner", {kAtlasInner});
    expect(irradiance, "kIrradianceUpper", {13.0 / 16, 0.75});
    expect(irradiance, "kIrradianceLower", {15.0 / 16, 0.75});
    expect(irradiance, "kIrradianceHalf", {kAtlasInner / 16});
}

} // namespace
} // namespace franken
