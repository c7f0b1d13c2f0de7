// SPDX-License-Identifier: MIT
// Fine bumps from afar: the mips of roughness hold what the mips of a normal map lose.
#include "franken/normal_spread.h"
#include "model_fixture.h"
#include "support/shapes.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <thread>

namespace franken::test {
namespace {

constexpr glm::vec4 kEast{0.5f + 0.3536f, 0.5f, 0.8536f, 1}, kWest{0.5f - 0.3536f, 0.5f, 0.8536f, 1};

/// Slopes of 45 degrees against each other, a texel wide: their mean has the length cos 45.
Image ridge(int size) { return checkers(size, size, kEast, kWest); }

Image grey(int size, int code) {
    return paint(size, [&](glm::vec2) { return glm::vec4(static_cast<float>(code) / 255); });
}

TEST(NormalSpread, IsToksvigs) {
    const NormalSpread spread(ridge(8), 1);
    const double variance = (1 - std::sqrt(0.5)) / std::sqrt(0.5);
    for (const int code : {0, 51, 128, 255}) {
        const double roughness = code / 255.0;
        const double alpha2 = std::pow(roughness, 4) + NormalSpread::kWidening * variance;
        for (const int size : {4, 2, 1}) {
            Image level = grey(size, code);
            EXPECT_TRUE(spread.widens(level));
            spread.roughen(level, 1, 1);
            EXPECT_NEAR(level.rgba[1], 255 * std::min(1.0, std::pow(alpha2, 0.25)), 0.8) << code;
            EXPECT_EQ(level.rgba[0], code);
            EXPECT_EQ(level.rgba[2], code);
        }
    }
    Image whole = grey(8, 51);
    spread.roughen(whole, 1, 1);
    EXPECT_EQ(whole.rgba, grey(8, 51).rgba) << "no normal is lost there";
}

TEST(NormalSpread, FollowsTheFactorsAndTheSizeOfTheLevel) {
    const auto widened = [](const Image& normals, float scale, float factor, int width, int height) {
        Image level{"", width, height,
                    std::vector<std::uint8_t>(4u * static_cast<unsigned>(width * height), 102)};
        NormalSpread(normals, scale).roughen(level, 1, factor);
        return level;
    };
    const double variance = (1 - std::sqrt(0.5)) / std::sqrt(0.5);
    // A factor of half: the texture holds twice the roughness, and no more than 1.
    const double wide = std::pow(std::pow(0.2, 4) + NormalSpread::kWidening * variance, 0.25);
    EXPECT_EQ(widened(ridge(8), 1, 0.5f, 4, 4).rgba[1], 255);
    EXPECT_NEAR(widened(ridge(8), 1, 0.9f, 4, 4).rgba[1],
                255 / 0.9 * std::pow(std::pow(0.36, 4) + NormalSpread::kWidening * variance, 0.25), 0.8);
    EXPECT_LT(wide, 1);
    // Slopes of tan 45 times the scale.
    const double length = std::cos(std::atan(0.25));
    EXPECT_NEAR(widened(ridge(8), 0.25f, 1, 4, 4).rgba[1],
                255 * std::pow(std::pow(0.4, 4) + NormalSpread::kWidening * (1 - length) / length, 0.25),
                0.8);
    EXPECT_EQ(widened(ridge(8), 0, 1, 4, 4).rgba[1], 102) << "a scale of 0 is flat";
    EXPECT_EQ(widened(ridge(8), 1, 0, 4, 4).rgba[1], 102) << "nothing can widen it";
    EXPECT_EQ(widened(paint(8, [](glm::vec2) { return kEast; }), 1, 1, 2, 2).rgba[1], 102)
        << "all lean alike";
    // Flat on the left, bumpy on the right; levels of other shapes than the map's.
    const Image half = paint(16, [](glm::vec2 uv) {
        const bool even = (static_cast<int>(uv.x * 16) + static_cast<int>(uv.y * 16)) % 2 == 0;
        return uv.x < 0.5f ? glm::vec4(128, 128, 255, 255) / 255.0f : even ? kEast : kWest;
    });
    for (const glm::ivec2 size : {glm::ivec2(4, 4), {8, 2}, {6, 5}, {4, 16}, {2, 2}}) {
        const Image level = widened(half, 1, 1, size.x, size.y);
        for (int y = 0; y < size.y; ++y) {
            EXPECT_EQ(level.rgba[4 * (y * size.x) + 1], 102) << size.x << "x" << size.y;
            EXPECT_GT(level.rgba[4 * (y * size.x + size.x - 1) + 1], 150) << size.x << "x" << size.y;
        }
    }
}

/// Slopes of that deviation along each axis, each texel by itself.
Image noise(double deviation) {
    std::mt19937 random(7);
    const auto normal = [&] { // G. Box and M. Muller, 1958
        const double a = (static_cast<double>(random()) + 1) / 4294967297.0;
        const double b = static_cast<double>(random()) / 4294967296.0;
        return static_cast<float>(deviation * std::sqrt(-2 * std::log(a)) * std::cos(6.283185307179586 * b));
    };
    return paint(256, [&](glm::vec2) {
        const float x = normal(), y = normal();
        return glm::vec4(0.5f + 0.5f * glm::normalize(glm::vec3(x, y, 1)), 1);
    });
}

constexpr int kSmall = 40, kLarge = 8 * kSmall;

/// The middle of a golden ball of roughness 0.2, which is 256 pixels wide in all, or 2048 in the large
/// picture, where a pixel is about a texel of its normal map.
Shot ballWith(Image normals) {
    SceneBuilder builder;
    Material material;
    const auto put = [&](TextureRole role, Image image) {
        TextureRef& ref = material.textures[role];
        ref.texture = builder.addTexture(std::move(image));
        ref.transform = glm::mat3(24, 0, 0, 0, 12, 0, 0, 0, 1);
        ref.transformed = true;
    };
    put(TextureRole::Normal, std::move(normals));
    put(TextureRole::MetallicRoughness, paint(256, [](glm::vec2) { return glm::vec4(1, 0.2f, 1, 1); }));
    material.factors.baseColor = {0.9f, 0.7f, 0.5f, 1};
    builder.add(sphere(64), builder.addMaterial(material));
    Shot shot{.scene = builder.scene, .camera = {}, .lighting = {}};
    shot.camera.projection = Camera::Projection::Orthographic;
    shot.camera.xmag = shot.camera.ymag = kSmall / 256.0f;
    shot.camera.zfar = 10;
    shot.camera.world[3] = glm::vec4(0, 0, 3, 1);
    return shot;
}

/// A room with a window.
Environment room() {
    Environment sky{Environment::Layout::Equirect, 64, 32, {}};
    for (int i = 0; i < 64 * 32; ++i) {
        const int x = i % 64, y = i / 64;
        const float height = std::cos(3.1415927f * (static_cast<float>(y) + 0.5f) / 32);
        const glm::vec3 wall = glm::mix(glm::vec3(0.5f, 0.55f, 0.6f), glm::vec3(0.15f, 0.25f, 0.5f), height);
        const bool window = y > 8 && y < 13 && x > 20 && x < 28;
        sky.texels.push_back(window ? glm::vec3(4) : height > 0 ? wall : glm::vec3(0.12f, 0.1f, 0.08f));
    }
    return sky;
}

double toLight(int code) {
    const double value = code / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

std::uint8_t toCode(double light) {
    const double value = std::min(1.0, light);
    return static_cast<std::uint8_t>(
        std::lround(255 * (value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055)));
}

/// Means of 8 x 8 pixels, of light and so many times as bright.
Picture reduced(const Picture& large, double gain) {
    Picture small{"", kSmall, kSmall, {}};
    for (int i = 0; i < 4 * kSmall * kSmall; ++i) {
        const int x = i / 4 % kSmall, y = i / 4 / kSmall;
        double sum = 0;
        for (int j = 0; j < 64; ++j)
            sum += toLight(large.rgba[4 * ((8 * y + j / 8) * kLarge + 8 * x + j % 8) + i % 4]);
        small.rgba.push_back(i % 4 == 3 ? 255 : toCode(gain * sum / 64));
    }
    return small;
}

double brightness(const Picture& picture) {
    double sum = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); ++i)
        sum += i % 4 == 3 ? 0 : toLight(picture.rgba[i]);
    return sum;
}

class Sparkle : public PictureTest {
protected:
    Sparkle() : PictureTest({kLarge, kLarge}) {}

