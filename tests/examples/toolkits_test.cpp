// SPDX-License-Identifier: MIT
// A model beside what a toolkit draws in the same context: each draws as if it were alone, frame after frame.
#include "franken/gl_object.h"
#include "franken/orbit_camera.h"
#include "support/draw_scene.h"
#include "support/shell.h"
#include "x_server.h"

#include <cmath>

namespace franken::test {
namespace {

/// The examples; empty where the toolkit is not installed.
const std::string kSdl2 = TOOLKIT_SDL2, kQt6 = TOOLKIT_QT6;

class Toolkits : public testing::Test {
protected:
    void SetUp() override {
        setenv("GALLIUM_DRIVER", "softpipe", 0);
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", 0);
    }

    /// Three frames of an example.
    std::vector<Picture> frames(const std::string& command) const {
        const Outcome outcome = runIn(m_folder, command + " " URN_GLB " 1.png 2.png 3.png");
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        std::vector<Picture> pictures;
        for (const char* file : {"1.png", "2.png", "3.png"})
            pictures.push_back(readPicture(m_folder / file));
        return pictures;
    }

    /// What the renderer draws alone, to a window's buffer or to a texture: Mesa counts their rows from other
    /// ends, and rounds texture coordinates accordingly. Alpha is 255 where the model is, and 0 elsewhere.
    static Picture alone(platform::Size size, bool toTexture) {
        const Result<Offscreen> offscreen = openOffscreen(platform::Backend::EglSurfaceless, size);
        EXPECT_TRUE(offscreen) << toString(offscreen.error());
        const Gl& gl = offscreen->gl;
        const GlTexture color(gl, generate(gl.GenTextures));
        const GlRenderbuffer depth(gl, generate(gl.GenRenderbuffers));
        const GlFramebuffer framebuffer(gl, generate(gl.GenFramebuffers));
        attach(gl, size, color.name(), depth.name(), framebuffer.name());
        Shot shot = shotOf(URN_GLB);
        const Box bounds = shot.scene.bounds();
        shot.camera = tightened(OrbitCamera(framingCamera(bounds, 1), bounds).camera(), bounds);
        shot.lighting = {.suns = {{.direction = {-1, -2, -3}, .illuminance = 3}},
                         .ambient = {.kind = Ambient::Color, .color = {0.3f, 0.3f, 0.3f}}};
        const unsigned target = toTexture ? framebuffer.name() : offscreen->surface->framebuffer();
        drawShot(gl,
                 {.framebuffer = target, .width = size.width, .height = size.height, .backgroundAlpha = 0},
                 shot, Capabilities::query(gl));
        return readBack(*offscreen, target);
    }

