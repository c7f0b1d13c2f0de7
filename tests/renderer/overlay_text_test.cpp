// SPDX-License-Identifier: MIT
// Text on top of a frame.
#include "franken/overlay_text.h"
#include "support/draw_scene.h"
#include "support/font_builder.h"
#include "support/gl_recorder.h"

namespace franken::test {
namespace {

Font soundTestFont() { return *parseFont(soundFont().bytes()); }

class OverlayTextTest : public PictureTest {
protected:
    DrawTarget target() { return {.framebuffer = surface().framebuffer(), .width = 64, .height = 64}; }

    ReadBack drawn(OverlayText& texts) { return drawn(texts, target()); }
    ReadBack drawn(OverlayText& texts, const DrawTarget& to) {
        EXPECT_TRUE(m_renderer->draw(viewpointOf(Camera{}, 1), to));
        const Result<void> result = texts.draw(to);
        EXPECT_TRUE(result) << toString(result.error());
        EXPECT_EQ(gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
        return readBack();
    }

    void SetUp() override {
        PictureTest::SetUp();
        if (!IsSkipped() && !HasFatalFailure())
            m_renderer.emplace(recordingGl(gl()));
    }
    void TearDown() override {
        m_renderer.reset();
        PictureTest::TearDown();
    }

    Renderer& renderer() { return *m_renderer; }
    const Font m_font = soundTestFont();

private:
    std::optional<Renderer> m_renderer;
};

INSTANTIATE_TEST_SUITE_P(Backends, OverlayTextTest, allBackends(), backendName);

using Pixel = ReadBack::Pixel;
constexpr Pixel kBlack = {0, 0, 0, 255}, kWhite = {255, 255, 255, 255};

TEST_P(OverlayTextTest, GlyphsStandWhereTheLayoutSays) {
    OverlayText texts(renderer());
    // At 10 pixels: A from 1 to 9, baseline at 8; the second one 10 to the right, the line 11 down.
    ASSERT_TRUE(texts.add({.font = m_font, .utf8 = "AA\nA", .style = {.pixels = 10}, .x = 5, .y = 3}));
    const ReadBack image = drawn(texts);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const auto isIn = [&](int left, int top) {
                return x >= left && x < left + 8 && y >= top && y < top + 8;
            };
            EXPECT_EQ(image.pixel(x, y), isIn(6, 3) || isIn(16, 3) || isIn(6, 14) ? kWhite : kBlack)
                << x << ", " << y;
        }
}

TEST_P(OverlayTextTest, PlacesAreRoundedToWholePixels) {
    OverlayText texts(renderer());
    const Result<TextId> text =
        texts.add({.font = m_font, .utf8 = "AV", .style = {.pixels = 13}, .x = 5, .y = 3});
    ASSERT_TRUE(text);
    const ReadBack whole = drawn(texts);
    ASSERT_TRUE(texts.setPlace(*text, 5.4f, 2.6f));
    EXPECT_EQ(drawn(texts).rgba, whole.rgba);
    ASSERT_TRUE(texts.setPlace(*text, 5.6f, 3));
    EXPECT_NE(drawn(texts).rgba, whole.rgba);
}

TEST_P(OverlayTextTest, CoverageAndColorAreBlendedInEncodedSpace) {
    OverlayText texts(renderer());
    // At 5 pixels, an A covers half of its first and last columns: 5.5 to 9.5.
    ASSERT_TRUE(texts.add(
        {.font = m_font, .utf8 = "A", .style = {.pixels = 5}, .x = 5, .y = 0, .color = {1, 0.5f, 0, 0.5f}}));
    const ReadBack image = drawn(texts);
    EXPECT_NEAR(image.pixel(7, 2)[0], 128, 1);
    EXPECT_NEAR(image.pixel(7, 2)[1], 64, 1);
    EXPECT_NEAR(image.pixel(5, 2)[0], 64, 1);
    EXPECT_NEAR(image.pixel(9, 2)[0], 64, 1);
    EXPECT_EQ(image.pixel(4, 2), kBlack);
    EXPECT_EQ(image.pixel(10, 2), kBlack);
}

TEST_P(OverlayTextTest, AColorThatIsSetLaterIsThatOfATextWhichHadItAtFirst) {
    const Float4 color = {0.25f, 1, 0.5f, 0.75f};
    OverlayText first(renderer()), later(renderer());
    ASSERT_TRUE(first.add({.font = m_font, .utf8 = "AV", .style = {.pixels = 20}, .color = color}));
    const Result<TextId> text = later.add({.font = m_font, .utf8 = "AV", .style = {.pixels = 20}});
    ASSERT_TRUE(text);
    const ReadBack expected = drawn(first);
    EXPECT_NE(drawn(later).rgba, expected.rgba);
    ASSERT_TRUE(later.setColor(*text, color));
    EXPECT_EQ(drawn(later).rgba, expected.rgba);
}

TEST_P(OverlayTextTest, IsTurnedWithThePicture) {
    OverlayText texts(renderer());
    const Result<TextId> text =
        texts.add({.font = m_font, .utf8 = "AV o\nB!", .style = {.pixels = 12}, .x = 3, .y = 2});
    ASSERT_TRUE(text);
    const ReadBack upright = drawn(texts);
    DrawTarget turned = target();
    for (const Rotation rotation : {Rotation::Quarter, Rotation::Half, Rotation::ThreeQuarters}) {
        turned.rotation = rotation;
        const ReadBack image = drawn(texts, turned);
        int differing = 0;
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                const auto [u, v] = rotation == Rotation::Half      ? std::pair(63 - x, 63 - y)
                                    : rotation == Rotation::Quarter ? std::pair(y, 63 - x)
                                                                    : std::pair(63 - y, x);
                differing += image.pixel(u, v) != upright.pixel(x, y);
            }
        EXPECT_EQ(differing, 0) << static_cast<int>(rotation);
    }
}

TEST_P(OverlayTextTest, OtherGlyphsAreUploadedInPlaceAndKnownOnesNot) {
    OverlayText texts(renderer());
    const Result<TextId> text = texts.add({.font = m_font, .utf8 = "AV", .style = {.pixels = 10}});
    ASSERT_TRUE(text);
    drawn(texts);
    const std::size_t bytes = renderer().memory().used(MemoryUse::Textures);
    const auto uploadsOf = [&](std::string_view utf8) {
        EXPECT_TRUE(texts.set(*text, utf8));
        recordedCalls().clear();
        drawn(texts);
        EXPECT_EQ(countCalls("TexImage2D"), 0u);
        EXPECT_EQ(countCalls("DrawElements"), 1u) << "a draw for a page";
        return countCalls("TexSubImage2D");
    };
    EXPECT_EQ(uploadsOf("VAVA"), 0u);
    EXPECT_EQ(uploadsOf("VAoB"), 1u) << "both at once";
    EXPECT_EQ(uploadsOf("AV"), 0u);
    EXPECT_EQ(uploadsOf("Bo"), 0u) << "they are still there";
    EXPECT_EQ(renderer().memory().used(MemoryUse::Textures), bytes);
}

TEST_P(OverlayTextTest, ALostContextBringsAllOfItBack) {
    OverlayText texts(renderer());
    const Result<TextId> text = texts.add({.font = m_font, .utf8 = "AV", .style = {.pixels = 20}});
    ASSERT_TRUE(text);
    drawn(texts);
    ASSERT_TRUE(texts.set(*text, "AVo"));
    const ReadBack before = drawn(texts);
    renderer().contextLost();
    ASSERT_TRUE(texts.set(*text, "Bo")) << "needs no context";
    ASSERT_TRUE(texts.set(*text, "AVo"));
    EXPECT_EQ(texts.draw(target()).error().code, "renderer.context-lost");
    replaceContext({64, 64});
    ASSERT_TRUE(renderer().restore(gl()));
    EXPECT_EQ(drawn(texts).rgba, before.rgba);
    ASSERT_TRUE(texts.set(*text, "Bo"));
    OverlayText fresh(renderer());
    ASSERT_TRUE(fresh.add({.font = m_font, .utf8 = "Bo", .style = {.pixels = 20}}));
    const ReadBack after = drawn(texts);
    EXPECT_EQ(after.rgba, drawn(fresh).rgba) << "changed while it was lost";
}

TEST_P(OverlayTextTest, WhatIsRemovedOrHiddenIsNotDrawnAndPicturesAreFreed) {
    const std::size_t before = renderer().memory().used();
    {
        OverlayText texts(renderer());
        const Result<TextId> text = texts.add({.font = m_font, .utf8 = "A", .style = {.pixels = 40}});
        const Result<TextId> other =
            texts.add({.font = m_font, .utf8 = "A", .style = {.pixels = 10}, .x = 50});
        ASSERT_TRUE(text && other);
        EXPECT_EQ(drawn(texts).pixel(20, 20), kWhite);
        ASSERT_TRUE(texts.setVisible(*text, false));
        EXPECT_EQ(drawn(texts).pixel(20, 20), kBlack);
        ASSERT_TRUE(texts.setVisible(*text, true));
        texts.remove(*text);
        const ReadBack image = drawn(texts);
        EXPECT_EQ(image.pixel(20, 20), kBlack);
        EXPECT_EQ(image.pixel(55, 4), kWhite);
        for (const Result<void>& failed :
             {texts.set(*text, "V"), texts.set(*text, TextStyle{}), texts.setPlace(*text, 0, 0),
              texts.setColor(*text, {}), texts.setVisible(*text, true)})
            EXPECT_EQ(failed.error().code, "text.unknown");
        EXPECT_EQ(texts.sizeOf(*text).error().code, "text.unknown");
        texts.remove(*text);
    }
    EXPECT_EQ(renderer().memory().used(), before);
}

// One page has 512 texels a side: some nine glyphs of 160 pixels.
TEST_P(OverlayTextTest, UnusedGlyphsMakeRoomAndWhatDoesNotFitIsRefused) {
    OverlayText texts(renderer(), {.maxBytes = 1});
    const auto at = [&](float pixels) {
        return texts.add({.font = m_font, .utf8 = "AVB", .style = {.pixels = pixels}, .x = 1000});
    };
    const Result<TextId> small = texts.add({.font = m_font, .utf8 = "AVBo", .style = {.pixels = 30}});
    ASSERT_TRUE(small);
    const ReadBack before = drawn(texts);
    for (int round = 0; round < 20; ++round) { // Each is another size: 20 times what fits.
        const Result<TextId> large = at(static_cast<float>(150 + round));
        ASSERT_TRUE(large) << round << ": " << toString(large.error());
        EXPECT_EQ(drawn(texts).rgba, before.rgba) << "glyphs that moved are drawn as before";
        texts.remove(*large);
    }
    ASSERT_TRUE(at(250));
    const Result<TextId> tooMuch = at(251);
    EXPECT_EQ(tooMuch.error().code, "text.memory");
    EXPECT_EQ(texts.set(*small, TextStyle{.pixels = 220}).error().code, "text.memory");
    EXPECT_EQ(drawn(texts).rgba, before.rgba) << "and nothing changed";
    EXPECT_EQ(renderer().memory().used(MemoryUse::Textures), std::size_t{1} << 20);
}

// Two pages: the first glyphs leave the first page, and those of the second one move there.
TEST_P(OverlayTextTest, GlyphsMoveFromPageToPageAndAreDrawnAsBefore) {
    OverlayText texts(renderer(), {.maxBytes = std::size_t{2} << 20});
    const auto add = [&](float pixels, float x) {
        return texts.add({.font = m_font, .utf8 = "VoB", .style = {.pixels = pixels}, .x = x});
    };
    const Result<TextId> leaves = add(250, 2000), stays = add(240, 0);
    ASSERT_TRUE(leaves && stays);
    const auto pictures = [&] {
        std::vector<std::vector<std::uint8_t>> all;
        for (int x = 0; x > -720; x -= 60) {
            EXPECT_TRUE(texts.setPlace(*stays, static_cast<float>(x), -100));
            all.push_back(drawn(texts).rgba);
        }
        return all;
    };
    const auto before = pictures();
    texts.remove(*leaves);
    ASSERT_TRUE(add(251, 2000));
    const auto after = pictures();
    EXPECT_EQ(after, before);
    recordedCalls().clear();
    ASSERT_TRUE(add(245, 2000)) << "into the room of the glyphs that left";
}

TEST_P(OverlayTextTest, StylesOutOfRangeAreRefusedAndChangeNothing) {
    OverlayText texts(renderer());
    const Result<TextId> text = texts.add({.font = m_font, .utf8 = "A", .style = {.pixels = 10}});
    ASSERT_TRUE(text);
    const ReadBack before = drawn(texts);
    const auto nan = std::numeric_limits<float>::quiet_NaN(),
               infinite = std::numeric_limits<float>::infinity();
    for (const TextStyle& style : {TextStyle{.pixels = 3},
                                   {.pixels = 257},
                                   {.pixels = nan},
                                   {.width = -1},
                                   {.width = nan},
                                   {.width = infinite},
                                   {.lineSpacing = 0},
                                   {.lineSpacing = nan},
                                   {.lineSpacing = infinite}}) {
        EXPECT_EQ(texts.set(*text, style).error().code, "text.style");
        EXPECT_EQ(texts.add({.font = m_font, .style = style}).error().code, "text.style");
    }
    for (const float bad : {nan, infinite}) {
        EXPECT_EQ(texts.setPlace(*text, bad, 0).error().code, "text.style");
        EXPECT_EQ(texts.setPlace(*text, 0, bad).error().code, "text.style");
        EXPECT_EQ(texts.setColor(*text, {1, 1, bad, 1}).error().code, "text.style");
        EXPECT_EQ(texts.add({.font = m_font, .x = bad}).error().code, "text.style");
        EXPECT_EQ(texts.add({.font = m_font, .color = {bad, 0, 0, 0}}).error().code, "text.style");
    }
    EXPECT_EQ(drawn(texts).rgba, before.rgba);
}

TEST_P(OverlayTextTest, SaysOnceWhatIsMissingOrBroken) {
    FontFile file = soundFont();
    std::vector<std::string> glyphs = soundGlyphs();
    glyphs[TriangleV].resize(20);
    file.setGlyphs(glyphs);
    const Font font = *parseFont(file.bytes());
    std::vector<std::string> messages;
    OverlayText texts(renderer(),
                      {.log = [&](LogLevel, std::string_view message) { messages.emplace_back(message); }});
    const Result<TextId> text = texts.add({.font = font, .utf8 = "zVz", .style = {.pixels = 20}});
    ASSERT_TRUE(text) << toString(text.error());
    ASSERT_TRUE(texts.set(*text, "VzA"));
    ASSERT_EQ(messages.size(), 2u);
    EXPECT_NE(messages[0].find("U+007A"), std::string::npos) << messages[0];
    EXPECT_NE(messages[1].find("U+0056"), std::string::npos) << messages[1];
    const ReadBack image = drawn(texts);
    EXPECT_EQ(image.pixel(1, 10), kWhite) << "a box";
    EXPECT_EQ(image.pixel(5, 10), kBlack) << "hollow";
}

} // namespace
} // namespace franken::test
