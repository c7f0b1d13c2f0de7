// SPDX-License-Identifier: MIT
//
// What the screen shows is what would have been drawn without one, byte for byte.
#include "support/guest.h"

#include <drm_fourcc.h>

#include <algorithm>
#include <thread>

namespace franken::test {
namespace {

using platform::PixelFormat;
using platform::Rotation;

/// A framebuffer object of 565 in an offscreen context: GLES2 has no other target of 5 and 6 bits.
class Target565 {
public:
    Target565(const Gl& gl, platform::Size size)
        : m_colour(gl, generate(gl.GenRenderbuffers)),
          m_depth(gl, generate(gl.GenRenderbuffers)),
          m_framebuffer(gl, generate(gl.GenFramebuffers)) {
        gl.BindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.name());
        attach(gl, m_colour.name(), GL_RGB565, GL_COLOR_ATTACHMENT0, size);
        constexpr GLenum kDepth24 = 0x81A6; // GL_OES_depth24: as deep as the screen's.
        attach(gl, m_depth.name(), kDepth24, GL_DEPTH_ATTACHMENT, size);
        EXPECT_EQ(gl.CheckFramebufferStatus(GL_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_COMPLETE});
    }

private:
    static void attach(const Gl& gl, GLuint buffer, GLenum format, GLenum where, platform::Size size) {
        gl.BindRenderbuffer(GL_RENDERBUFFER, buffer);
        gl.RenderbufferStorage(GL_RENDERBUFFER, format, size.width, size.height);
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, where, GL_RENDERBUFFER, buffer);
    }
    GlRenderbuffer m_colour, m_depth;
    GlFramebuffer m_framebuffer;
};

VmPicture drawnOffscreen(platform::Size size, Rotation rotation, PixelFormat format) {
    const auto surface = platform::create(platform::Backend::EglSurfaceless, {.size = size}).value();
    const VmScene scene(surface->getProcAddress());
    std::optional<Target565> narrow;
    if (format == PixelFormat::Rgb565)
        narrow.emplace(scene.gl(), size);
    scene.draw(size, rotation, narrow.has_value());
    VmPicture picture = readPicture(scene.gl(), size);
    if (narrow)
        for (auto top = picture.pixels.begin(), bottom = picture.pixels.end() - size.width; top < bottom;
             top += size.width, bottom -= size.width)
            std::swap_ranges(top, top + size.width, bottom);
    return picture;
}

struct Row {
    Rotation rotation;
    PixelFormat format;
};

class Picture : public GuestTest, public testing::WithParamInterface<Row> {};

constexpr Row kRows[] = {
    {Rotation::None, PixelFormat::Rgb8},   {Rotation::Quarter, PixelFormat::Rgb8},
    {Rotation::Half, PixelFormat::Rgb8},   {Rotation::ThreeQuarters, PixelFormat::Rgb8},
    {Rotation::None, PixelFormat::Rgb565}, {Rotation::Quarter, PixelFormat::Rgb565},
    {Rotation::Half, PixelFormat::Rgb565}, {Rotation::ThreeQuarters, PixelFormat::Rgb565},
};

std::string nameOf(const testing::TestParamInfo<Row>& row) {
    return "turned" + std::to_string(toDegrees(row.param.rotation)) + "_" +
           std::string(toString(row.param.format));
}

INSTANTIATE_TEST_SUITE_P(Screen, Picture, testing::ValuesIn(kRows), nameOf);

