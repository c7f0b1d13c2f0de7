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
#include <optional>
#include <set>
#include <tuple>

namespace franken::test {
namespace {

constexpr int kSize = 64, kSamples = 4;

constexpr GLenum kReadFramebuffer = 0x8CA8, kDrawFramebuffer = 0x8CA9; // As in GLES3/gl3.h.

template<typename Function>
Function functionOf(const Offscreen& offscreen, const char* name) {
    return reinterpret_cast<Function>(offscreen.surface->getProcAddress()(name));
}

/// Whose samples are drawn to.
enum class Owner {
    Surface,    ///< The driver's, of a surface of EGL or OSMesa.
    Framebuffer ///< An application's: a framebuffer object, of which glReadPixels is an error.
};

std::string nameOf(Owner owner) { return owner == Owner::Surface ? "surface" : "framebuffer"; }

/// A framebuffer object with so many samples a pixel; without a name where the driver has none.
class OwnFramebuffer {
public:
    OwnFramebuffer(const Offscreen& offscreen, int samples) : m_gl(&offscreen.gl) {
        constexpr GLenum kRgba8 = 0x8058;
        const auto storage = functionOf<void (*)(GLenum, GLsizei, GLenum, GLsizei, GLsizei)>(
            offscreen, "glRenderbufferStorageMultisample");
        if (storage == nullptr)
            return;
        m_framebuffer = GlFramebuffer(*m_gl, generate(m_gl->GenFramebuffers));
        m_gl->BindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.name());
        for (const auto& [buffer, format, attachment] :
             {std::tuple{&m_color, kRgba8, GLenum{GL_COLOR_ATTACHMENT0}},
              std::tuple{&m_depth, GLenum{GL_DEPTH_COMPONENT16}, GLenum{GL_DEPTH_ATTACHMENT}}}) {
            *buffer = GlRenderbuffer(*m_gl, generate(m_gl->GenRenderbuffers));
            m_gl->BindRenderbuffer(GL_RENDERBUFFER, buffer->name());
            storage(GL_RENDERBUFFER, samples, format, kSize, kSize);
            m_gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer->name());
        }
        if (m_gl->GetError() != GL_NO_ERROR ||
            m_gl->CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            m_framebuffer = {};
    }

