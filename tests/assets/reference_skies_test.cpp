// SPDX-License-Identifier: MIT
// Skies by others that nothing was fitted to: the spheres of ../shared/reference/skies, as the shaders
// compute them, against noise-free truth. Prints the tables of generator/docs/sky.md.
#include "franken/reflection.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "franken/generator/pack.h"
#include "sky_sampling.h"
#include "sky_shader.h"

namespace franken {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(FRANKEN_SOURCE_DIR) / ".." / "shared" / "reference" / "skies";
constexpr float kPi = std::numbers::pi_v<float>;

struct Pixel {
    test::Hit hit;
    glm::vec3 truth; ///< Codes
};

/// Every n-th pixel of a picture that sees the sphere at no grazing angle (N.V above 0.05).
std::vector<Pixel> pixelsOf(const fs::path& picture, int step) {
    const Image truth = test::readImage(picture);
    EXPECT_EQ(truth.width, 64) << picture;
    std::vector<Pixel> pixels;
    for (int i = 0; truth.width == 64 && i < 64 * 64; i += step) {
        const auto hit = test::hitSphere(i % 64, i / 64, 64);
        const std::uint8_t* const rgb = &truth.rgba[static_cast<std::size_t>(4 * i)];
        if (hit && glm::dot(hit->normal, hit->toCamera) > 0.05f)
            pixels.push_back({*hit, {rgb[0], rgb[1], rgb[2]}});
    }
    return pixels;
}

double difference(const glm::vec3& codes, const glm::vec3& others) {
    const glm::vec3 off = glm::abs(codes - others);
    return static_cast<double>(off.r + off.g + off.b) / 3;
}

/// Calls visit(direction, radiance times solid angle) for all texels above the horizon of n.
template<typename Visit>
void forEachTexel(const Environment& sky, const glm::vec3& n, const Visit& visit) {
    for (int y = 0; y < sky.height; ++y) {
        const float polar = (static_cast<float>(y) + 0.5f) * kPi / static_cast<float>(sky.height);
        const float area = std::sin(polar) * 2 * kPi * kPi / static_cast<float>(sky.width * sky.height);
        for (int x = 0; x < sky.width; ++x)
            if (const glm::vec3 l = test::equirectDirection(sky.width, x, y); glm::dot(n, l) > 0)
                visit(l, area * sky.texels[static_cast<std::size_t>(y * sky.width + x)]);
    }
}

/// The plain split sum (Karis, 2013): the sky through the lobe around the mirrored eye, weighted with N.L.
glm::vec3 splitSum(const Environment& sky, const test::Hit& hit, float roughness, const glm::vec3& f0) {
    const glm::vec3 r = 2 * glm::dot(hit.normal, hit.toCamera) * hit.normal - hit.toCamera;
    const float a2 = roughness * roughness * roughness * roughness;
    glm::vec3 light(0);
    float weights = 0;
    for (int y = 0; y < sky.height; ++y) {
        const float area = std::sin((static_cast<float>(y) + 0.5f) / static_cast<float>(sky.height) * kPi);
        for (int x = 0; x < sky.width; ++x) {
            const float cosine = glm::dot(r, test::equirectDirection(sky.width, x, y));
            if (cosine <= 0)
                continue;
            const float width = a2 * 0.5f * (1 + cosine) + 0.5f * (1 - cosine);
            const float weight = area * cosine / (width * width);
            light += weight * sky.texels[static_cast<std::size_t>(y * sky.width + x)];
            weights += weight;
        }
    }
    const glm::vec2 share = test::whiteSky(glm::dot(hit.normal, hit.toCamera), roughness, 1024);
    return light / weights * (f0 * share.x + share.y);
}

/// A dielectric of roughness 1 and base colour 0.8, glTF 2.0, appendix B: the sum over all texels.
glm::vec3 roughDielectric(const Environment& sky, const test::Hit& hit) {
    const float nDotV = glm::dot(hit.normal, hit.toCamera);
    glm::vec3 sum(0);
    forEachTexel(sky, hit.normal, [&](const glm::vec3& l, const glm::vec3& light) {
        const float nDotL = glm::dot(hit.normal, l);
        const float vDotH = std::sqrt(0.5f + 0.5f * glm::dot(hit.toCamera, l));
        const float fresnel = 0.04f + 0.96f * std::pow(1 - std::min(vDotH, 1.0f), 5.0f);
        sum += light * nDotL / kPi * (0.8f * (1 - fresnel) + fresnel * 0.5f / (nDotL + nDotV));
    });
    return sum;
}

class ReferenceSky : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        if (!fs::exists(kFolder))
            GTEST_SKIP() << kFolder << " is not there";
        auto loaded = loadEnvironment(kFolder / (name + ".hdr"));
        ASSERT_TRUE(loaded);
        environment = *std::move(loaded);
        sky = {filterReflection(environment), reflectionLookup()};
    }

    const std::string name = GetParam();
    Environment environment;
    ReflectionMaps sky;
};