TEST_P(Picture, TheFirstFrameIsScannedOutAsDrawnOffscreen) {
    platform::SurfaceOptions options = GuestTest::options();
    options.screen.rotation = GetParam().rotation;
    options.screen.format = GetParam().format;
    VmPicture shown;
    platform::Size size;
    {
        const auto surface = openSurface(options);
        ASSERT_TRUE(surface);
        ASSERT_EQ(surface->format(), GetParam().format);
        const VmScene scene(surface->getProcAddress());
        showFrame(*surface, scene);
        size = surface->size();
        shown =
            scannedOut(GetParam().format == PixelFormat::Rgb565 ? DRM_FORMAT_RGB565 : DRM_FORMAT_XRGB8888);
    }
    const VmPicture drawn = drawnOffscreen(size, GetParam().rotation, GetParam().format);
    const std::string name = "picture_" + std::to_string(toDegrees(GetParam().rotation)) + "_" +
                             std::string(toString(GetParam().format));
    writePpm(shown, name);
    writePpm(drawn, name + "_offscreen");
    EXPECT_TRUE(shown == drawn) << difference(shown, drawn);
    EXPECT_EQ(size, (platform::Size{160, 120}));
}

VmPicture pictureOf(const platform::ScreenPicture& copy) {
    VmPicture picture{copy.size, {}};
    for (std::size_t at = 0; at < copy.rgba.size(); at += 4)
        picture.pixels.push_back(
            static_cast<std::uint32_t>(copy.rgba[at] << 16 | copy.rgba[at + 1] << 8 | copy.rgba[at + 2]));
    return picture;
}

/// The bits that 565 has: what is below them, one rounds and the other repeats.
VmPicture narrowed(VmPicture picture) {
    for (std::uint32_t& pixel : picture.pixels)
        pixel &= 0xF8FCF8;
    return picture;
}

class HeldPictures : public GuestTest, public testing::WithParamInterface<PixelFormat> {};

INSTANTIATE_TEST_SUITE_P(Screen, HeldPictures, testing::Values(PixelFormat::Rgb8, PixelFormat::Rgb565),
                         [](const auto& row) { return std::string(toString(row.param)); });

TEST_P(HeldPictures, StayAsTheyAreWhileOthersAreShown) {
    platform::SurfaceOptions options = GuestTest::options();
    options.screen.format = GetParam();
    auto surface = openSurface(options);
    ASSERT_TRUE(surface);
    EXPECT_EQ(surface->holdShown(), nullptr) << "nothing is shown yet";
    const VmScene scene(surface->getProcAddress());
    showFrame(*surface, scene);
    const VmPicture first =
        scannedOut(GetParam() == PixelFormat::Rgb565 ? DRM_FORMAT_RGB565 : DRM_FORMAT_XRGB8888);
    std::shared_ptr<platform::HeldPicture> held = surface->holdShown();
    ASSERT_TRUE(held);
    const auto showColour = [&](float red) {
        ASSERT_TRUE(*surface->begin());
        scene.gl().ClearColor(red, 0, 0, 1);
        scene.gl().Clear(GL_COLOR_BUFFER_BIT);
        ASSERT_TRUE(surface->submit());
        ASSERT_TRUE(waitFor(*surface, platform::SurfaceState::Ready, std::chrono::seconds(2)));
    };
    for (int frame = 0; frame < 6; ++frame)
        showColour(1);
    Result<platform::ScreenPicture> copy = Error{};
    std::thread([&] { copy = held->read(); }).join();
    ASSERT_TRUE(copy) << toString(copy.error());
    const bool isNarrow = GetParam() == PixelFormat::Rgb565;
    const VmPicture kept = isNarrow ? narrowed(pictureOf(*copy)) : pictureOf(*copy);
    const VmPicture expected = isNarrow ? narrowed(first) : first;
    EXPECT_TRUE(kept == expected) << difference(kept, expected);
    held.reset(); // Its buffer is drawn to again.
    for (int frame = 0; frame < 6; ++frame)
        showColour(1);
    held = surface->holdShown();
    copy = held->read();
    ASSERT_TRUE(copy) << toString(copy.error());
    EXPECT_EQ(pictureOf(*copy).pixels, std::vector<std::uint32_t>(160UL * 120, 0xFF0000));
    surface.reset();
    EXPECT_EQ(held->read().error().code, "surface.picture") << "its buffers are gone";
}

} // namespace
} // namespace franken::test