    Picture small(const Shot& shot) {
        const DrawTarget target{.framebuffer = surface().framebuffer(), .width = kSmall, .height = kSmall};
        drawShot(gl(), target, shot, Capabilities::query(gl()));
        const Picture all = readBack();
        Picture result{"", kSmall, kSmall, {}};
        for (int y = kLarge - kSmall; y < kLarge; ++y) // The target is at the bottom left.
            result.rgba.insert(result.rgba.end(), all.rgba.begin() + 4 * y * kLarge,
                               all.rgba.begin() + 4 * (y * kLarge + kSmall));
        return result;
    }

    struct Errors {
        double codes, brightness; ///< In the mean; over that of the large picture.
    };
    struct Found {
        Errors before, now;
    };
    /// `dim`: so many times darker is the large picture drawn, so that nothing in it is more than white.
    Found against(Shot shot, const std::string& name, float dim) {
        for (Sun& sun : shot.lighting.suns)
            sun.illuminance /= dim;
        const Picture truth = reduced(draw(shot), dim);
        for (Sun& sun : shot.lighting.suns)
            sun.illuminance *= dim;
        const auto errors = [&](bool widened) {
            shot.scene.normalsWidenRoughness = widened;
            const Picture picture = small(shot);
            const Errors found{compareLit(picture, truth).mean, brightness(picture) / brightness(truth)};
            std::cout << name << (widened ? " now: " : " before: ") << found.codes << " codes, "
                      << 100 * found.brightness << " %\n";
            if (widened)
                m_difference = writeDifference("sparkle_" + name, picture, truth);
            return found;
        };
        const Errors before = errors(false);
        return {before, errors(true)};
    }
    std::string m_difference;
};

// Both backends are one rasteriser, and a large picture takes it a second.
INSTANTIATE_TEST_SUITE_P(Backends, Sparkle, testing::Values(platform::Backend::OsMesa), backendName);

// kWidening was chosen on noise; the bumps were not looked at for that.
TEST_P(Sparkle, BumpsReflectARoomFromAfarAsTheyDoFromNear) {
    const Environment sky = room();
    const ReflectionMaps reflection{filterReflection(sky), reflectionLookup()};
    for (const auto& [name, normals] : {std::pair("noise", noise(0.3)), std::pair("bumps", bumps(256, 32))}) {
        Shot shot = ballWith(normals);
        shot.lighting.ambient = {.kind = Ambient::Sky, .sky = skyCoefficients(sky)};
        shot.lighting.reflection = Reflection::Lookup;
        shot.reflection = reflection;
        const Found found = against(shot, name, 1);
        EXPECT_GT(found.before.codes, 15);
        EXPECT_LE(found.now.codes, 5) << m_difference;
        EXPECT_NEAR(found.now.brightness, 1, 0.05) << m_difference;
    }
}

// GGX itself has no lobe like the sum of many: what is left is its tails, which no roughness takes away.
TEST_P(Sparkle, UnderASunAtLeastAThirdOfTheErrorIsGone) {
    Shot shot = ballWith(noise(0.3));
    shot.lighting.suns = {{.direction = {-0.2f, -0.3f, -0.93f}, .illuminance = 1}};
    const Found found = against(shot, "noise_in_the_sun", 40);
    EXPECT_LE(found.now.codes, 0.67 * found.before.codes) << m_difference;
    EXPECT_GT(std::abs(found.before.brightness - 1), 0.4);
    EXPECT_NEAR(found.now.brightness, 1, 0.1) << m_difference;
}

class WidenedModels : public ModelFixture {};
INSTANTIATE_TEST_SUITE_P(Backends, WidenedModels, allBackends(), backendName);

constexpr std::size_t kBytes = 4 * (64 * 64 + 32 * 32 + 16 * 16 + 8 * 8 + 4 * 4 + 2 * 2 + 1);

Image flat() {
    return paint(64, [](glm::vec2) { return glm::vec4(128, 128, 255, 255) / 255.0f; });
}

/// Two balls that share a roughness texture, beside a bumpy normal map and another one.
Scene twoBalls(const Image& other) {
    SceneBuilder builder;
    const int roughness = builder.addTexture(grey(64, 51));
    const std::array<int, 2> normals = {builder.addTexture(ridge(64)), builder.addTexture(other)};
    for (std::size_t i = 0; i < 2; ++i) {
        Material material;
        material.textures[TextureRole::Normal].texture = normals[i];
        material.textures[TextureRole::MetallicRoughness].texture = roughness;
        for (TextureRef& ref : material.textures)
            ref.transform = glm::mat3(8, 0, 0, 0, 8, 0, 0, 0, 1), ref.transformed = true;
        glm::mat4 world(0.5f);
        world[3] = glm::vec4(i == 0 ? -0.6f : 0.6f, 0, 0, 1);
        builder.add(sphere(12), builder.addMaterial(material), world);
    }
    return builder.scene;
}

Lighting sunny() {
    Lighting lighting;
    lighting.suns = {{.direction = {-0.3f, -0.3f, -1}, .illuminance = 0.5f}};
    return lighting;
}

TEST_P(WidenedModels, ATextureIsThereForEachNormalMapBesideIt) {
    const auto bytesOf = [&](const Scene& scene) {
        Renderer renderer(gl());
        EXPECT_TRUE(renderer.load(scene));
        return renderer.memory().used(MemoryUse::Textures);
    };
    Scene scene = twoBalls(flat());
    EXPECT_EQ(bytesOf(scene), 4 * kBytes);
    EXPECT_EQ(bytesOf(twoBalls(ridge(64))), 2 * kBytes) << "maps that are equal are one";
    scene.normalsWidenRoughness = false;
    EXPECT_EQ(bytesOf(scene), 3 * kBytes);
    scene.normalsWidenRoughness = true;
    scene.materials[1].unlit = true;
    EXPECT_EQ(bytesOf(scene), 4 * kBytes) << "for the unlit one as it is in the file";
    scene = twoBalls(flat());
    scene.textures[0].minFilter = Filter::Linear;
    EXPECT_EQ(bytesOf(scene), 2 * kBytes + 4 * 64 * 64) << "it has no mips";
    scene = twoBalls(flat());
    scene.materials[1].textures[TextureRole::Normal].transform[2] = glm::vec3(0.5f, 0, 1);
    EXPECT_EQ(bytesOf(scene), 4 * kBytes) << "other coordinates: as it is in the file";
    // A file may name any number of them.
    for (int i = 0; i < 20; ++i) {
        scene.materials.push_back(scene.materials[0]);
        scene.materials.back().factors.normalScale = 0.1f * static_cast<float>(i);
        scene.meshes.push_back(scene.meshes[0]);
        scene.meshes.back().primitives[0].material = static_cast<int>(scene.materials.size()) - 1;
        scene.instances.push_back(scene.instances[0]);
        scene.instances.back().mesh = static_cast<int>(scene.meshes.size()) - 1;
    }
    EXPECT_EQ(bytesOf(scene), 6 * kBytes) << "two normal maps, and four roughness textures";
    // Some files have a texture for each material, and one image for all of them.
    for (Material& material : scene.materials) {
        TextureRef& roughness = material.textures[TextureRole::MetallicRoughness];
        scene.textures.push_back(scene.textures[static_cast<std::size_t>(roughness.texture)]);
        roughness.texture = static_cast<int>(scene.textures.size()) - 1;
    }
    EXPECT_EQ(bytesOf(scene), 7 * kBytes) << "for all others as it is in the file";
}

TEST_P(WidenedModels, LookTheSameInStepsAndAfterALostContext) {
    const Scene scene = twoBalls(flat());
    const SceneSource source = [&] { return Result<Scene>(scene); };
    Renderer renderer(gl());
    renderer.setLighting(sunny());
    ASSERT_TRUE(renderer.load(scene, source));
    const Picture whole = drawn(renderer);
    Scene without = scene;
    without.normalsWidenRoughness = false;
    Renderer plain(gl());
    plain.setLighting(sunny());
    ASSERT_TRUE(plain.load(without));
    const auto left = [](int x, int) { return x < 30; };
    const auto right = [](int x, int) { return x > 34; };
    EXPECT_GT(compare(whole, drawn(plain), left).max(), 20);
    EXPECT_EQ(compare(whole, drawn(plain), right).max(), 0) << "its normals do not differ";

    const Result<ModelId> model = renderer.addInSteps(scene, source);
    ASSERT_TRUE(model);
    ASSERT_TRUE(renderer.show({{*model}}));
    for (int i = 0; i < 20'000 && !*renderer.isResident(*model); ++i) {
        ASSERT_TRUE(renderer.step());
        std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
    EXPECT_EQ(compareLit(drawn(renderer), whole).max(), 0);

    // Factors change uniforms; mips stay as they were made, through a lost context as well.
    Material material = *renderer.materialOf(*model, 0);
    material.factors.roughness = 0.8f;
    material.factors.normalScale = 0.5f;
    ASSERT_TRUE(renderer.setMaterial(*model, 0, material));
    const Picture changed = drawn(renderer);
    EXPECT_GT(compareLit(changed, whole).max(), 5);
    replaceContext({64, 64});
    renderer.contextLost();
    ASSERT_TRUE(renderer.restore(gl()));
    EXPECT_EQ(compareLit(drawn(renderer), changed).max(), 0);
}

TEST_P(WidenedModels, PixelsThatAreReplacedAreReplacedInAllCopies) {
    const Scene scene = twoBalls(flat());
    Renderer renderer(gl());
    renderer.setLighting(sunny());
    const Result<ModelId> model = renderer.add(scene, [&] { return Result<Scene>(scene); });
    ASSERT_TRUE(model);
    ASSERT_TRUE(renderer.show({{*model}}, Wait::Yes));
    ASSERT_TRUE(renderer.setTexture(*model, 0, grey(64, 200)));
    EXPECT_EQ(renderer.memory().used(MemoryUse::Textures), 3 * kBytes) << "both copies are one now";
    const Picture changed = drawn(renderer);
    Scene expected = scene;
    expected.images[0] = grey(64, 200);
    expected.normalsWidenRoughness = false;
    Renderer fresh(gl());
    fresh.setLighting(sunny());
    ASSERT_TRUE(fresh.load(expected));
    EXPECT_EQ(compareLit(changed, drawn(fresh)).max(), 0);
    ASSERT_TRUE(renderer.setTexture(*model, 0, grey(32, 200)));
    EXPECT_LT(renderer.memory().used(MemoryUse::Textures), 3 * kBytes);
    replaceContext({64, 64});
    renderer.contextLost();
    ASSERT_TRUE(renderer.restore(gl()));
    EXPECT_EQ(compareLit(drawn(renderer), changed).max(), 0);
}

TEST_P(WidenedModels, AMaterialThatComesToHaveAnotherNormalMapHasItsMips) {
    Scene scene = twoBalls(flat());
    Renderer renderer(gl());
    renderer.setLighting(sunny());
    const Result<ModelId> model = renderer.add(scene);
    ASSERT_TRUE(model);
    ASSERT_TRUE(renderer.show({{*model}}, Wait::Yes));
    Material material = *renderer.materialOf(*model, 0);
    material.textures = scene.materials[1].textures;
    ASSERT_TRUE(renderer.setMaterial(*model, 0, material));
    scene.materials[0] = material;
    Renderer fresh(gl());
    fresh.setLighting(sunny());
    ASSERT_TRUE(fresh.load(scene));
    EXPECT_EQ(compareLit(drawn(renderer), drawn(fresh)).max(), 0);
}

} // namespace
} // namespace franken::test
