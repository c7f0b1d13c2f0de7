// SPDX-License-Identifier: MIT
// Effects of an application's, drawn: the two examples and each hook by a number, and what becomes of bad
// ones.
#include "franken/generator/effect.h"
#include "numbers.h"
#include "support/shell.h"

#include <algorithm>
#include <cmath>

namespace franken::test {
namespace {

using EffectsTest = PictureTest;
INSTANTIATE_TEST_SUITE_P(Backends, EffectsTest, allBackends(), backendName);

/// The built-in snippets with one effect.
SnippetSet setWith(const std::string& name, const std::string& text) {
    const Result<Effect> effect = Effect::parse(name, text, name + ".glsl");
    EXPECT_TRUE(effect) << toString(effect.error());
    const Result<SnippetSet> set = SnippetSet::builtIn().with(*effect);
    EXPECT_TRUE(set) << toString(set.error());
    return *set;
}

SnippetSet example(const std::string& name) {
    return setWith(name, readText(FRANKEN_SOURCE_DIR "/examples/effects/" + name + ".glsl"));
}

/// A renderer of a shot with an effect, which notes what it says.
struct Stage {
    Stage(const Gl& gl, const platform::Surface& surface, Shot shot, const SnippetSet& set,
          const std::string& name)
        : Stage(gl, surface, std::move(shot), set, name, Capabilities::query(gl)) {}

    Stage(const Gl& gl, const platform::Surface& surface, Shot shot, const SnippetSet& set,
          const std::string& name, const Capabilities& capabilities)
        : target{surface.framebuffer(), surface.size().width, surface.size().height},
          camera(shot.camera),
          renderer(gl, capabilities,
                   [this](LogLevel, std::string_view text) { log.append(text).append("\n"); }) {
        renderer.setSnippets(set);
        shot.look.effect = *set.chooseEffect(name);
        renderer.setLook(shot.look);
        renderer.setLighting(shot.lighting);
        EXPECT_TRUE(renderer.load(shot.scene));
    }

    Result<void> draw() { return renderer.draw(viewpointOf(camera, aspectOf(target)), target); }

