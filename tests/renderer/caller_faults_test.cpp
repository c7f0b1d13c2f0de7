// SPDX-License-Identifier: MIT
// More lights than a program takes, permutations that do not exist, and exceptions of an application.
#include "misuse_stage.h"

#include <stdexcept>

namespace franken::test {
namespace {

TEST(ManyLights, AreDrawnWithFour) {
    for (const std::size_t count : {5u, 6u, 40u, 256u, 260u}) {
        Stage stage;
        EXPECT_TRUE(stage.lit(sunny(count, 0))) << count;
        EXPECT_TRUE(stage.lit(sunny(0, count))) << count;
        EXPECT_TRUE(stage.lit(sunny(count, count))) << count;
        const Result<std::vector<ProgramUse>> uses = usesOf(ball(), sunny(count, count), {});
        ASSERT_TRUE(uses);
        EXPECT_EQ(uses->front().permutation.suns, 4);
        EXPECT_EQ(uses->front().permutation.punctualLights, 4);
    }
}

TEST(ManyLights, NearestSunsBecomeOneAndNoLightIsLost) {
    Lighting lighting;
    for (const Float3& direction :
         {Float3{1, 0, 0}, Float3{-1, 0, 0}, Float3{0, 1, 0}, Float3{0, -1, 0.1f}, Float3{0, -1, -0.1f}})
        lighting.suns.push_back({.direction = direction, .color = {1, 0.5f, 0}, .illuminance = 2});
    lighting.suns.back().illuminance = 4;
    const Lighting fitted = fittedLighting(lighting);
    ASSERT_EQ(fitted.suns.size(), 4u);
    const Sun& sum = fitted.suns[3];
    EXPECT_FLOAT_EQ(sum.color[0] * sum.illuminance, 6);
    EXPECT_FLOAT_EQ(sum.color[1] * sum.illuminance, 3);
    EXPECT_NEAR(sum.direction[1], -1, 0.01);
    EXPECT_NEAR(sum.direction[2], -0.0333, 0.001) << "weighted by irradiance";
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(fitted.suns[i].direction, lighting.suns[i].direction);
}

TEST(ManyLights, TheStrongestPunctualLightsRemain) {
    const Lighting fitted = fittedLighting(sunny(0, 9));
    ASSERT_EQ(fitted.punctualLights.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(fitted.punctualLights[i].intensity, float(6 + i));
}

TEST(ManyLights, AreToldOnce) {
    std::vector<std::string> messages;
    Renderer renderer(nullGl(), [&](LogLevel, std::string_view message) { messages.emplace_back(message); });
    for (int frame = 0; frame < 3; ++frame) {
        renderer.setLighting(sunny(5));
        renderer.setLighting(sunny(1));
    }
    EXPECT_EQ(messages.size(), 1u);
}

TEST(InvalidPermutation, HasANameAndNoProgram) {
    Permutation invalid;
    invalid.suns = 255;
    invalid.brdf = Brdf(99);
    EXPECT_NE(toName(invalid).find("suns=255"), std::string::npos) << toName(invalid);
    EXPECT_FALSE(canonicalise(invalid));
    const Gl gl = nullGl();
    ProgramCache cache(gl);
    EXPECT_EQ(cache.get(invalid).error().code, "permutation.range");
    cache.compileInBackground(invalid);
    EXPECT_EQ(cache.size(), 0u);
}

#ifdef __cpp_exceptions
[[noreturn]] void explode() { throw std::runtime_error("of the application"); }

TEST(Exceptions, OfSourcesAreErrors) {
    Stage stage;
    const Result<ModelId> model = stage.renderer.add(ball(), []() -> Result<Scene> { explode(); });
    const Result<PictureId> picture =
        stage.renderer.addPicture(white(2, 2), []() -> Result<Image> { explode(); });
    const SkyboxMap cube = whiteCube(16);
    EXPECT_TRUE(stage.renderer.setSkybox(&cube, []() -> Result<SkyboxMap> { throw 7; }));
    stage.renderer.memory().setBudget(0);
    EXPECT_TRUE(stage.renderer.memory().evictAll());
    stage.renderer.memory().setBudget(GpuMemory::kUnlimited);
    const Result<void> shown = stage.renderer.show({{*model}}, Wait::Yes);
    ASSERT_FALSE(shown);
    EXPECT_EQ(shown.error().code, "renderer.exception");
    EXPECT_NE(shown.error().what.find("of the application"), std::string::npos);
    EXPECT_TRUE(stage.draw()) << "the model before is still shown";
    EXPECT_EQ(stage.renderer.frameCounters().drawn + stage.renderer.frameCounters().culled, 1u);
    const OverlayQuad quad{.picture = *picture, .place = {}};
    EXPECT_EQ(stage.renderer.drawOverlay({&quad, 1}, kTarget).error().code, "renderer.exception");
    EXPECT_EQ(stage.renderer.restore(stage.gl).error().code, "renderer.exception") << "of the skybox";
    EXPECT_TRUE(stage.draw());
}

TEST(Exceptions, OfLogAndProgressAreDropped) {
    Renderer renderer(nullGl(), [](LogLevel, std::string_view) { explode(); });
    renderer.setLighting(sunny(9));
    Scene scene = ball();
    scene.images[0] = white(8000, 1);
    EXPECT_TRUE(renderer.load(scene)) << "a warning says that it is scaled down";
    const Result<std::vector<ProgramUse>> uses = usesOf(scene, sunny(9), {});
    EXPECT_TRUE(renderer.warmUp(kTarget, *uses, [](std::size_t, std::size_t) { explode(); }));
    EXPECT_TRUE(renderer.draw({}, kTarget));
}
#endif

} // namespace
} // namespace franken::test
