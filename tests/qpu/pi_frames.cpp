// SPDX-License-Identifier: MIT
// pi_frames [--cold] [--smooth] [--late-smooth]
//
// A kiosk's thousand frames on whatever driver EGL finds by GBM, and how many shaders the driver itself said
// that it compiled: a line "warm-up N", unless --cold leaves the warm-up out, and a line "frames N". What was
// compiled in frames is on standard error. --smooth gives all targets four samples a pixel, --late-smooth
// only those of the frames. pi_frames_test.cpp runs it on Mesa's vc4 and v3d drivers over the no-op DRM
// shims, which compile as they do on a Raspberry Pi and draw nothing: the target cannot be read back, so that
// programs are taken on trust.
#include "franken/gl_object.h"
#include "support/kiosk_frames.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES2/gl2ext.h>
#include <fcntl.h>
#include <gbm.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <iostream>

using namespace franken;

namespace {

constexpr int kFrames = 1000;

[[noreturn]] void fail(const std::string& what) {
    std::cerr << "pi_frames: " << what << "\n";
    std::exit(2);
}

template<typename T>
T valueOf(Result<T> result) {
    if (!result)
        fail(toString(result.error()));
    return *std::move(result);
}

void require(const Result<void>& result) {
    if (!result)
        fail(toString(result.error()));
}

void openContext() {
    const int node = open("/dev/dri/renderD128", O_RDWR);
    gbm_device* device = node < 0 ? nullptr : gbm_create_device(node);
    if (device == nullptr)
        fail("there is no GPU, and no shim that stands for one");
    const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_GBM_KHR, device, nullptr);
    if (!eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_ES_API))
        fail("EGL does not start");
    constexpr EGLint kVersion[] = {EGL_CONTEXT_CLIENT_VERSION, 2, EGL_NONE};
    const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kVersion);
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
        fail("no context");
}

std::vector<std::string> compiled; // What the driver said, since it was last cleared.

// "MESA_SHADER_FRAGMENT shader: 95 inst, 1 threads, ..." is said once for each compile.
void GL_APIENTRY receive(GLenum, GLenum, GLuint, GLenum, GLsizei length, const GLchar* text, const void*) {
    const std::string message(text, static_cast<std::size_t>(length));
    if (message.starts_with("MESA_SHADER_"))
        compiled.push_back(message);
}

void listen(const Gl& gl) {
    const auto callback =
        reinterpret_cast<PFNGLDEBUGMESSAGECALLBACKKHRPROC>(eglGetProcAddress("glDebugMessageCallbackKHR"));
    if (callback == nullptr)
        fail("the driver has no KHR_debug");
    gl.Enable(GL_DEBUG_OUTPUT_KHR);
    gl.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS_KHR);
    callback(receive, nullptr);
}

template<typename Function>
Function find(const char* name) {
    const auto function = reinterpret_cast<Function>(eglGetProcAddress(name));
    if (function == nullptr)
        fail(std::string("the driver has no ") + name);
    return function;
}

// GL_EXT_multisampled_render_to_texture: the samples are the driver's, and so are resolves.
void attachSmooth(GLuint color, int width, int height) {
    constexpr GLsizei kSamples = 4;
    find<PFNGLRENDERBUFFERSTORAGEMULTISAMPLEEXTPROC>("glRenderbufferStorageMultisampleEXT")(
        GL_RENDERBUFFER, kSamples, GL_DEPTH_COMPONENT16, width, height);
    find<PFNGLFRAMEBUFFERTEXTURE2DMULTISAMPLEEXTPROC>("glFramebufferTexture2DMultisampleEXT")(
        GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0, kSamples);
}

// As a surface would be: 8 bits a channel, 16 bits of depth.
DrawTarget makeTarget(const Gl& gl, int width, int height, bool smooth) {
    const GLuint color = generate(gl.GenTextures), depth = generate(gl.GenRenderbuffers);
    gl.BindTexture(GL_TEXTURE_2D, color);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.BindRenderbuffer(GL_RENDERBUFFER, depth);
    const GLuint framebuffer = generate(gl.GenFramebuffers);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    if (smooth) {
        attachSmooth(color, width, height);
    } else {
        gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT16, width, height);
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
    }
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        fail("the driver refuses the target");
    return {.framebuffer = framebuffer, .width = width, .height = height};
}

} // namespace

int main(int argc, char** argv) {
    const auto has = [&](const char* option) {
        return std::any_of(argv + 1, argv + argc,
                           [&](const char* given) { return std::strcmp(given, option) == 0; });
    };
    const bool smooth = has("--smooth"), lateSmooth = has("--late-smooth");
    openContext();
    const Gl gl =
        valueOf(Gl::load([](const char* name) { return reinterpret_cast<void*>(eglGetProcAddress(name)); }));
    std::cout << "driver " << reinterpret_cast<const char*>(gl.GetString(GL_RENDERER)) << "\n";
    listen(gl);
    const DrawTarget first = makeTarget(gl, 256, 256, smooth);
    std::vector<DrawTarget> targets;
    for (const auto& [width, height] : {std::pair(256, 256), {320, 200}, {64, 512}})
        targets.push_back(makeTarget(gl, width, height, smooth || lateSmooth));
    test::KioskFrames kiosk;
    Renderer renderer(gl, [](LogLevel, std::string_view text) { std::cerr << text << "\n"; });
    require(kiosk.load(renderer));
    if (!has("--cold")) {
        const WarmUpReport report = valueOf(renderer.warmUp(first, kiosk.uses()));
        std::cout << "programs " << report.programs << "\nwarm-up " << compiled.size() << "\n";
    }
    compiled.clear();
    for (int frame = 0; frame < kFrames; ++frame) {
        require(kiosk.draw(renderer, frame, targets));
        gl.Finish();
    }
    for (const std::string& message : compiled)
        std::cerr << message << "\n";
    std::cout << "frames " << compiled.size() << "\n";
    return 0;
}
