// SPDX-License-Identifier: MIT
// What a scene that changes all the time costs: allocations, compiles, and memory that stays.
#include "franken/generator/effect.h"
#include "franken/overlay_text.h"
#include "franken/renderer.h"
#include "support/font_builder.h"
#include "support/gl_recorder.h"
#include "support/heap_count.h"
#include "support/null_gl.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <thread>

namespace franken::test {
namespace {

void makeMorph(Primitive& primitive) {
    Deformation deformation{.bind = {.positions = primitive.positions,
                                     .normals = primitive.normals,
                                     .tangents = primitive.tangents},
                            .targets = {{.positions = primitive.positions}}};
    measure(deformation);
    primitive.deformation = std::make_shared<const Deformation>(std::move(deformation));
}

/// Two variants, an opaque and a blended ball, textured; the latter swells.
Scene balls() {
    SceneBuilder builder;
    Material plain, glass, night;
    plain.textures[TextureRole::BaseColor].texture =
        builder.addTexture(checkers(16, 4, glm::vec4(1), glm::vec4(0.5f)));
    glass.alphaMode = AlphaMode::Blend;
    night.factors.emissive = {1, 0.5f, 0.2f};
    builder.add(sphere(4), builder.addMaterial(plain));
    builder.add(sphere(4), builder.addMaterial(glass), glm::translate(glm::mat4(1), {1, 0, 0}));
    builder.scene.variants = {"night"};
    builder.scene.meshes[0].primitives[0].variantMaterials = {builder.addMaterial(night)};
    builder.scene.nodes = {Node{.rest = {.local = {.translation = {1, 0, 0}}}}};
    builder.scene.instances[1].nodeIndex = 0;
    makeMorph(builder.scene.meshes[1].primitives[0]);
    builder.scene.nodes[0].rest.weights = {0};
    builder.scene.animations = {
        {.samplers = {{.times = {0, 1}, .values = {1, 0, 0, 2, 0, 0}}, {.times = {0, 1}, .values = {0, 1}}},
         .channels = {{}, {.sampler = 1, .path = AnimationChannel::Path::Weights}},
         .duration = 1}};
    return builder.scene;
}

constexpr char kTint[] = "//! declarations\nuniform vec4 uTint; // user: factor\n"
                         "//! base-color\nvec4 onBaseColor(vec4 base) {\n  return base * uTint;\n}\n";

Lighting skyLight() {
    Lighting lighting;
    lighting.suns = {{.direction = {-1, -1, -1}, .illuminance = 3, .ofSky = true}};
    lighting.ambient.kind = Ambient::Sky;
    return lighting;
}

Viewpoint viewpoint(int frame) {
    Camera camera;
    camera.world[3] = glm::dvec4(0, 0, 8 + 0.01 * frame, 1);
    return viewpointOf(camera, 1);
}

constexpr DrawTarget kTarget{.width = 64, .height = 64};

/// A renderer of a model at three places, and all that changes in a frame without another program.
struct Changing {
    explicit Changing(const Gl& gl) : renderer(gl) {
        renderer.setLighting(lighting);
        const SnippetSet snippets = *SnippetSet::builtIn().with(*Effect::parse("tint", kTint, "tint.glsl"));
        renderer.setSnippets(snippets);
        renderer.setLook({.effect = *snippets.chooseEffect("tint")});
        model = *renderer.add(scene, [] { return Result<Scene>(balls()); });
        places = {*renderer.firstPlace(model), *renderer.addPlace(model), *renderer.addPlace(model)};
        EXPECT_TRUE(renderer.show({{model}}, Wait::Yes));
        material = *renderer.materialOf(model, 0);
    }

