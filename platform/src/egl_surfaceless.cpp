// SPDX-License-Identifier: MIT
#include "backends.h"
#include "egl.h"

#include <EGL/eglext.h>

#include <optional>

namespace franken::platform {

namespace {

/// EGL keeps one such display for the process, and eglTerminate() would take all contexts with it: whoever
/// comes first opens it, and it stays. Opening it again is free; where it failed, it is tried anew.
Result<EGLDisplay> openDisplay() {
    const EGLDisplay display =
        eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY)
        return Error{"surface.not-installed", "eglGetPlatformDisplay",
                     "no EGL driver offers EGL_PLATFORM_SURFACELESS_MESA", kInstallEgl};
    if (!eglInitialize(display, nullptr, nullptr))
        return lastEglError("eglInitialize", kInstallEgl);
    return display;
}

/// eglChooseConfig() puts the deepest colours first; the target has to be RGBA8 everywhere, to compare
/// pictures.
std::optional<EGLConfig> chooseConfig(EGLDisplay display, int depthBits, int samples) {
    const auto has8Bits = [&](EGLConfig config, EGLint channel) {
        EGLint bits = 0;
        return eglGetConfigAttrib(display, config, channel, &bits) && bits == 8;
    };
    for (EGLConfig config : configsFor(display, EGL_PBUFFER_BIT, depthBits, samples))
        if (has8Bits(config, EGL_RED_SIZE) && has8Bits(config, EGL_GREEN_SIZE) &&
            has8Bits(config, EGL_BLUE_SIZE) && has8Bits(config, EGL_ALPHA_SIZE))
            return config;
    return std::nullopt;
}

class EglSurface final : public ImmediateSurface {
public:
    EglSurface(EGLDisplay display, Size size)
        : ImmediateSurface(Backend::EglSurfaceless, size), m_display(display) {}

    ~EglSurface() override { close(); }

    Result<void> open(const SurfaceOptions& options);

    GetProcAddress getProcAddress() const override { return eglFunction; }

protected:
    Result<void> swap() override { return swapEglBuffers(m_display, m_pbuffer); }
    Result<void> bind() override;
    void unbind() override { eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }

private:
    Result<void> openWith(EGLConfig config, const SurfaceOptions& options);

    /// Mesa 25.0.7 gives a pbuffer of several samples no colour buffer: what is drawn is lost, and reading it
    /// is an error.
    bool hasColors() const;

    void close();
    EGLSurface createPbuffer(EGLConfig config, bool srgb) const;

    EGLDisplay m_display;
    EGLContext m_context = EGL_NO_CONTEXT;
    EGLSurface m_pbuffer = EGL_NO_SURFACE;
};

Result<void> EglSurface::open(const SurfaceOptions& options) {
    std::optional<EGLConfig> smooth;
    if (options.samples > 0)
        smooth = chooseConfig(m_display, options.depthBits, options.samples);
    if (smooth && openWith(*smooth, options) && hasColors())
        return {};
    close();
    const std::optional<EGLConfig> config = chooseConfig(m_display, options.depthBits, 0);
    if (!config)
        return Error{"surface.driver", "eglChooseConfig",
                     "the driver has no RGBA8 pbuffer for OpenGL ES 2.0 with " +
                         std::to_string(options.depthBits) + " bits of depth",
                     "ask for 24 bits or fewer"};
    return openWith(*config, options);
}

Result<void> EglSurface::openWith(EGLConfig config, const SurfaceOptions& options) {
    const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 2, EGL_NONE};
    eglBindAPI(EGL_OPENGL_ES_API);
    m_context = eglCreateContext(m_display, config, EGL_NO_CONTEXT, version);
    if (m_context == EGL_NO_CONTEXT)
        return lastEglError("eglCreateContext", kInstallEgl);
    m_pbuffer = createPbuffer(config, options.srgb);
    m_srgbTarget = options.srgb && m_pbuffer != EGL_NO_SURFACE;
    if (m_pbuffer == EGL_NO_SURFACE)
        m_pbuffer = createPbuffer(config, false);
    if (m_pbuffer == EGL_NO_SURFACE)
        return lastEglError("eglCreatePbufferSurface", "choose a smaller size");
    eglGetConfigAttrib(m_display, config, EGL_SAMPLES, &m_samples);
    return makeReady();
}

bool EglSurface::hasColors() const {
    constexpr unsigned kRgba = 0x1908, kUnsignedByte = 0x1401; // As in GLES2/gl2.h.
    using ReadPixels = void (*)(int, int, int, int, unsigned, unsigned, void*);
    using GetError = unsigned (*)();
    unsigned char pixel[4] = {};
    reinterpret_cast<ReadPixels>(eglFunction("glReadPixels"))(0, 0, 1, 1, kRgba, kUnsignedByte, pixel);
    return reinterpret_cast<GetError>(eglFunction("glGetError"))() == 0;
}

void EglSurface::close() {
    letGo();
    if (m_pbuffer != EGL_NO_SURFACE)
        eglDestroySurface(m_display, m_pbuffer);
    if (m_context != EGL_NO_CONTEXT)
        eglDestroyContext(m_display, m_context);
    m_pbuffer = EGL_NO_SURFACE;
    m_context = EGL_NO_CONTEXT;
}

EGLSurface EglSurface::createPbuffer(EGLConfig config, bool srgb) const {
    EGLint attributes[] = {EGL_WIDTH, m_size.width, EGL_HEIGHT, m_size.height, EGL_NONE, EGL_NONE, EGL_NONE};
    if (srgb) { // EGL_KHR_gl_colorspace; a driver without it refuses.
        attributes[4] = EGL_GL_COLORSPACE_KHR;
        attributes[5] = EGL_GL_COLORSPACE_SRGB_KHR;
    }
    return eglCreatePbufferSurface(m_display, config, attributes);
}

Result<void> EglSurface::bind() {
    if (!eglMakeCurrent(m_display, m_pbuffer, m_pbuffer, m_context))
        return lastEglError("eglMakeCurrent", "destroy or release the surface in the thread that uses it");
    return {};
}

} // namespace

Result<std::unique_ptr<Surface>> createEglSurfaceless(const SurfaceOptions& options) {
    const Result<EGLDisplay> display = openDisplay();
    if (!display)
        return display.error();
    auto surface = std::make_unique<EglSurface>(*display, options.size);
    if (Result<void> opened = surface->open(options); !opened)
        return opened.error();
    return std::unique_ptr<Surface>(std::move(surface));
}

} // namespace franken::platform
