// SPDX-License-Identifier: MIT
// Skies that nothing was fitted to: what is filtered is right and has no structure of its own.
#include "hard_skies.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "sky/tree.h"
#include "sky_sampling.h"
#include "sky_shader.h"

namespace franken {
namespace {

class HardSkies : public testing::TestWithParam<test::HardSky> {
protected:
    const Environment sky = test::makeHardSky(GetParam());
};

INSTANTIATE_TEST_SUITE_P(All, HardSkies, testing::ValuesIn(test::kHardSkies),
                         [](const auto& row) { return test::toString(row.param); });

double worstChannel(const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 apart = glm::abs(test::codes(a) - test::codes(b));
    return static_cast<double>(std::max({apart.r, apart.g, apart.b}));
}

/// A thirty-second of the tolerance: 3.9 to 4.3 times the nodes, and 1.8 for the sharpest lobe, which is as
/// narrow as four of the tree's leaves are wide.
TEST_P(HardSkies, AreConverged) {
    const SkyTree tree(sky);
    for (int level = 0; level <= kReflectionLevels; ++level) {
        const Lobe lobe = level == kReflectionLevels
                              ? Lobe::ofLambert()
                              : Lobe::ofRoughness(std::exp2(0.5f * static_cast<float>(level - 8)));
        for (const glm::vec3& d : test::directions(500))
            EXPECT_LE(worstChannel(tree.radiance(lobe, d), tree.radiance(lobe, d, SkyTree::kTolerance / 32)),
                      0.5)
                << "level " << level;
    }
}

/// The sum over all texels of the weights that Lobe documents, by other code: glTF's BRDF where N = V.
glm::vec3 plainSum(const Environment& sky, const glm::vec3& n, float roughness) {
    const double a2 = std::pow(static_cast<double>(roughness), 4);
    glm::dvec3 sum(0);
    double weights = 0;
    for (int y = 0; y < sky.height; ++y)
        for (int x = 0; x < sky.width; ++x) {
            const double cosine = static_cast<double>(glm::dot(n, test::equirectDirection(sky.width, x, y)));
            if (cosine <= 0)
                continue;
            const double nh2 = (1 + cosine) / 2, d = a2 / std::pow(nh2 * (a2 - 1) + 1, 2);
            const double weight = std::sin((y + 0.5) * std::numbers::pi / sky.height) * d * cosine /
                                  (cosine + std::sqrt(cosine * cosine * (1 - a2) + a2));
            sum += weight * glm::dvec3(sky.texels[static_cast<std::size_t>(y * sky.width + x)]);
            weights += weight;
        }
    return sum / weights;
}

/// The plain sum takes texels as points: at roughness 0.5 the lobe is twenty of them wide, and a lamp's edge
/// still makes a difference.
TEST_P(HardSkies, LevelsAreThePlainSum) {
    const SkyTree tree(sky);
    for (const float roughness : {0.5f, 1.0f})
        for (const glm::vec3& d : test::directions(64))
            EXPECT_LE(
                worstChannel(tree.radiance(Lobe::ofRoughness(roughness), d), plainSum(sky, d, roughness)),
                1.5)
                << "roughness " << roughness;
}

/// As the shader reads it, on the sphere of ../shared/reference, 64 x 64: white Lambert.
TEST_P(HardSkies, LambertIsRightAndSmooth) {
    const ReflectionAtlas atlas = filterReflection(sky);
    double sum = 0, worst = 0;
    int count = 0;
    for (int i = 0; i < 64 * 64; i += 7)
        if (const auto hit = test::hitSphere(i % 64, i / 64, 64)) {
            glm::vec3 truth(0);
            for (int y = 0; y < sky.height; ++y) {
                const float area =
                    static_cast<float>(std::sin((y + 0.5) * std::numbers::pi / sky.height) * 2 *
                                       std::numbers::pi * std::numbers::pi / (sky.width * sky.height));
                for (int x = 0; x < sky.width; ++x)
                    truth += sky.texels[static_cast<std::size_t>(y * sky.width + x)] *
                             (area * std::max(glm::dot(hit->normal, test::equirectDirection(sky.width, x, y)),
                                              0.0f));
            }
            const double codes = worstChannel(0.8f * test::skyLight(atlas, hit->normal),
                                              0.8f / std::numbers::pi_v<float> * truth);
            sum += codes;
            worst = std::max(worst, codes);
            ++count;
        }
    RecordProperty("mean_codes", std::to_string(sum / count));
    EXPECT_LE(sum / count, 1);
    EXPECT_LE(worst, 3) << "a pixel 4 codes off its neighbours would be more";
}

/// A quarter of (1 / alpha)^2 is what the filter between two codes of alpha errs by.
TEST_P(HardSkies, AlphaHasNoSteps) {
    const ReflectionAtlas atlas = filterReflection(sky);
    EXPECT_LE(atlas.range, std::max(kMinSkyRange, kMaxSkyContrast * 0.75f));
    for (std::size_t i = 3; i < atlas.image.rgba.size(); i += 4)
        ASSERT_GE(atlas.image.rgba[i], 16);
}

/// A cube's texels are summed as those of the panorama that it was made from.
TEST(SkyTree, TakesCubesToo) {
    const Environment panorama = test::makeHardSky(test::HardSky::SoftBoxes);
    Environment cube{Environment::Layout::Cube, 128, 6 * 128, {}};
    for (int y = 0; y < cube.height; ++y)
        for (int x = 0; x < 128; ++x)
            cube.texels.push_back(radianceFrom(panorama, test::faceTexelDirection(128, y / 128, x, y % 128)));
    const SkyTree one(panorama), other(cube);
    for (const glm::vec3& d : test::directions(100)) {
        EXPECT_LE(worstChannel(one.radiance(Lobe::ofLambert(), d), other.radiance(Lobe::ofLambert(), d)), 1);
        const Lobe lobe = Lobe::ofRoughness(0.4f);
        EXPECT_LE(worstChannel(one.radiance(lobe, d), other.radiance(lobe, d)), 2.5);
    }
}

TEST(SkyTree, ABlackSkyIsBlack) {
    const SkyTree tree({Environment::Layout::Equirect, 4, 2, std::vector<glm::vec3>(8, glm::vec3(0))});
    EXPECT_EQ(tree.radiance(Lobe::ofRoughness(0.1f), {0, 1, 0}), glm::vec3(0));
}

} // namespace
} // namespace franken