    GLuint name() const { return m_framebuffer.name(); }

private:
    const Gl* m_gl;
    GlRenderbuffer m_color, m_depth;
    GlFramebuffer m_framebuffer;
};

/// What a framebuffer shows: the mean of each pixel's samples. It is copied to a texture and read there:
/// llvmpipe's glReadPixels takes the first sample of a surface, and that of a framebuffer object is an error.
ReadBack resolved(const Offscreen& offscreen, GLuint drawn) {
    using Blit = void (*)(GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLbitfield, GLenum);
    const auto blit = functionOf<Blit>(offscreen, "glBlitFramebuffer");
    const Gl& gl = offscreen.gl;
    const GlTexture texture(gl, generate(gl.GenTextures));
    const GlFramebuffer framebuffer(gl, generate(gl.GenFramebuffers));
    gl.BindTexture(GL_TEXTURE_2D, texture.name());
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, kSize, kSize, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl.BindFramebuffer(kReadFramebuffer, drawn);
    gl.BindFramebuffer(kDrawFramebuffer, framebuffer.name());
    gl.FramebufferTexture2D(kDrawFramebuffer, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.name(), 0);
    blit(0, 0, kSize, kSize, 0, 0, kSize, kSize, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    const ReadBack image = readBack(offscreen, framebuffer.name());
    EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
    return image;
}

class MultisampleTest : public testing::TestWithParam<std::tuple<platform::Backend, Owner>> {
protected:
    static void SetUpTestSuite() {
        constexpr int kReplace = 1;
        setenv("GALLIUM_DRIVER", "llvmpipe", kReplace);
    }

    void SetUp() override {
        const auto [backend, owner] = GetParam();
        Result<Offscreen> plain = openOffscreen(backend, {kSize, kSize});
        if (!plain && plain.error().code == "surface.not-installed")
            GTEST_SKIP() << toString(plain.error());
        ASSERT_TRUE(plain) << toString(plain.error());
        Result<Offscreen> smooth =
            openOffscreen(backend, {kSize, kSize}, owner == Owner::Surface ? kSamples : 0);
        ASSERT_TRUE(smooth) << toString(smooth.error());
        m_plain.offscreen = *std::move(plain);
        m_smooth.offscreen = *std::move(smooth);
        if (owner == Owner::Framebuffer) {
            ASSERT_TRUE(m_plain.offscreen.surface->makeCurrent());
            m_plain.own.emplace(m_plain.offscreen, 0);
            ASSERT_TRUE(m_smooth.offscreen.surface->makeCurrent());
            m_smooth.own.emplace(m_smooth.offscreen, kSamples);
        }
        GLint samples = 0;
        m_smooth.bind();
        m_smooth.offscreen.gl.GetIntegerv(GL_SAMPLES, &samples);
        if (samples == 0)
            GTEST_SKIP() << "the driver has no " << nameOf(owner)
                         << " with several samples a pixel: " << m_smooth.offscreen.surface->driver();
        ASSERT_EQ(samples, kSamples);
    }

    struct Drawn {
        Offscreen offscreen;
        std::optional<OwnFramebuffer> own = {};

        ~Drawn() {
            if (own && !offscreen.surface->makeCurrent())
                ADD_FAILURE() << "the context of the framebuffer is gone";
        }

        DrawTarget target() const {
            return {own ? own->name() : offscreen.surface->framebuffer(), kSize, kSize};
        }

        void bind() const {
            ASSERT_TRUE(offscreen.surface->makeCurrent());
            offscreen.gl.BindFramebuffer(GL_FRAMEBUFFER, target().framebuffer);
        }

        ReadBack draw(const Shot& shot) const {
            bind();
            drawShot(offscreen.gl, target(), shot, Capabilities::query(offscreen.gl));
            return resolved(offscreen, target().framebuffer);
        }
    };

    Drawn m_plain, m_smooth;
};

INSTANTIATE_TEST_SUITE_P(Backends, MultisampleTest,
                         testing::Combine(allBackends(), testing::Values(Owner::Surface, Owner::Framebuffer)),
                         [](const auto& test) {
                             return nameOf(std::get<1>(test.param)) + "_" +
                                    std::string(platform::toString(std::get<0>(test.param)));
                         });

/// How many samples a pixel has, at the most, of what EGL itself offers for pictures of RGBA8 without a
/// window; 0 as well where they have no colour, as with Mesa 25.0.7, so that reading is an error.
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
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, attributes, &config, 1, &count) || count == 0)
        return 0;
    const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 2, EGL_NONE};
    const EGLint size[] = {EGL_WIDTH, kSize, EGL_HEIGHT, kSize, EGL_NONE};
    eglBindAPI(EGL_OPENGL_ES_API);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
    const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    EXPECT_TRUE(eglMakeCurrent(display, surface, surface, context));
    const auto read = reinterpret_cast<void (*)(GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void*)>(
        eglGetProcAddress("glReadPixels"));
    const auto error = reinterpret_cast<GLenum (*)()>(eglGetProcAddress("glGetError"));
    std::array<std::uint8_t, 4> pixel{};
    read(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
    const bool hasColors = error() == GL_NO_ERROR;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroySurface(display, surface);
    eglDestroyContext(display, context);
    return hasColors ? kSamples : 0;
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
        EXPECT_GT(OwnFramebuffer(*smooth, kSamples).name(), 0u)
            << "llvmpipe has framebuffer objects of 4 samples";
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
    EXPECT_EQ(codesOf(m_plain.draw(shot)), (std::set<int>{0, 255}));
    EXPECT_EQ(codesOf(m_smooth.draw(shot)), (std::set<int>{0, 64, 128, 191, 255}));
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
    material.textures[TextureRole::BaseColor].texture =
        builder.addTexture(checkers(64, 8, {1, 0.3f, 0.1f, 1}, glm::vec4(1)));
    material.textures[TextureRole::Normal].texture = builder.addTexture(bumps(64, 6));
    material.factors.roughness = 0.4f;
    Shot shot = tilted(material, builder);
    shot.lighting.suns = {{.direction = {-1, -1, -1}, .illuminance = 3}};
    shot.lighting.ambient = {.kind = Ambient::Color, .color = {0.3f, 0.3f, 0.3f}};
    const ReadBack plain = m_plain.draw(shot), smooth = m_smooth.draw(shot);
    int interior = 0, edges = 0, softened = 0, differing = 0;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x)
            if (isInterior(plain, x, y)) {
                ++interior;
                differing += smooth.pixel(x, y) != plain.pixel(x, y);
            } else {
                ++edges;
                softened += smooth.pixel(x, y) != plain.pixel(x, y);
            }
    EXPECT_EQ(differing, 0) << "of the " << interior << " pixels inside and outside";
    EXPECT_GT(interior, 3000);
    // That band is two pixels wide, and more than every second step along an edge parts some samples.
    EXPECT_GT(softened, edges / 4) << edges << " pixels at the silhouette";
}

TEST_P(MultisampleTest, FramesCompileNothingAfterAWarmUp) {
    const DrawTarget target = m_smooth.target();
    std::vector<std::string> log;
    KioskFrames kiosk;
    Renderer renderer(m_smooth.offscreen.gl,
                      [&](LogLevel, std::string_view text) { log.emplace_back(text); });
    ASSERT_TRUE(kiosk.load(renderer));
    const Result<WarmUpReport> report = renderer.warmUp(target, kiosk.uses());
    ASSERT_TRUE(report);
    EXPECT_EQ(report->failed, 0u);
    EXPECT_EQ(log, std::vector<std::string>()) << "proving is not blind";
    const ProgramCounters before = renderer.programCounters();
    for (int frame = 0; frame < 210; ++frame)
        ASSERT_TRUE(kiosk.draw(renderer, frame, {target}));
    EXPECT_EQ(renderer.programCounters().compiles, before.compiles);
    EXPECT_EQ(renderer.programCounters().links, before.links);
    EXPECT_TRUE(renderer.takeMisses().empty());
    EXPECT_EQ(m_smooth.offscreen.gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

// glReadPixels of such a framebuffer object is an error of GL: not a black picture.
TEST_P(MultisampleTest, ReadingSamplesOfAFramebufferObjectIsAnError) {
    if (!m_smooth.own)
        GTEST_SKIP() << "a surface's samples can be read";
    Renderer renderer(m_smooth.offscreen.gl);
    const Result<Image> image = renderer.readPixels(m_smooth.target());
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().code, "renderer.target");
    EXPECT_NE(image.error().what.find("several samples"), std::string::npos) << toString(image.error());
}

} // namespace
} // namespace franken::test