INSTANTIATE_TEST_SUITE_P(Skies, ReferenceSky, testing::Values("softbox", "half", "studio", "sunset"));

/// Metals are half as far off as the split sum, or 2.5 codes. At roughness 0.2 no one lookup of a round lobe
/// comes so close under lamps with edges, however it is fitted (generator/docs/sky.md): there, 0.9 of it.
TEST_P(ReferenceSky, SpheresMatchTheTruth) {
    const bool lamps = name == "softbox" || name == "studio";
    for (const std::string file :
         {"metal_r0.2", "metal_r0.6", "metal_r1.0", "dielectric_r0.2", "dielectric_r0.6"}) {
        const float roughness = std::stof(file.substr(file.size() - 3));
        const float metallic = file.starts_with("metal") ? 1.0f : 0.0f;
        const test::SkyMaterial material{file, {0.9f, 0.5f, 0.2f}, metallic};
        double ours = 0, split = 0;
        const std::vector<Pixel> pixels = pixelsOf(kFolder / (name + "." + file + ".png"), 5);
        for (const auto& [hit, truth] : pixels) {
            const glm::vec3 scattered = kDielectricScatters * (1 - metallic) * material.baseColor *
                                        test::skyLight(sky.atlas, hit.normal);
            const auto codes = [&](const glm::vec3& reflected) {
                return glm::round(test::codes(scattered + reflected));
            };
            ours += difference(
                codes(test::reflectedByShader(sky, hit.normal, hit.toCamera, roughness, material)), truth);
            split += difference(codes(splitSum(environment, hit, roughness, material.f0())), truth);
        }
        const double count = static_cast<double>(pixels.size());
        std::cout << name << "." << file << ": " << ours / count << " codes, split sum " << split / count
                  << "\n";
        const double share = lamps && roughness < 0.3f ? 0.9 : 0.5;
        EXPECT_LE(ours / count, metallic > 0 ? std::max(2.5, share * split / count) : 2.5) << file;
    }
}

/// By the atlas and by nine coefficients, which cannot follow a studio's lamp: 5 codes are out of their reach
/// (generator/docs/sky.md). The reference is Lambert; the file beside it is a dielectric of roughness 1,
/// which is some other thing: how far its truth is from the reference is printed, and ours is held to that
/// truth.
TEST_P(ReferenceSky, MattSpheresMatchTheTruth) {
    LightsBlock lights{};
    lights.ambient = packAmbient({.kind = Ambient::Sky, .sky = skyCoefficients(environment)}, 1);
    const test::SkyMaterial material{"", glm::vec3(0.8f), 0};
    double atlas = 0, coefficients = 0, drawn = 0, file = 0;
    const std::vector<Pixel> pixels = pixelsOf(kFolder / (name + ".lambert0.8.png"), 17);
    for (const auto& [hit, truth] : pixels) {
        const glm::vec3 lambert = 0.8f * test::skyLight(sky.atlas, hit.normal);
        atlas += difference(glm::round(test::codes(lambert)), truth);
        coefficients += difference(
            test::codes(0.8f * glm::vec3(test::irradianceByCoefficients(lights, hit.normal))), truth);
        const glm::vec3 exact = test::codes(roughDielectric(environment, hit));
        file += difference(exact, truth);
        drawn += difference(test::codes(kDielectricScatters * lambert +
                                        test::reflectedByShader(sky, hit.normal, hit.toCamera, 1, material)),
                            exact);
    }
    const double count = static_cast<double>(pixels.size());
    std::cout << name << ".lambert0.8: " << atlas / count << " codes, by coefficients "
              << coefficients / count << "; dielectric of roughness 1: " << drawn / count
              << " codes, and its truth is " << file / count << " off Lambert\n";
    EXPECT_LE(atlas / count, 1);
    EXPECT_LE(coefficients / count, name == "studio" ? 17.1 : 5);
    EXPECT_LE(drawn / count, 1);
}

} // namespace
} // namespace franken
