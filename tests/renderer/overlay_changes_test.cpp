// SPDX-License-Identifier: MIT
// Overlay pictures that change: updated in place, and textures that the application owns.
#include "support/draw_scene.h"
#include "support/gl_recorder.h"
#include "support/shapes.h"

#include <limits>

namespace franken::test {
namespace {

Image plain(int width, int height, const ReadBack::Pixel& texel) {
    Image image{"", width, height, {}};
    for (int i = 0; i < width * height; ++i)
        image.rgba.insert(image.rgba.end(), texel.begin(), texel.end());
    return image;
}

constexpr ReadBack::Pixel kGrey = {60, 60, 60, 255}, kGreen = {0, 255, 0, 255}, kRed = {255, 0, 0, 255};

class OverlayChangesTest : public PictureTest {
protected:
    DrawTarget target() { return {.framebuffer = surface().framebuffer(), .width = 64, .height = 64}; }

    Result<void> draw(Renderer& renderer, PictureId picture) {
        EXPECT_TRUE(renderer.draw(viewpointOf(Camera{}, 1), target()));
        return renderer.drawOverlay({{{.picture = picture, .place = {0, 0, 16, 16}}}}, target());
    }

    /// Of the picture's 16 x 16 texels.
    ReadBack::Pixel texel(Renderer& renderer, PictureId picture, int x, int y) {
        const Result<void> drawn = draw(renderer, picture);
        EXPECT_TRUE(drawn) << toString(drawn.error());
        EXPECT_EQ(gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
        return readBack().pixel(x, y);
    }

    /// Bound once, with a filter that needs no mipmaps.
    GLuint makeTexture(const Image& image) {
        GLuint name = 0;
        gl().GenTextures(1, &name);
        gl().BindTexture(GL_TEXTURE_2D, name);
        gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl().TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                        image.rgba.data());
        return name;
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, OverlayChangesTest, allBackends(), backendName);

TEST_P(OverlayChangesTest, APartIsReplacedWithoutAnotherTexture) {
    Renderer renderer(recordingGl(gl()));
    const Result<PictureId> picture = renderer.addPicture(plain(16, 16, kGrey));
    ASSERT_TRUE(picture);
    EXPECT_EQ(texel(renderer, *picture, 8, 8), kGrey);
    const std::size_t bytes = renderer.memory().used();
    recordedCalls().clear();
    ASSERT_TRUE(renderer.updatePicture(*picture, plain(3, 5, kGreen), 13, 2));
    EXPECT_EQ(countCalls("TexSubImage2D"), 1u);
    EXPECT_EQ(countCalls("TexImage2D") + countCalls("GenTextures") + countCalls("DeleteTextures"), 0u);
    EXPECT_EQ(callsThatAsk(), std::vector<std::string>());
    EXPECT_EQ(renderer.memory().used(), bytes);
    for (const auto& [x, y] : {std::pair(13, 2), {15, 6}})
        EXPECT_EQ(texel(renderer, *picture, x, y), kGreen) << x << ", " << y;
    for (const auto& [x, y] : {std::pair(12, 2), {13, 1}, {15, 7}, {2, 13}})
        EXPECT_EQ(texel(renderer, *picture, x, y), kGrey) << x << ", " << y;
    ASSERT_TRUE(renderer.updatePicture(*picture, plain(16, 16, kRed)));
    EXPECT_EQ(texel(renderer, *picture, 2, 13), kRed);
}

TEST_P(OverlayChangesTest, EveryAlignmentOfAnApplicationWillDo) {
    Renderer renderer(gl());
    const Result<PictureId> picture = renderer.addPicture(plain(16, 16, kGrey));
    ASSERT_TRUE(picture);
    gl().PixelStorei(GL_UNPACK_ALIGNMENT, 8);
    ASSERT_TRUE(renderer.updatePicture(*picture, plain(3, 5, kGreen), 0, 0));
    EXPECT_EQ(texel(renderer, *picture, 2, 4), kGreen);
}

TEST_P(OverlayChangesTest, WhatDoesNotFitIsRefusedAndChangesNothing) {
    Renderer renderer(gl());
    const Result<PictureId> picture = renderer.addPicture(plain(16, 16, kGrey));
    ASSERT_TRUE(picture);
    const auto codeOf = [&](const Image& image, int x, int y) {
        return renderer.updatePicture(*picture, image, x, y).error().code;
    };
    const int far = std::numeric_limits<int>::max();
    EXPECT_EQ(codeOf(plain(17, 16, kRed), 0, 0), "renderer.picture-part");
    for (const auto& [x, y] : {std::pair(-1, 0), {0, -1}, {13, 0}, {0, 13}, {far, 0}, {0, far}, {-far, 0}})
        EXPECT_EQ(codeOf(plain(4, 4, kRed), x, y), "renderer.picture-part") << x << ", " << y;
    EXPECT_EQ(codeOf({"", 4, 4, {1, 2, 3}}, 0, 0), "renderer.image");
    EXPECT_EQ(codeOf({}, 0, 0), "renderer.image");
    EXPECT_EQ(renderer.updatePicture(PictureId{0}, plain(4, 4, kRed)).error().code, "renderer.picture");
    EXPECT_EQ(texel(renderer, *picture, 1, 1), kGrey);
}

TEST_P(OverlayChangesTest, APictureThatWasScaledIsUpdatedAsAWhole) {
    Capabilities small = Capabilities::query(gl());
    small.maxTextureSize = 8;
    Renderer renderer(gl(), small);
    const Result<PictureId> picture = renderer.addPicture(plain(16, 16, kGrey));
    ASSERT_TRUE(picture);
    ASSERT_TRUE(renderer.updatePicture(*picture, plain(16, 16, kGreen)));
    EXPECT_EQ(texel(renderer, *picture, 8, 8), kGreen);
    EXPECT_EQ(renderer.updatePicture(*picture, plain(2, 2, kRed)).error().code, "renderer.picture-part");
}

TEST_P(OverlayChangesTest, AnUpdateOutlastsEvictionAndALostContext) {
    Renderer renderer(gl());
    Image newest = plain(16, 16, kGrey);
    const Result<PictureId> sourced = renderer.addPicture(newest, [&] { return Result<Image>(newest); });
    const Result<PictureId> bare = renderer.addPicture(newest);
    ASSERT_TRUE(sourced && bare);
    renderer.contextLost();
    replaceContext({64, 64});
    EXPECT_EQ(renderer.updatePicture(*bare, newest).error().code, "renderer.context-lost");
    EXPECT_EQ(renderer.restore(gl()).error().code, "renderer.no-source");
    EXPECT_EQ(renderer.updatePicture(*bare, plain(4, 4, kRed)).error().code, "renderer.picture")
        << "it is lost";
    ASSERT_TRUE(renderer.updatePicture(*bare, plain(16, 16, kRed))) << "all of it brings it back";
    EXPECT_EQ(texel(renderer, *bare, 8, 8), kRed);
    ASSERT_TRUE(renderer.updatePicture(*sourced, plain(4, 4, kRed), 4, 4)) << "the source has the rest";
    EXPECT_EQ(texel(renderer, *sourced, 4, 4), kRed);
    EXPECT_EQ(texel(renderer, *sourced, 3, 4), kGrey);
}

TEST_P(OverlayChangesTest, AnApplicationsTextureIsShownAndNeverTouched) {
    const GLuint video = makeTexture(plain(4, 4, kGreen));
    {
        Renderer renderer(recordingGl(gl()));
        const Result<PictureId> picture = renderer.addApplicationTexture(video);
        ASSERT_TRUE(picture) << toString(picture.error());
        EXPECT_EQ(renderer.memory().used(), 0u);
        recordedCalls().clear();
        EXPECT_EQ(texel(renderer, *picture, 8, 8), kGreen);
        gl().BindTexture(GL_TEXTURE_2D, video);
        gl().TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE,
                           plain(4, 4, kRed).rgba.data());
        renderer.invalidateState();
        EXPECT_EQ(texel(renderer, *picture, 8, 8), kRed) << "the next frame of the video";
        EXPECT_EQ(renderer.updatePicture(*picture, plain(4, 4, kGrey)).error().code, "renderer.picture");
        renderer.removePicture(*picture);
        EXPECT_EQ(countCalls("DeleteTextures") + countCalls("TexSubImage2D"), 0u);
        EXPECT_EQ(draw(renderer, *picture).error().code, "renderer.picture");
    }
    EXPECT_EQ(gl().IsTexture(video), GL_TRUE) << "the renderer is gone, the texture is not";
    gl().DeleteTextures(1, &video);
}

TEST_P(OverlayChangesTest, WhatIsNoTextureIsRefused) {
    Renderer renderer(gl());
    GLuint unbound = 0, cube = 0;
    gl().GenTextures(1, &unbound);
    gl().GenTextures(1, &cube);
    gl().BindTexture(GL_TEXTURE_CUBE_MAP, cube);
    for (const GLuint name : {GLuint{0}, unbound, cube, GLuint{4711}})
        EXPECT_EQ(renderer.addApplicationTexture(name).error().code, "renderer.application-texture") << name;
    const Result<PictureId> own = renderer.addPicture(plain(2, 2, kRed));
    ASSERT_TRUE(own);
    EXPECT_EQ(renderer.setApplicationTexture(*own, 1).error().code, "renderer.picture");
    EXPECT_EQ(gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_P(OverlayChangesTest, AfterALostContextTheApplicationGivesItsTextureAgain) {
    Renderer renderer(gl());
    const Result<PictureId> picture = renderer.addApplicationTexture(makeTexture(plain(4, 4, kGreen)));
    ASSERT_TRUE(picture);
    renderer.contextLost();
    replaceContext({64, 64});
    ASSERT_TRUE(renderer.restore(gl())) << "there is nothing that the renderer could rebuild";
    EXPECT_EQ(draw(renderer, *picture).error().code, "renderer.picture");
    ASSERT_TRUE(renderer.setApplicationTexture(*picture, makeTexture(plain(4, 4, kRed))));
    EXPECT_EQ(texel(renderer, *picture, 8, 8), kRed);
    EXPECT_EQ(renderer.setApplicationTexture(*picture, 0).error().code, "renderer.application-texture");
    EXPECT_EQ(texel(renderer, *picture, 8, 8), kRed);
}

} // namespace
} // namespace franken::test
