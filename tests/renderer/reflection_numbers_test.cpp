// SPDX-License-Identifier: MIT
// The sky as surfaces mirror it, in numbers that can be worked out by hand, and textures against factors.
#include "numbers.h"

#include <algorithm>
#include <cmath>

namespace franken::test {
namespace {

using ReflectionTest = PictureTest;
INSTANTIATE_TEST_SUITE_P(Backends, ReflectionTest, allBackends(), backendName);

constexpr std::uint8_t kMetallic = 51, kRoughness = 153; // 0.2 and 0.6

void useFactors(Material& material, float metallic = kMetallic / 255.0f,
                float roughness = kRoughness / 255.0f) {
    material.factors.metallic = metallic;
    material.factors.roughness = roughness;
}

Shot mirroring(const SceneBuilder& builder, ReflectionMaps maps) {
    Shot shot = filledBy(builder);
    shot.lighting.ambient.kind = Ambient::Sky;
    shot.lighting.reflection = Reflection::Lookup;
    shot.reflection = std::move(maps);
    return shot;
}

/// A material whose numbers are factors, or the same ones in textures; with an occlusion texture where there
/// is one.
SceneBuilder squareOf(bool textured, float occlusion = 1) {
    SceneBuilder builder;
    Material material;
    material.factors.baseColor = {0.8f, 0.5f, 0.2f, 1};
    useFactors(material);
    if (textured) {
        useFactors(material, 1, 1);
        material.textures[TextureRole::MetallicRoughness].texture =
            builder.addTexture(texel(0, kRoughness, kMetallic));
    }
    if (occlusion < 1) {
        const auto code = static_cast<std::uint8_t>(std::lround(255 * occlusion));
        material.textures[TextureRole::Occlusion].texture = builder.addTexture(texel(code, 0, 255));
    }
    builder.add(square(), builder.addMaterial(material));
    return builder;
}

/// A sky of one radiance, of which a surface is told how much it mirrors: F_0's factor, the rest, and how
/// much of it is the irradiance (level 0 looks alike everywhere).
ReflectionMaps plainMaps(std::uint8_t factor, std::uint8_t rest) {
    return {{texel(255, 255, 255, 128), 2}, texel(factor, rest, 0, 0)};
}

/// glTF 2.0, appendix B, under a sky of one radiance: the dielectric and the metal, mixed. A dielectric
/// scatters what it does not mirror at normal incidence.
double expectedOf(double base, double metallic, double factor, double rest, double sky) {
    const double mirrored = (0.04 * (1 - metallic) + base * metallic) * factor + rest;
    return sky * (mirrored + 0.96 * (1 - metallic) * base);
}

TEST_P(ReflectionTest, SharesAreThoseOfTheMaterial) {
    const double sky = 2 * std::pow(128 / 255.0, 2); // RGBM: the root times alpha, squared, times the range
    for (const bool textured : {false, true})
        for (const auto& [factor, rest] : {std::pair(204, 51), {255, 0}, {0, 102}}) {
            const Shot shot = mirroring(squareOf(textured), plainMaps(static_cast<std::uint8_t>(factor),
                                                                      static_cast<std::uint8_t>(rest)));
            const auto codes = codesOf(draw(shot));
            const double bases[] = {0.8, 0.5, 0.2};
            for (std::size_t channel = 0; channel < 3; ++channel)
                EXPECT_NEAR(codes[channel],
                            255 * expectedOf(bases[channel], 0.2, factor / 255.0, rest / 255.0, sky), 1)
                    << (textured ? "textures " : "factors ") << factor << ", channel " << channel;
        }
}

/// Dark below, bright at one side.
Environment unevenSky() {
    Environment sky{.width = 32, .height = 16, .texels = {}};
    for (int y = 0; y < sky.height; ++y)
        for (int x = 0; x < sky.width; ++x)
            sky.texels.push_back(y > 8 ? glm::vec3(0.02f, 0.05f, 0.1f)
                                       : glm::vec3(0.9f, 0.5f, 0.2f) * (std::abs(x - 10) < 3 ? 1.0f : 0.3f));
    return sky;
}

const ReflectionMaps& unevenMaps() {
    static const ReflectionMaps maps{filterReflection(unevenSky()), reflectionLookup()};
    return maps;
}

Shot ballUnder(SceneBuilder builder) {
    Shot shot = mirroring(builder, unevenMaps());
    shot.scene.meshes[0].primitives[0] = sphere(16);
    return shot;
}

TEST_P(ReflectionTest, TexturesAreAsFactors) {
    for (const auto& [metallic, roughness] :
         {std::pair(255, 25), {255, 102}, {255, 230}, {0, 51}, {128, 153}}) {
        SceneBuilder factors, textures;
        Material material;
        useFactors(material, static_cast<float>(metallic) / 255, static_cast<float>(roughness) / 255);
        factors.add(square(), factors.addMaterial(material));
        useFactors(material, 1, 1);
        material.textures[TextureRole::MetallicRoughness].texture = textures.addTexture(
            texel(0, static_cast<std::uint8_t>(roughness), static_cast<std::uint8_t>(metallic)));
        textures.add(square(), textures.addMaterial(material));
        const Difference difference = compareLit(draw(ballUnder(textures)), draw(ballUnder(factors)));
        EXPECT_GT(difference.pixels, 2000u);
        EXPECT_LE(difference.max(), 1) << metallic << ", " << roughness << ": " << difference;
    }
}

TEST_P(ReflectionTest, ARougherSurfaceSeesABlunterSky) {
    // What is brightest in a mirror's picture of a sky with a bright patch fades as the mirror becomes rough.
    int last = 256;
    for (const int roughness : {25, 90, 153, 255}) {
        SceneBuilder builder;
        Material material;
        useFactors(material, 1, 1);
        material.textures[TextureRole::MetallicRoughness].texture =
            builder.addTexture(texel(0, static_cast<std::uint8_t>(roughness), 255));
        builder.add(square(), builder.addMaterial(material));
        const Picture picture = draw(ballUnder(builder));
        int most = 0;
        for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
            most = std::max<int>(most, picture.rgba[i]);
        EXPECT_LT(most, last - 8) << roughness;
        last = most;
    }
}

TEST_P(ReflectionTest, OcclusionDarkensAllOfIt) {
    for (const bool textured : {false, true}) {
        const auto open = codesOf(draw(mirroring(squareOf(textured), plainMaps(204, 51))));
        const auto covered = codesOf(draw(mirroring(squareOf(textured, 0.4f), plainMaps(204, 51))));
        for (std::size_t channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(covered[channel], 0.4 * open[channel], 1) << textured;
    }
}

} // namespace
} // namespace franken::test