    DrawTarget target;
    Camera camera;
    std::string log;
    Renderer renderer;
};

Material unlit(const glm::vec4& color) {
    Material material;
    material.unlit = true;
    material.factors.baseColor = toFloat4(color);
    return material;
}

/// Where the line of sight of a pixel meets the square, and the eye as seen from there.
glm::dvec3 toEye(int x, int y, int size, double distance) {
    const auto at = [size](int pixel) { return (pixel + 0.5) / size * 2 - 1; };
    return {-at(x), -at(y), distance};
}

/// The square fills the picture of an eye at that distance: an orthographic one's is far away.
Shot seenFrom(float distance, const Material& material) {
    Shot shot = filledBy(material);
    shot.camera.projection = Camera::Projection::Perspective;
    shot.camera.yfov = 2 * std::atan(1 / distance);
    shot.camera.world[3] = glm::vec4(0, 0, distance, 1);
    return shot;
}

void expectCodes(const std::array<int, 3>& codes, const glm::dvec3& linear, double tolerance = 1) {
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(codes[static_cast<std::size_t>(i)], 255 * std::clamp(linear[i], 0.0, 1.0), tolerance);
}

// Beer-Lambert: 2^(-density distance) of the surface's light is left.
TEST_P(EffectsTest, FogMixesByTheDistance) {
    Stage stage(gl(), surface(), seenFrom(3, unlit({0.8f, 0.6f, 0.2f, 1})), example("fog"), "fog");
    const glm::dvec3 base(0.8, 0.6, 0.2), fog(0.25, 0.5, 1);
    for (const double density : {0.0, 0.1, 1.0 / 3, 2.0}) {
        const Float4 value{0.25f, 0.5f, 1, static_cast<float>(density)};
        ASSERT_TRUE(stage.renderer.setEffectValues({{value}}));
        ASSERT_TRUE(stage.draw());
        const Picture picture = readBack();
        for (const int x : {picture.width / 2, 0, picture.width - 1}) {
            const double distance = glm::length(toEye(x, x, picture.width, 3));
            expectCodes(codesAt(picture, x, x), glm::mix(fog, base, std::exp2(-density * distance)));
        }
    }
    EXPECT_EQ(stage.log, "");
}

TEST_P(EffectsTest, FogIsTheSameWhateverTheWorldIsTurnedAndMovedBy) {
    Shot shot = seenFrom(3, unlit({1, 1, 1, 1}));
    shot.lighting.skyRotation = glm::dquat(0.5, 0.5, 0.5, 0.5);
    glm::dmat4 moved = glm::translate(glm::dmat4(1), {6378137.25, -4131346.5, 20});
    moved = glm::rotate(moved, 1.1, glm::normalize(glm::dvec3(1, -2, 3)));
    shot.camera.world = moved * shot.camera.world;
    shot.scene.instances[0].world = moved * shot.scene.instances[0].world;
    Stage stage(gl(), surface(), shot, example("fog"), "fog");
    ASSERT_TRUE(stage.renderer.setEffectValues({{Float4{0, 0, 0, 0.25f}}}));
    ASSERT_TRUE(stage.draw());
    expectCodes(codesOf(readBack()), glm::dvec3(std::exp2(-0.75)));
}

// Fragments of 16 bits get lengths in a unit of the frame's own.
TEST_P(EffectsTest, FogIsTheSameInFragmentsOf16Bits) {
    Capabilities capabilities = Capabilities::query(gl());
    capabilities.precision = Precision::Fp16;
    for (const float distance : {0.5f, 3.0f, 500.0f}) {
        Shot shot = seenFrom(distance, unlit({1, 1, 1, 1}));
        shot.camera.zfar = 1000;
        Stage stage(gl(), surface(), shot, example("fog"), "fog", capabilities);
        ASSERT_TRUE(stage.renderer.setEffectValues({{Float4{0, 0, 0, 0.75f / distance}}}));
        ASSERT_TRUE(stage.draw());
        expectCodes(codesOf(readBack()), glm::dvec3(std::exp2(-0.75)));
    }
}

TEST_P(EffectsTest, ARimIsAsBrightAsTheSurfaceTurnsAway) {
    for (const double degrees : {0.0, 30.0, 60.0, 80.0}) {
        SceneBuilder builder;
        const double angle = glm::radians(degrees);
        builder.add(square(), builder.addMaterial(unlit({0, 0, 0, 1})),
                    glm::mat4(glm::rotate(glm::dmat4(1), angle, glm::dvec3(0, 1, 0))));
        Stage stage(gl(), surface(), filledBy(builder), example("rim"), "rim");
        for (const double exponent : {1.0, 3.0}) {
            ASSERT_TRUE(
                stage.renderer.setEffectValues({{Float4{1, 0.5f, 0.25f, static_cast<float>(exponent)}}}));
            ASSERT_TRUE(stage.draw());
            const double facing = std::cos(angle); // All lines of sight are parallel.
            expectCodes(codesOf(readBack()), glm::dvec3(1, 0.5, 0.25) * std::pow(1 - facing, exponent));
        }
        EXPECT_EQ(stage.log, "");
    }
}

TEST_P(EffectsTest, TheBaseColourHookIsAFactor) {
    const SnippetSet set =
        setWith("tint", "//! declarations\nuniform vec4 uTint; // user: factor\n"
                        "//! base-color\nvec4 onBaseColor(vec4 base) {\n  return base * uTint;\n}\n");
    Material material;
    material.factors.baseColor = {0.8f, 0.4f, 0.2f, 1};
    SceneBuilder builder;
    builder.add(square(), builder.addMaterial(material));
    builder.addSun({0, 0, -1}, {1, 1, 1}, 3);
    Shot shot = filledBy(builder);
    shot.lighting = lightingOf(builder.scene);
    Stage stage(gl(), surface(), shot, set, "tint");
    ASSERT_TRUE(stage.renderer.setEffectValues({{Float4{0.5f, 1, 0.25f, 1}}}));
    ASSERT_TRUE(stage.draw());
    const auto codes = codesOf(readBack());
    shot.scene.materials[0].factors.baseColor = {0.4f, 0.4f, 0.05f, 1};
    const auto expected = codesOf(draw(shot));
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(codes[i], expected[i], 1);
}

// A surface that an effect makes rough is that of a rough material, in each form of the light.
TEST_P(EffectsTest, TheSurfaceHookIsTheMaterialsOwnFactors) {
    const SnippetSet set =
        setWith("wet", "//! declarations\nuniform vec4 uWet; // user: metalness, roughness, slope\n"
                       "//! surface\nvoid onSurface(inout vec3 normal, inout float metallic, "
                       "inout float roughness) {\n  normal = normalize(normal + vec3(uWet.z, 0.0, 0.0));\n"
                       "  metallic = uWet.x;\n  roughness = uWet.y;\n}\n");
    for (const Target form : kForms)
        for (const Brdf brdf : {Brdf::Gltf, Brdf::Seed, Brdf::Fast, Brdf::Schlick}) {
            Material material;
            material.factors.baseColor = {0.5f, 0.4f, 0.3f, 1};
            SceneBuilder builder;
            builder.add(square(), builder.addMaterial(material));
            builder.addSun({0.2f, -0.3f, -1}, {1, 1, 1}, 2);
            Shot shot = withForms(filledBy(builder), form);
            shot.lighting = lightingOf(builder.scene);
            shot.look.brdf = brdf;
            Stage stage(gl(), surface(), shot, set, "wet");
            ASSERT_TRUE(stage.renderer.setEffectValues({{Float4{0.25f, 0.45f, 0, 0}}}));
            ASSERT_TRUE(stage.draw());
            const auto codes = codesOf(readBack());
            ASSERT_TRUE(stage.renderer.setEffectValues({{Float4{0.25f, 0.45f, 0.5f, 0}}}));
            ASSERT_TRUE(stage.draw());
            EXPECT_NE(codesOf(readBack()), codes) << "another normal";
            shot.scene.materials[0].factors.metallic = 0.25f;
            shot.scene.materials[0].factors.roughness = 0.45f;
            const auto expected = codesOf(draw(shot));
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_NEAR(codes[i], expected[i], 1) << static_cast<int>(brdf);
            EXPECT_EQ(stage.log, "");
        }
}

TEST_P(EffectsTest, TheVertexHookMovesWhatIsSeenAndHandsItOn) {
    const SnippetSet set = setWith(
        "lift", "//! declarations\nuniform vec4 uLift; // user: metres\nvarying float vAt;\n"
                "//! vertex\nvec3 onVertex(vec3 position) {\n  vAt = position.x;\n"
                "  return position + uLift.xyz;\n}\n"
                "//! light\nvec3 onLight(vec3 color) {\n  return vec3(0.5 * vAt + 0.5, color.gb);\n}\n");
    Stage stage(gl(), surface(), filledBy(unlit({1, 1, 1, 1})), set, "lift");
    ASSERT_TRUE(stage.renderer.setEffectValues({{Float4{0, 1, 0, 0}}}));
    ASSERT_TRUE(stage.draw());
    const Picture picture = readBack();
    const int quarter = picture.height / 4;
    for (const int x : {1, picture.width / 2, picture.width - 2}) {
        EXPECT_EQ(codesAt(picture, x, 3 * quarter), (std::array{0, 0, 0})) << "the lower half is empty";
        expectCodes(codesAt(picture, x, quarter), {(x + 0.5) / picture.width, 1, 1});
    }
}

TEST_P(EffectsTest, APlaceHasValuesOfItsOwn) {
    SceneBuilder builder;
    builder.add(square(), builder.addMaterial(unlit({1, 1, 1, 1})),
                glm::scale(glm::mat4(1), glm::vec3(0.5f, 1, 1)));
    Stage stage(gl(), surface(), filledBy(builder), example("fog"), "fog");
    const Result<ModelId> model = stage.renderer.add(builder.scene);
    ASSERT_TRUE(model && stage.renderer.show({{*model}}));
    const PlaceId left = *stage.renderer.firstPlace(*model);
    ASSERT_TRUE(stage.renderer.setWorld(left, glm::translate(glm::dmat4(1), {-0.5, 0, 0})));
    ASSERT_TRUE(stage.renderer.addPlace(*model, glm::translate(glm::dmat4(1), {0.5, 0, 0})));
    const auto colours = [&] {
        EXPECT_TRUE(stage.draw());
        const Picture picture = readBack();
        return std::pair(codesAt(picture, picture.width / 4, 32)[0],
                         codesAt(picture, 3 * picture.width / 4, 32)[0]);
    };
    const std::array<Float4, 1> black{{{0, 0, 0, 100}}}, none{{{0, 0, 0, 0}}};
    ASSERT_TRUE(stage.renderer.setEffectValues(black));
    EXPECT_EQ(colours(), std::pair(0, 0));
    ASSERT_TRUE(stage.renderer.setEffectValues(left, none));
    EXPECT_EQ(colours(), std::pair(255, 0));
    ASSERT_TRUE(stage.renderer.setEffectValues(none));
    ASSERT_TRUE(stage.renderer.setEffectValues(left, black));
    EXPECT_EQ(colours(), std::pair(0, 255));
    ASSERT_TRUE(stage.renderer.setEffectValues(left, {}));
    EXPECT_EQ(colours(), std::pair(255, 255));
}

TEST_P(EffectsTest, ValuesAreChecked) {
    Renderer renderer(gl());
    const std::vector<Float4> five(5);
    const std::array<Float4, 1> nan{{{0, NAN, 0, 0}}};
    EXPECT_EQ(renderer.setEffectValues(five).error().code, "renderer.effect");
    EXPECT_EQ(renderer.setEffectValues(nan).error().where, "[0]");
    EXPECT_EQ(renderer.setEffectValues(PlaceId{1u << 30}, {}).error().code, "renderer.place");
}

/// An effect that some stage of a driver refuses: the picture is that without it, and the log says so.
void expectFallback(const Gl& gl, const platform::Surface& surface, const std::string& text, const char* code,
                    const char* told, const std::function<Picture()>& read) {
    const SnippetSet set = setWith("bad", text);
    Stage stage(gl, surface, filledBy(unlit({1, 0.5f, 0, 1})), set, "bad");
    const Result<void> drawn = stage.draw();
    EXPECT_TRUE(drawn) << toString(drawn.error());
    expectCodes(codesOf(read()), {1, 0.5, 0});
    ASSERT_EQ(stage.renderer.fallbacks().size(), 1u);
    const Fallback& fallback = stage.renderer.fallbacks().front();
    EXPECT_EQ(fallback.error.code, code);
    EXPECT_EQ(fallback.next->effect, EffectChoice{});
    EXPECT_NE(stage.log.find(told), std::string::npos) << stage.log;
    EXPECT_NE(stage.log.find("unlit+linear+bad@"), std::string::npos) << stage.log;
    EXPECT_NE(stage.log.find("drawn with unlit+linear instead"), std::string::npos) << stage.log;
    const unsigned compiles = stage.renderer.programCounters().compiles;
    EXPECT_TRUE(stage.draw());
    EXPECT_EQ(stage.renderer.programCounters().compiles, compiles) << "it is remembered";
}

TEST_P(EffectsTest, OneThatDoesNotCompileIsLeftOutAndToldWithItsLine) {
    expectFallback(gl(), surface(),
                   "//! light\nvec3 onLight(vec3 color) {\n  return color * nonsense(color);\n}\n",
                   "program.compile", "bad.glsl:3", [&] { return readBack(); });
}

TEST_P(EffectsTest, OneThatDoesNotDrawIsLeftOutAndTold) {
    expectFallback(
        gl(), surface(),
        "//! light\nvec3 onLight(vec3 color) {\n  if (color.r < 100.0)\n    discard;\n  return color;\n}\n",
        "program.draw", "draws nothing", [&] { return readBack(); });
}

TEST_P(EffectsTest, OneThatTheSetHasNotGotIsLeftOutAndTold) {
    Stage stage(gl(), surface(), filledBy(unlit({1, 0.5f, 0, 1})), example("fog"), "fog");
    stage.renderer.setSnippets(SnippetSet::builtIn());
    ASSERT_TRUE(stage.draw());
    expectCodes(codesOf(readBack()), {1, 0.5, 0});
    EXPECT_NE(stage.log.find("[effect.missing]"), std::string::npos) << stage.log;
}

TEST_P(EffectsTest, AWarmUpLeavesNothingToCompile) {
    const SnippetSet set = example("rim");
    Shot shot = filledBy(unlit({1, 1, 1, 1}));
    shot.look.effect = *set.chooseEffect("rim");
    Stage stage(gl(), surface(), shot, set, "rim");
    const Result<std::vector<ProgramUse>> uses = usesOf(shot.scene, shot.lighting, shot.look);
    ASSERT_TRUE(uses);
    const Result<WarmUpReport> report = stage.renderer.warmUp(stage.target, *uses);
    ASSERT_TRUE(report);
    EXPECT_EQ(report->failed, 0u);
    ASSERT_TRUE(stage.draw());
    EXPECT_TRUE(stage.renderer.takeMisses().empty());
}

} // namespace
} // namespace franken::test
