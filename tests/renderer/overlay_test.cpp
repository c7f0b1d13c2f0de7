// SPDX-License-Identifier: MIT
// Text and pictures on top.
#include "support/draw_scene.h"
#include "support/gl_recorder.h"
#include "support/shapes.h"

namespace franken::test {
namespace {

class OverlayTest : public PictureTest {
protected:
    DrawTarget target() { return {.framebuffer = surface().framebuffer(), .width = 64, .height = 64}; }

    /// A red wall fills the view, or nothing does; then the rectangles.
    ReadBack drawn(Renderer& renderer, std::span<const OverlayQuad> quads) {
        EXPECT_TRUE(renderer.draw(viewpointOf(Camera{}, 1), target()));
        const Result<void> result = renderer.drawOverlay(quads, target());
        EXPECT_TRUE(result) << toString(result.error());
        EXPECT_EQ(gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
        return readBack();
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, OverlayTest, allBackends(), backendName);

using Pixel = ReadBack::Pixel;

/// Four texels of 8 x 8 pixels: grey 60, red, green, half-transparent white.
Image fourColors() {
    return paint(16, [](glm::vec2 uv) {
        if (uv.y < 0.5f)
            return uv.x < 0.5f ? glm::vec4(60.0f / 255, 60.0f / 255, 60.0f / 255, 1) : glm::vec4(1, 0, 0, 1);
        return uv.x < 0.5f ? glm::vec4(0, 1, 0, 1) : glm::vec4(1, 1, 1, 0.5f);
    });
}

/// A square right before the camera, at its nearest plane.
Scene wall() {
    SceneBuilder builder;
    Material material;
    material.unlit = true;
    material.factors.baseColor = {1, 0, 0, 1};
    builder.add(square(), builder.addMaterial(material),
                glm::mat4{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -0.101f, 1});
    return builder.scene;
}

void expectNear(const Pixel& actual, const Pixel& expected) {
    for (std::size_t channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(actual[channel], expected[channel], 1) << "channel " << channel;
}

TEST_P(OverlayTest, CodesArriveAsTheyAreWhereTheyShould) {
    Renderer renderer(gl());
    const Result<PictureId> picture = renderer.addPicture(fourColors());
    ASSERT_TRUE(picture);
    const ReadBack image = drawn(renderer, {{{.picture = *picture, .place = {8, 4, 16, 16}}}});
    expectNear(image.pixel(8, 4), {60, 60, 60, 255});
    expectNear(image.pixel(15, 11), {60, 60, 60, 255});
    expectNear(image.pixel(16, 4), {255, 0, 0, 255});
    expectNear(image.pixel(8, 19), {0, 255, 0, 255});
    expectNear(image.pixel(23, 19), {128, 128, 128, 255});
    for (const auto& [x, y] : {std::pair(7, 4), {8, 3}, {24, 4}, {8, 20}})
        expectNear(image.pixel(x, y), {0, 0, 0, 255});
}

TEST_P(OverlayTest, LiesOnTopOfTheNearestThingAndBlendsWithIt) {
    Renderer renderer(gl());
    ASSERT_TRUE(renderer.load(wall()));
    const ReadBack bare = drawn(renderer, {});
    expectNear(bare.pixel(32, 32), {255, 0, 0, 255});
    const Result<PictureId> picture = renderer.addPicture(fourColors());
    ASSERT_TRUE(picture);
    const std::vector<OverlayQuad> quads = {
        {.picture = *picture, .place = {0, 0, 64, 64}, .part = {0.25f, 0.75f, 0, 0}},
        {.picture = *picture, .place = {32, 0, 32, 64}, .part = {0.75f, 0.75f, 0, 0}, .color = {0, 0, 1, 1}}};
    const ReadBack image = drawn(renderer, quads);
    expectNear(image.pixel(10, 50), {0, 255, 0, 255});
    expectNear(image.pixel(50, 50), {0, 128, 128, 255});
    EXPECT_EQ(drawn(renderer, {}).rgba, bare.rgba) << "the next frame is as if nothing had been there";
}

TEST_P(OverlayTest, IsDecodedForATargetThatEncodes) {
    Renderer renderer(gl());
    renderer.setLook({.output = Output::Linear});
    const Result<PictureId> picture = renderer.addPicture(fourColors());
    ASSERT_TRUE(picture);
    const ReadBack image = drawn(renderer, {{{.picture = *picture, .place = {0, 0, 16, 16}}}});
    expectNear(image.pixel(3, 3), {11, 11, 11, 255}); // 60 / 255 in sRGB is 0.0452 in linear light.
    renderer.setLook({});
    const ReadBack encoded = drawn(renderer, {{{.picture = *picture, .place = {0, 0, 16, 16}}}});
    expectNear(encoded.pixel(3, 3), {60, 60, 60, 255});
}

TEST_P(OverlayTest, APictureIsOneDrawAndNoStateIsSetTwice) {
    Renderer renderer(recordingGl(gl()));
    ASSERT_TRUE(renderer.load(wall()));
    const Result<PictureId> one = renderer.addPicture(fourColors()),
                            other = renderer.addPicture(fourColors());
    ASSERT_TRUE(one && other);
    const std::vector<OverlayQuad> quads = {{.picture = *one, .place = {0, 0, 4, 4}},
                                            {.picture = *one, .place = {4, 0, 4, 4}},
                                            {.picture = *one, .place = {8, 0, 4, 4}},
                                            {.picture = *other, .place = {12, 0, 4, 4}}};
    drawn(renderer, quads);
    StateFollower follower;
    for (int frame = 0; frame < 3; ++frame) {
        recordedCalls().clear();
        ASSERT_TRUE(renderer.draw(viewpointOf(Camera{}, 1), target()));
        ASSERT_TRUE(renderer.drawOverlay(quads, target()));
        EXPECT_EQ(countCalls("DrawElements"), 3u) << "the wall and two pictures";
        EXPECT_EQ(follower.redundant(recordedCalls()), std::vector<std::string>());
        EXPECT_EQ(callsThatAsk(), std::vector<std::string>());
    }
}

TEST_P(OverlayTest, AnyNumberOfQuadsIsDrawn) {
    Renderer renderer(gl());
    const Result<PictureId> picture = renderer.addPicture(fourColors());
    ASSERT_TRUE(picture);
    std::vector<OverlayQuad> quads(20'000, {.picture = *picture, .place = {-9, -9, 4, 4}});
    quads.push_back({.picture = *picture, .place = {0, 0, 16, 16}});
    expectNear(drawn(renderer, quads).pixel(3, 3), {60, 60, 60, 255});
}

TEST_P(OverlayTest, PicturesAreCountedAndComeBackAfterALostContext) {
    Renderer renderer(gl());
    const Result<PictureId> picture = renderer.addPicture(fourColors(), [] { return Result(fourColors()); });
    const Result<PictureId> gone = renderer.addPicture(fourColors());
    ASSERT_TRUE(picture && gone);
    EXPECT_EQ(renderer.memory().used(MemoryUse::Textures), 2u * 16 * 16 * 4);
    const std::vector<OverlayQuad> quads = {{.picture = *picture, .place = {8, 4, 16, 16}}};
    const ReadBack before = drawn(renderer, quads);
    renderer.contextLost();
    replaceContext({64, 64});
    EXPECT_EQ(renderer.drawOverlay(quads, target()).error().code, "renderer.context-lost");
    EXPECT_EQ(renderer.restore(gl()).error().code, "renderer.no-source");
    EXPECT_EQ(drawn(renderer, quads).rgba, before.rgba);
    const OverlayQuad lost{.picture = *gone, .place = {0, 0, 1, 1}};
    EXPECT_EQ(renderer.drawOverlay({{lost}}, target()).error().code, "renderer.picture");
    renderer.removePicture(*gone);
    EXPECT_EQ(renderer.memory().used(), 16u * 16 * 4);
}

/// 16 x 16 texels of one grey.
constexpr std::size_t kPictureBytes = 16u * 16 * 4;

Image grey(int code) {
    return paint(16, [code](glm::vec2) { return glm::vec4(glm::vec3(static_cast<float>(code) / 255), 1); });
}

/// Pictures with a source that counts how often it is asked.
class OverlayBudgetTest : public OverlayTest {
protected:
    PictureId add(Renderer& renderer, int code) {
        const Result<PictureId> picture = renderer.addPicture(grey(code), [this, code]() -> Result<Image> {
            m_reads.push_back(code);
            return grey(code);
        });
        EXPECT_TRUE(picture) << toString(picture.error());
        return *picture;
    }

    int codeOf(Renderer& renderer, PictureId picture) {
        return drawn(renderer, {{{.picture = picture, .place = {0, 0, 16, 16}}}}).pixel(8, 8)[0];
    }

    std::vector<int> m_reads;
};

INSTANTIATE_TEST_SUITE_P(Backends, OverlayBudgetTest, allBackends(), backendName);

TEST_P(OverlayBudgetTest, PicturesDrawnLongestAgoMakeRoomAndComeBack) {
    Renderer renderer(gl());
    renderer.memory().setBudget(2 * kPictureBytes + 100);
    const PictureId one = add(renderer, 50), two = add(renderer, 100);
    EXPECT_EQ(codeOf(renderer, two), 100);
    EXPECT_EQ(codeOf(renderer, one), 50);
    const PictureId three = add(renderer, 150);
    EXPECT_EQ(renderer.memory().evictions(), 1u) << "the second, which was drawn before the first";
    EXPECT_EQ(codeOf(renderer, one), 50);
    EXPECT_EQ(codeOf(renderer, three), 150);
    EXPECT_TRUE(m_reads.empty());
    EXPECT_EQ(codeOf(renderer, two), 100);
    EXPECT_EQ(m_reads, std::vector<int>{100});
    EXPECT_EQ(codeOf(renderer, one), 50);
    EXPECT_EQ(m_reads, (std::vector<int>{100, 50}));
    EXPECT_EQ(renderer.memory().evictions(), 3u);
    EXPECT_EQ(renderer.memory().used(), 2 * kPictureBytes);
}

TEST_P(OverlayBudgetTest, WhatAFrameShowsStays) {
    Renderer renderer(gl());
    renderer.memory().setBudget(2 * kPictureBytes + 100);
    const PictureId one = add(renderer, 50), two = add(renderer, 100), three = add(renderer, 150);
    const auto quad = [](PictureId picture, float x) {
        return OverlayQuad{.picture = picture, .place = {x, 0, 16, 16}};
    };
    const ReadBack both = drawn(renderer, {{quad(one, 0), quad(three, 16)}});
    EXPECT_EQ(both.pixel(8, 8)[0], 50);
    EXPECT_EQ(both.pixel(24, 8)[0], 150);
    const Result<void> tooMany = renderer.drawOverlay({{quad(two, 0)}}, target());
    ASSERT_FALSE(tooMany) << "the same frame shows two others";
    EXPECT_EQ(tooMany.error().code, "memory.budget");
    EXPECT_EQ(readBack().rgba, both.rgba);
    EXPECT_EQ(renderer.addPicture(grey(200)).error().code, "memory.budget");
    EXPECT_EQ(codeOf(renderer, two), 100) << "the next frame may";
    EXPECT_EQ(renderer.drawOverlay({{quad(one, 0), quad(two, 0), quad(three, 0)}}, target()).error().code,
              "memory.budget");
}

TEST_P(OverlayBudgetTest, PicturesWithoutASourceStay) {
    Renderer renderer(gl());
    renderer.memory().setBudget(2 * kPictureBytes + 100);
    const Result<PictureId> kept = renderer.addPicture(grey(50));
    ASSERT_TRUE(kept);
    const PictureId other = add(renderer, 100), third = add(renderer, 150);
    EXPECT_EQ(codeOf(renderer, *kept), 50);
    EXPECT_EQ(codeOf(renderer, other), 100);
    EXPECT_EQ(codeOf(renderer, third), 150);
    EXPECT_EQ(m_reads, (std::vector<int>{100, 150}));
    EXPECT_EQ(codeOf(renderer, *kept), 50);
    ASSERT_TRUE(renderer.addPicture(grey(200)));
    EXPECT_EQ(renderer.addPicture(grey(250)).error().code, "memory.budget");
}

TEST_P(OverlayBudgetTest, ModelsAndPicturesMakeRoomForEachOther) {
    Renderer renderer(gl());
    const Scene tiled = [] {
        SceneBuilder builder;
        Material material;
        material.textures[TextureRole::BaseColor].texture =
            builder.addTexture(grey(30)); // With mipmaps: more than a picture.
        builder.add(square(), builder.addMaterial(material));
        return builder.scene;
    }();
    const SceneSource source = [&] { return Result<Scene>(tiled); };
    const Result<ModelId> shown = renderer.add(tiled, source), hidden = renderer.add(tiled, source);
    ASSERT_TRUE(shown && hidden);
    ASSERT_TRUE(renderer.show({{*hidden}}, Wait::Yes));
    ASSERT_TRUE(renderer.show({{*shown}}, Wait::Yes));
    const std::size_t modelBytes = renderer.memory().used() / 2;
    const PictureId one = add(renderer, 50);
    EXPECT_EQ(codeOf(renderer, one), 50);
    renderer.memory().setBudget(renderer.memory().used());
    const PictureId two = add(renderer, 100);
    EXPECT_EQ(renderer.memory().used(), modelBytes + 2 * kPictureBytes) << "the model was shown before";
    EXPECT_EQ(codeOf(renderer, two), 100);
    EXPECT_TRUE(m_reads.empty());
    ASSERT_TRUE(renderer.show({{*shown, *hidden}}, Wait::Yes)) << "the first picture makes room";
    EXPECT_EQ(renderer.memory().used(), 2 * modelBytes + kPictureBytes);
    EXPECT_EQ(codeOf(renderer, two), 100);
    EXPECT_TRUE(m_reads.empty());
}

TEST_P(OverlayBudgetTest, ASourceThatFailsSaysSoAndIsAskedAgain) {
    Renderer renderer(gl());
    bool broken = false;
    const Result<PictureId> picture = renderer.addPicture(grey(50), [&]() -> Result<Image> {
        if (broken)
            return Error{"test.unplugged", "", "the stick is gone", "plug it in"};
        return grey(50);
    });
    ASSERT_TRUE(picture);
    renderer.memory().setBudget(kPictureBytes);
    const PictureId other = add(renderer, 100);
    EXPECT_EQ(codeOf(renderer, other), 100);
    broken = true;
    EXPECT_TRUE(renderer.draw(viewpointOf(Camera{}, 1), target()));
    const std::vector<OverlayQuad> quads = {{.picture = *picture, .place = {0, 0, 16, 16}}};
    EXPECT_EQ(renderer.drawOverlay(quads, target()).error().code, "test.unplugged");
    broken = false;
    EXPECT_EQ(codeOf(renderer, *picture), 50);
}

TEST_P(OverlayTest, WarmUpTakesItsProgram) {
    Renderer renderer(gl());
    const ProgramUse use = *overlayUse({});
    ASSERT_TRUE(renderer.warmUp(target(), {{use}}));
    const unsigned compiles = renderer.programCounters().compiles;
    const Result<PictureId> picture = renderer.addPicture(fourColors());
    ASSERT_TRUE(picture);
    drawn(renderer, {{{.picture = *picture, .place = {0, 0, 16, 16}}}});
    EXPECT_EQ(renderer.programCounters().compiles, compiles);
    EXPECT_TRUE(renderer.takeMisses().empty());
}

} // namespace
} // namespace franken::test