    const std::filesystem::path m_folder = emptyTestFolder();

private:
    static void attach(const Gl& gl, platform::Size size, GLuint color, GLuint depth, GLuint framebuffer) {
        gl.BindTexture(GL_TEXTURE_2D, color);
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                      nullptr);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl.BindRenderbuffer(GL_RENDERBUFFER, depth);
        constexpr GLenum kDepth24 = 0x81A6; // GL_OES_depth24, which Mesa has.
        gl.RenderbufferStorage(GL_RENDERBUFFER, kDepth24, size.width, size.height);
        gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    }
};

using Color = std::array<double, 3>;

Color colorAt(const Picture& picture, int x, int y) {
    const std::uint8_t* texel = &picture.rgba.at(4 * static_cast<std::size_t>(y * picture.width + x));
    return {1.0 * texel[0], 1.0 * texel[1], 1.0 * texel[2]};
}

bool covers(const Picture& alone, int x, int y) {
    return alone.rgba.at(4 * static_cast<std::size_t>(y * alone.width + x) + 3) != 0;
}

/// `over` covers that share of `below`.
Color mixed(const Color& below, const Color& over, double share) {
    Color color;
    for (std::size_t i = 0; i < 3; ++i)
        color[i] = below[i] + share * (over[i] - below[i]);
    return color;
}

/// How many pixels are further from what is expected than that, and how many there are.
struct Count {
    int wrong = 0, all = 0;
    void add(const Color& actual, const Color& expected, double codes) {
        bool right = true;
        for (std::size_t i = 0; i < 3; ++i)
            right = right && std::abs(actual[i] - expected[i]) <= codes;
        wrong += right ? 0 : 1;
        ++all;
    }
};

constexpr Color kBlue = {0, 0, 255};
constexpr double kHalf = 128.0 / 255;

TEST_F(Toolkits, SdlDrawsBeforeTheModelAndOverIt) {
    if (kSdl2.empty())
        GTEST_SKIP() << "needs SDL 2 (Debian package libsdl2-dev)";
    const Picture model = alone({240, 240}, false);
    for (const Picture& frame : frames("SDL_VIDEODRIVER=offscreen " + kSdl2)) {
        ASSERT_EQ(frame.rgba.size(), 4u * 320 * 240);
        Count panel, bar, surfaces, background, band;
        for (int y = 0; y < 240; ++y)
            for (int x = 0; x < 320; ++x) {
                const Color color = colorAt(frame, x, y);
                const bool inBar = x >= 20 && x < 60 && y >= 168; // Three tenths of the window.
                const bool covered = x >= 80 && covers(model, x - 80, y);
                const Color below = covered ? colorAt(model, x - 80, y) : Color{26, 26, 26};
                if (x < 80)
                    (inBar ? bar : panel).add(color, inBar ? Color{255, 200, 60} : Color{32, 48, 64}, 0);
                else if (y >= 200)
                    band.add(color, mixed(below, kBlue, kHalf), 1.5); // Rounded once more.
                else
                    (covered ? surfaces : background).add(color, below, covered ? 1 : 0);
            }
        for (const Count* count : {&panel, &bar, &surfaces, &background, &band}) {
            EXPECT_EQ(count->wrong, 0) << "of " << count->all;
            EXPECT_GT(count->all, 2000);
        }
    }
}

/// The background of the example's window: a gradient of Qt's.
Color dusk(int y) { return mixed({0, 30, 90}, {230, 120, 60}, (y + 0.5) / 240); }

bool inLabel(int x, int y) { return x >= 10 && x < 310 && y >= 190 && y < 230; }

void expectQtAndModel(const Picture& frame, const Picture& model) {
    ASSERT_EQ(frame.rgba.size(), model.rgba.size());
    Count surfaces, background, label;
    int text = 0;
    for (int y = 0; y < 240; ++y)
        for (int x = 0; x < 320; ++x) {
            const Color color = colorAt(frame, x, y);
            const bool covered = covers(model, x, y);
            text += inLabel(x, y) && color[0] > 220 && color[1] > 220 ? 1 : 0;
            if (y < 190)
                covered ? surfaces.add(color, colorAt(model, x, y), 1) : background.add(color, dusk(y), 2);
            else if (x > 20 && x < 90 && y < 228) // Left of the text and of the model, without its corners.
                label.add(color, mixed(dusk(y), kBlue, kHalf), y > 191 ? 3 : 255);
        }
    for (const Count* count : {&surfaces, &background, &label}) {
        EXPECT_EQ(count->wrong, 0) << "of " << count->all;
        EXPECT_GT(count->all, 2000);
    }
    EXPECT_GT(text, 40) << "the label's text";
    EXPECT_LT(text, 400) << "the label's text";
}

TEST_F(Toolkits, QtDrawsBeforeTheModelAndOverIt) {
    if (kQt6.empty())
        GTEST_SKIP() << "needs Qt 6 (Debian package qt6-base-dev)";
    if (runIn(m_folder, "command -v Xvfb").code != 0)
        GTEST_SKIP() << "needs an X server (Debian package xvfb)";
    const XServer server(m_folder.string());
    ASSERT_FALSE(server.display().empty());
    const Picture model = alone({320, 240}, true);
    for (const char* contexts : {"xcb_egl", "xcb_glx"})
        for (const Picture& frame :
             frames("DISPLAY=" + server.display() + " QT_QPA_PLATFORM=xcb QT_SCALE_FACTOR=1 " +
                    "QT_XCB_GL_INTEGRATION=" + contexts + " " + kQt6))
            expectQtAndModel(frame, model);
}

TEST_F(Toolkits, SayWhatTheyCannotShow) {
    if (kSdl2.empty())
        GTEST_SKIP() << "needs SDL 2 (Debian package libsdl2-dev)";
    const Outcome outcome = runIn(m_folder, "SDL_VIDEODRIVER=offscreen " + kSdl2 + " missing.glb 1.png");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("missing.glb"), std::string::npos) << outcome.err;
    EXPECT_EQ(runIn(m_folder, kSdl2).code, 2);
}

} // namespace
} // namespace franken::test
