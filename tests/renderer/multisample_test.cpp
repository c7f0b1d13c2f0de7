// SPDX-License-Identifier: MIT
// Targets with several samples a pixel. Of Mesa's software drivers llvmpipe alone has them, so it draws here,
// and pictures are compared with its own ones without multisampling.
#include "franken/gl_object.h"
#include "support/draw_scene.h"
#include "support/kiosk_frames.h"
#include "support/shapes.h"

#include <glm/ext/matrix_transform.hpp>

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <cstdlib>
#include <set>

namespace franken::test {
namespace {

constexpr int kSize = 64, kSamples = 4;

/// What the target shows: the mean of each pixel's samples. llvmpipe's glReadPixels takes the first sample of
/// each, so a copy to a texture is read.
ReadBack resolved(const Offscreen& offscreen) {
    constexpr GLenum kReadFramebuffer = 0x8CA8, kDrawFramebuffer = 0x8CA9; // As in GLES3/gl3.h.
    using Blit = void (*)(GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLbitfield, GLenum);
    const auto blit = reinterpret_cast<Blit>(offscreen.surface->getProcAddress()("glBlitFramebuffer"));
    const Gl& gl = offscreen.gl;
    const GlTexture texture(gl, generate(gl.GenTextures));
    const GlFramebuffer framebuffer(gl, generate(gl.GenFramebuffers));
    gl.BindTexture(GL_TEXTURE_2D, texture.name());
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, kSize, kSize, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl.BindFramebuffer(kReadFramebuffer, offscreen.surface->framebuffer());
    gl.BindFramebuffer(kDrawFramebuffer, framebuffer.name());
    gl.FramebufferTexture2D(kDrawFramebuffer, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.name(), 0);
    blit(0, 0, kSize, kSize, 0, 0, kSize, kSize, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    const ReadBack image = readBack(offscreen, framebuffer.name());
    EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
    return image;
}

class MultisampleTest : public testing::TestWithParam<platform::Backend> {
protected:
    static void SetUpTestSuite() {
        constexpr int kReplace = 1;
        setenv("GALLIUM_DRIVER", "llvmpipe", kReplace);
    }

    void SetUp() override {
        Result<Offscreen> plain = openOffscreen(GetParam(), {kSize, kSize});
        if (!plain && plain.error().code == "surface.not-installed")
            GTEST_SKIP() << toString(plain.error());
        ASSERT_TRUE(plain) << toString(plain.error());
        Result<Offscreen> smooth = openOffscreen(GetParam(), {kSize, kSize}, kSamples);
        ASSERT_TRUE(smooth) << toString(smooth.error());
        if (smooth->surface->samples() == 0)
            GTEST_SKIP() << "the backend has no targets with several samples a pixel: "
                         << smooth->surface->driver();
        ASSERT_EQ(smooth->surface->samples(), kSamples);
        m_plain = *std::move(plain);
        m_smooth = *std::move(smooth);
    }

    static ReadBack draw(const Offscreen& offscreen, const Shot& shot) {
        EXPECT_TRUE(offscreen.surface->makeCurrent());
        drawShot(offscreen.gl, *offscreen.surface, shot);
        return resolved(offscreen);
    }

    Offscreen m_plain, m_smooth;
};

INSTANTIATE_TEST_SUITE_P(Backends, MultisampleTest, allBackends(), backendName);

/// How many samples a pixel has, at the most, of what EGL itself offers for pictures of RGBA8 without a
/// window.
int samplesOfEgl() {
    const EGLDisplay display =
        eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr))
        return 0;
    const EGLint attributes[] = {EGL_SURFACE_TYPE,
                                 EGL_PBUFFER_BIT,
                                 EGL_RENDERABLE_TYPE,
                                 EGL_OPENGL_ES2_BIT,
                                 EGL_RED_SIZE,
                                 8,
                                 EGL_ALPHA_SIZE,
                                 8,
                                 EGL_SAMPLES,
                                 kSamples,
                                 EGL_NONE};
    EGLint count = 0;
    eglChooseConfig(display, attributes, nullptr, 0, &count);
    return count > 0 ? kSamples : 0;
}

// Does not skip: where the driver has such targets, the tests above must not skip either.
TEST(Multisampling, IsThereWhereTheDriverOffersIt) {
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    const int offered = samplesOfEgl();
    std::cout << "EGL offers " << offered << " samples a pixel\n";
    for (const platform::Backend backend : {platform::Backend::OsMesa, platform::Backend::EglSurfaceless}) {
        const Result<Offscreen> smooth = openOffscreen(backend, {kSize, kSize}, kSamples);
        const bool installed = smooth || smooth.error().code != "surface.not-installed";
        ASSERT_EQ(installed, bool(smooth)) << toString(smooth.error());
        if (!installed)
            continue;
        GLint samples = -1;
        smooth->gl.GetIntegerv(GL_SAMPLES, &samples);
        EXPECT_EQ(smooth->surface->samples(), samples);
        EXPECT_EQ(samples, backend == platform::Backend::EglSurfaceless ? offered : 0)
            << platform::toString(backend);
    }
}

Camera cameraAt(float distance) {
    Camera camera;
    camera.world[3] = glm::vec4(0, 0, distance, 1);
    return camera;
}

/// A tilted square, so that no edge lies along a row or a column. It has one plane: what a pixel shows does
/// not depend on which of its two triangles covers which sample.
Shot tilted(Material material, SceneBuilder builder) {
    const glm::mat4 world = glm::rotate(glm::rotate(glm::mat4(1), 0.3f, {0, 0, 1}), 0.4f, {1, 1, 0});
    builder.add(square(), builder.addMaterial(material), world);
    return {.scene = builder.scene, .camera = cameraAt(4), .lighting = {}};
}

TEST_P(MultisampleTest, AnEdgeTakesAsManySamplesAsItCovers) {
    Material white;
    white.unlit = true;
    const Shot shot = tilted(white, {});
    const auto codesOf = [](const ReadBack& picture) {
        std::set<int> codes;
        for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
            codes.insert(picture.rgba[i]);
        return codes;
    };
    EXPECT_EQ(codesOf(draw(m_plain, shot)), (std::set<int>{0, 255}));
    EXPECT_EQ(codesOf(draw(m_smooth, shot)), (std::set<int>{0, 64, 128, 191, 255}));
}

/// Whether the pixel and its eight neighbours show the model, or none does.
bool isInterior(const ReadBack& picture, int x, int y) {
    const auto lit = [&](int column, int row) {
        const auto pixel = picture.pixel(column, row);
        return pixel[0] + pixel[1] + pixel[2] > 0;
    };
    for (int row = std::max(0, y - 1); row <= std::min(kSize - 1, y + 1); ++row)
        for (int column = std::max(0, x - 1); column <= std::min(kSize - 1, x + 1); ++column)
            if (lit(column, row) != lit(x, y))
                return false;
    return true;
}

TEST_P(MultisampleTest, TheInteriorOfAModelIsAsWithout) {
    SceneBuilder builder;
    Material material;
    material.baseColorTexture.texture = builder.addTexture(checkers(64, 8, {1, 0.3f, 0.1f, 1}, glm::vec4(1)));
    material.normalTexture.texture = builder.addTexture(bumps(64, 6));
    material.roughness = 0.4f;
    Shot shot = tilted(material, builder);
    shot.lighting.suns = {{.direction = {-1, -1, -1}, .illuminance = 3}};
    shot.lighting.ambient = {.kind = Ambient::Color, .color = {0.3f, 0.3f, 0.3f}};
    const ReadBack plain = draw(m_plain, shot), smooth = draw(m_smooth, shot);
    int interior = 0, edges = 0, softened = 0;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x)
            if (isInterior(plain, x, y)) {
                ++interior;
                EXPECT_EQ(smooth.pixel(x, y), plain.pixel(x, y)) << x << ", " << y;
            } else {
                ++edges;
                softened += smooth.pixel(x, y) != plain.pixel(x, y);
            }
    EXPECT_GT(interior, 3000);
    // That band is two pixels wide, and more than every second step along an edge parts some samples.
    EXPECT_GT(softened, edges / 4) << edges << " pixels at the silhouette";
}

TEST_P(MultisampleTest, FramesCompileNothingAfterAWarmUp) {
    const DrawTarget target{m_smooth.surface->framebuffer(), kSize, kSize};
    std::vector<std::string> log;
    KioskFrames kiosk;
    Renderer renderer(m_smooth.gl, [&](LogLevel, std::string_view text) { log.emplace_back(text); });
    ASSERT_TRUE(kiosk.load(renderer));
    const Result<WarmUpReport> report = renderer.warmUp(target, kiosk.uses());
    ASSERT_TRUE(report);
    EXPECT_EQ(report->failed, 0u);
    EXPECT_EQ(log, std::vector<std::string>()) << "samples are read back as pixels";
    const ProgramCounters before = renderer.programCounters();
    for (int frame = 0; frame < 210; ++frame)
        ASSERT_TRUE(kiosk.draw(renderer, frame, {target}));
    EXPECT_EQ(renderer.programCounters().compiles, before.compiles);
    EXPECT_EQ(renderer.programCounters().links, before.links);
    EXPECT_TRUE(renderer.takeMisses().empty());
    EXPECT_EQ(m_smooth.gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

} // namespace
} // namespace franken::test