    Result<void> draw(int frame) {
        const double angle = 0.01 * frame;
        const glm::dmat4 world = glm::rotate(glm::dmat4(1), angle, glm::dvec3(0, 1, 0));
        material.factors.baseColor[0] = 0.5f + 0.4f * static_cast<float>(std::sin(angle));
        lighting.skyRotation = glm::angleAxis(angle, glm::dvec3(0, 1, 0));
        renderer.setLighting(lighting);
        FirstOf first;
        first.add(renderer.setWorld(places[0], world));
        first.add(renderer.setVisible(places[1], frame % 3 != 0));
        first.add(sample(scene, 0, 0.01 * frame, pose, Ends::Loop));
        first.add(renderer.setPose(places[1], pose));
        first.add(renderer.setMaterial(model, 0, material));
        const std::array<Float4, 1> tint{{{1, material.factors.baseColor[0], 1, 1}}};
        first.add(renderer.setEffectValues(tint));
        first.add(renderer.setEffectValues(
            places[2], std::span<const Float4>(tint).first(static_cast<std::size_t>(frame % 2))));
        first.add(outcome(renderer.step()));
        first.add(renderer.draw(viewpoint(frame), kTarget));
        return first.result;
    }

    static Result<void> outcome(const Result<StepReport>& report) {
        return report ? Result<void>() : Result<void>(report.error());
    }

    struct FirstOf {
        Result<void> result;
        void add(const Result<void>& next) {
            if (result && !next)
                result = next;
        }
    };

