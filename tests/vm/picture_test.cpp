// SPDX-License-Identifier: MIT
//
// What the screen shows is what would have been drawn without one, byte for byte.
#include "support/guest.h"

#include <drm_fourcc.h>

#include <algorithm>

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

} // namespace
} // namespace franken::test