    const Scene scene = balls();
    Renderer renderer;
    Lighting lighting = skyLight();
    Pose pose;
    ModelId model{};
    std::vector<PlaceId> places;
    Material material;
};

TEST(ChangingScene, AFrameAllocatesNothingAndCompilesNothing) {
    Changing scene(recordingGl(nullGl()));
    for (int frame = 0; frame < 6; ++frame)
        ASSERT_TRUE(scene.draw(frame));
    const unsigned compiles = scene.renderer.programCounters().compiles;
    recordedCalls().clear();
    for (int frame = 6; frame < 1006; ++frame)
        ASSERT_TRUE(scene.draw(frame));
    EXPECT_EQ(scene.renderer.programCounters().compiles, compiles);
    EXPECT_EQ(countCalls("CompileShader") + countCalls("LinkProgram"), 0u);
    EXPECT_GE(countCalls("Uniform4fv"), 3000u) << "the effect's values among them";
    EXPECT_EQ(countCalls("BufferData") + countCalls("TexImage2D"), 0u);
    EXPECT_GE(countCalls("BufferSubData"), 600u) << "where the place is visible";

    Changing quiet(nullGl()); // The recorder allocates.
    for (int frame = 0; frame < 6; ++frame)
        ASSERT_TRUE(quiet.draw(frame));
    const std::size_t before = heapCount().calls;
    bool drawn = true;
    for (int frame = 6; frame < 1006; ++frame)
        drawn = static_cast<bool>(quiet.draw(frame)) && drawn;
    const std::size_t after = heapCount().calls;
    EXPECT_TRUE(drawn);
    EXPECT_EQ(after - before, 0u);
}

TEST(ChangingScene, AnOverlayThatIsUpdatedAllocatesNothing) {
    Renderer renderer(nullGl());
    Image frame = checkers(32, 4, glm::vec4(1), glm::vec4(0)),
          part = checkers(8, 2, glm::vec4(1), glm::vec4(0));
    const Result<PictureId> picture = renderer.addPicture(frame);
    ASSERT_TRUE(picture);
    const std::vector<OverlayQuad> quads(20, {.picture = *picture, .place = {0, 0, 16, 16}});
    const auto draw = [&](int number) {
        frame.rgba[0] = static_cast<std::uint8_t>(number);
        return renderer.draw(viewpoint(number), kTarget) && renderer.updatePicture(*picture, frame) &&
               renderer.updatePicture(*picture, part, number % 24, 3) && renderer.drawOverlay(quads, kTarget);
    };
    bool drawn = draw(0) && draw(1);
    const std::size_t before = heapCount().calls;
    for (int number = 2; number < 1002; ++number)
        drawn = draw(number) && drawn;
    const std::size_t after = heapCount().calls;
    EXPECT_TRUE(drawn);
    EXPECT_EQ(after - before, 0u);
}

TEST(ChangingScene, ATextOfKnownGlyphsAllocatesAndUploadsNothing) {
    const Result<Font> font = parseFont(soundFont().bytes());
    ASSERT_TRUE(font);
    Renderer renderer(recordingGl(nullGl())), quietRenderer(nullGl()); // The recorder allocates.
    const auto changes = [&](Renderer& of) {
        return [&of,
                texts = std::make_shared<OverlayText>(of, OverlayTextOptions{.log = [](LogLevel, auto) {}}),
                id = TextId{}, &font](int number) mutable {
            constexpr const char* kTexts[] = {"AVA BVB", "oo\nA",
                                              "A longer \xC3\xA9 text of AVBo that is wrapped", ""};
            if (number == 0)
                id = *texts->add({.font = *font, .utf8 = kTexts[2], .style = {.pixels = 12, .width = 100}});
            const Result<void> done[] = {texts->set(id, kTexts[number % 4]),
                                         texts->setPlace(id, 1, float(number)),
                                         texts->setColor(id, {1, 1, 1, 0.5f}), texts->draw(kTarget)};
            return std::all_of(std::begin(done), std::end(done),
                               [](const auto& result) { return bool(result); });
        };
    };
    auto change = changes(renderer), quietChange = changes(quietRenderer);
    bool drawn = true;
    for (int number = 0; number < 8; ++number)
        drawn = change(number) && quietChange(number) && drawn;
    recordedCalls().clear();
    for (int number = 8; number < 108; ++number)
        drawn = change(number) && drawn;
    EXPECT_EQ(countCalls("TexSubImage2D") + countCalls("TexImage2D"), 0u);
    EXPECT_EQ(countCalls("DrawElements"), 75u) << "three of four have glyphs: one draw each";
    const std::size_t before = heapCount().calls;
    for (int number = 8; number < 1008; ++number)
        drawn = quietChange(number) && drawn;
    const std::size_t after = heapCount().calls;
    EXPECT_TRUE(drawn);
    EXPECT_EQ(after - before, 0u);
}

/// Steps until all is there; the programs that were made.
unsigned finish(Renderer& renderer) {
    unsigned programs = 0;
    for (bool more = true; more; std::this_thread::yield()) {
        const Result<StepReport> report = renderer.step();
        EXPECT_TRUE(report) << toString(report.error());
        programs += report ? report->programs : 0;
        more = report && report->more;
    }
    return programs;
}

// A model that comes in steps compiles nothing that was there, and no frame on its way allocates.
TEST(ChangingScene, AFrameAllocatesNothingWhileAModelComesInSteps) {
    Changing scene(nullGl());
    ASSERT_TRUE(scene.renderer.addInSteps(balls()));
    EXPECT_GT(finish(scene.renderer), 0u) << "those of the variant";
    for (int frame = 0; frame < 6; ++frame)
        ASSERT_TRUE(scene.draw(frame));
    const unsigned compiles = scene.renderer.programCounters().compiles;
    std::size_t frames = 0, allocations = 0;
    for (int round = 0; round < 20; ++round) {
        const Result<ModelId> coming = scene.renderer.addInSteps(balls());
        ASSERT_TRUE(coming);
        for (bool more = true; more; ++frames) {
            const Result<StepReport> report = scene.renderer.step();
            ASSERT_TRUE(report);
            EXPECT_EQ(report->programs, 0u);
            more = report->more;
            const std::size_t before = heapCount().calls;
            const bool drawn = bool(scene.renderer.draw(viewpoint(6), kTarget));
            allocations += more ? heapCount().calls - before : 0; // The frame after the last step sorts anew.
            EXPECT_TRUE(drawn);
        }
        EXPECT_TRUE(*scene.renderer.isResident(*coming));
        scene.renderer.remove(*coming);
        ASSERT_TRUE(scene.renderer.draw(viewpoint(6), kTarget));
    }
    EXPECT_GT(frames, 100u);
    EXPECT_EQ(allocations, 0u);
    EXPECT_EQ(scene.renderer.programCounters().compiles, compiles);
}

void loseContext(Renderer& renderer) {
    renderer.contextLost();
    ASSERT_TRUE(renderer.restore(nullGl()));
}

/// Shows a model at two places, in all that it can become, and removes it.
void showAndRemove(Renderer& renderer, ModelId model, int round) {
    const Result<PlaceId> place = renderer.addPlace(model, glm::translate(glm::dmat4(1), {1, 0, 0}));
    ASSERT_TRUE(place && renderer.show({{model}}, Wait::Yes) && renderer.setVariant(*place, "night"));
    ASSERT_TRUE(renderer.setTexture(model, 0, checkers(8, 2, glm::vec4(1), glm::vec4(0))));
    ASSERT_TRUE(renderer.setMaterial(model, 1, *renderer.materialOf(model, 1)));
    if (round % 100 == 0)
        loseContext(renderer);
    ASSERT_TRUE(renderer.draw(viewpoint(round), kTarget));
    ASSERT_TRUE(renderer.setVariant(model, ""));
    renderer.removePlace(*place);
    ASSERT_TRUE(renderer.draw(viewpoint(round), kTarget));
    renderer.remove(model);
}

/// How many rounds go by for one in steps: a thread for each takes minutes where the processor is busy.
/// FRANKEN_LONG=1 in the environment makes every round one.
int roundsForOneInSteps() { return std::getenv("FRANKEN_LONG") == nullptr ? 40 : 1; }

/// One round of all that comes and goes: at once; in steps; in steps that are cancelled in the middle, or
/// lose the context there.
void churn(Renderer& renderer, const Scene& scene, int round) {
    const SceneSource source = [&] { return Result<Scene>(scene); };
    const bool inSteps = round % roundsForOneInSteps() == 0;
    const int number = round / roundsForOneInSteps();
    const Result<ModelId> model = inSteps ? renderer.addInSteps(scene, source) : renderer.add(scene, source);
    ASSERT_TRUE(model && renderer.show({{*model}}));
    for (int step = 0; inSteps && step < number % 23; ++step)
        ASSERT_TRUE(renderer.step());
    if (inSteps && number % 5 == 1)
        loseContext(renderer);
    if (inSteps && number % 2 == 1)
        return renderer.remove(*model);
    finish(renderer);
    showAndRemove(renderer, *model, round);
}

TEST(ChangingScene, MemoryIsFlatOverTenThousandRounds) {
    Renderer renderer(nullGl());
    renderer.setLighting(skyLight());
    const Scene scene = balls();
    const auto heapAfter = [&](int rounds) {
        for (int round = 0; round < rounds; ++round)
            churn(renderer, scene, round);
        churn(renderer, scene, 0); // Waits for the threads of those that were removed.
        finish(renderer);
        renderer.takeMisses();
        EXPECT_EQ(renderer.memory().used(), 0u);
        return heapCount().bytes;
    };
    const std::size_t before = heapAfter(500);
    EXPECT_LE(heapAfter(10'000), before + 16 * 1024) << "less than two bytes a round";
}

// Fonts, sizes and texts come and go; one text stays, whose glyphs move to make room.
TEST(ChangingScene, MemoryOfTextsIsFlatOverTenThousandRounds) {
    Renderer renderer(nullGl());
    OverlayText texts(renderer, {.maxBytes = std::size_t{2} << 20});
    const std::vector<std::uint8_t> file = soundFont().bytes();
    ASSERT_TRUE(texts.add({.font = *parseFont(file), .utf8 = "AVBo"}));
    const auto heapAfter = [&](int rounds) {
        std::optional<Font> font;
        for (int round = 0; round < rounds; ++round) {
            if (round % 50 == 0)
                font = *parseFont(file);
            const TextStyle style{.pixels = 10 + static_cast<float>(round % 190) / 5};
            const Result<TextId> text = texts.add({.font = *font, .utf8 = "A VoB \xC3\xA9", .style = style});
            EXPECT_TRUE(text) << toString(text.error());
            if (round % 500 == 0)
                loseContext(renderer);
            EXPECT_TRUE(texts.draw(kTarget));
            texts.remove(*text);
        }
        EXPECT_LE(renderer.memory().used(), std::size_t{2} << 20);
        return heapCount().bytes;
    };
    const std::size_t before = heapAfter(1000);
    EXPECT_LE(heapAfter(10'000), before + 16 * 1024);
}

} // namespace
} // namespace franken::test
