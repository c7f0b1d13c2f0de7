// SPDX-License-Identifier: MIT
#include "backends.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <optional>
#include <vector>

namespace franken::platform {

namespace {

struct NamedError {
    EGLint error;
    const char* name;
};

constexpr NamedError kErrors[] = {
    {EGL_SUCCESS, "no error"},
    {EGL_NOT_INITIALIZED, "EGL_NOT_INITIALIZED"},
    {EGL_BAD_ACCESS, "EGL_BAD_ACCESS"},
    {EGL_BAD_ALLOC, "EGL_BAD_ALLOC"},
    {EGL_BAD_ATTRIBUTE, "EGL_BAD_ATTRIBUTE"},
    {EGL_BAD_CONFIG, "EGL_BAD_CONFIG"},
    {EGL_BAD_CONTEXT, "EGL_BAD_CONTEXT"},
    {EGL_BAD_CURRENT_SURFACE, "EGL_BAD_CURRENT_SURFACE"},
    {EGL_BAD_DISPLAY, "EGL_BAD_DISPLAY"},
    {EGL_BAD_MATCH, "EGL_BAD_MATCH"},
    {EGL_BAD_NATIVE_PIXMAP, "EGL_BAD_NATIVE_PIXMAP"},
    {EGL_BAD_NATIVE_WINDOW, "EGL_BAD_NATIVE_WINDOW"},
    {EGL_BAD_PARAMETER, "EGL_BAD_PARAMETER"},
    {EGL_BAD_SURFACE, "EGL_BAD_SURFACE"},
    {EGL_CONTEXT_LOST, "EGL_CONTEXT_LOST"},
};

std::string nameOf(EGLint error) {
    for (const NamedError& row : kErrors)
        if (row.error == error)
            return row.name;
    return "EGL error " + std::to_string(error);
}

/// Of the call that failed just now.
Error lastError(const char* call, const char* remedy) {
    return Error{"surface.driver", call, "the driver reports " + nameOf(eglGetError()), remedy};
}

constexpr const char* kInstall =
    "install the Debian packages libegl1, libegl-mesa0 and libgl1-mesa-dri, or choose another backend";

/// EGL keeps one such display for the process, and eglTerminate() would take all contexts with it: whoever
/// comes first opens it, and it stays.
Result<EGLDisplay> openDisplay() {
    const EGLDisplay display =
        eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY)
        return Error{"surface.not-installed", "eglGetPlatformDisplay",
                     "no EGL driver offers EGL_PLATFORM_SURFACELESS_MESA", kInstall};
    if (!eglInitialize(display, nullptr, nullptr))
        return lastError("eglInitialize", kInstall);
    return display;
}

/// eglChooseConfig() puts the deepest colours first; the target has to be RGBA8 everywhere, to compare
/// pictures.
std::optional<EGLConfig> chooseConfig(EGLDisplay display, int depthBits, int samples) {
    const EGLint attributes[] = {
        EGL_DEPTH_SIZE,     depthBits,   EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
        EGL_OPENGL_ES2_BIT, EGL_SAMPLES, samples,          EGL_NONE};
    EGLint count = 0;
    eglChooseConfig(display, attributes, nullptr, 0, &count);
    std::vector<EGLConfig> configs(static_cast<std::size_t>(count));
    eglChooseConfig(display, attributes, configs.data(), count, &count);
    const auto has8Bits = [&](EGLConfig config, EGLint channel) {
        EGLint bits = 0;
        return eglGetConfigAttrib(display, config, channel, &bits) && bits == 8;
    };
    for (EGLConfig config : configs)
        if (has8Bits(config, EGL_RED_SIZE) && has8Bits(config, EGL_GREEN_SIZE) &&
            has8Bits(config, EGL_BLUE_SIZE) && has8Bits(config, EGL_ALPHA_SIZE))
            return config;
    return std::nullopt;
}

class EglSurface final : public Surface {
public:
    EglSurface(EGLDisplay display, Size size) : Surface(Backend::EglSurfaceless, size), m_display(display) {}

    ~EglSurface() override {
        letGo();
        if (m_pbuffer != EGL_NO_SURFACE)
            eglDestroySurface(m_display, m_pbuffer);
        if (m_context != EGL_NO_CONTEXT)
            eglDestroyContext(m_display, m_context);
    }

    Result<void> open(const SurfaceOptions& options);

    GetProcAddress getProcAddress() const override {
        return [](const char* name) { return reinterpret_cast<void*>(eglGetProcAddress(name)); };
    }

    Result<void> present() override;

protected:
    Result<void> bind() override;
    void unbind() override { eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }

private:
    EGLSurface createPbuffer(EGLConfig config, bool srgb) const;

    EGLDisplay m_display;
    EGLContext m_context = EGL_NO_CONTEXT;
    EGLSurface m_pbuffer = EGL_NO_SURFACE;
};

Result<void> EglSurface::open(const SurfaceOptions& options) {
    std::optional<EGLConfig> config = chooseConfig(m_display, options.depthBits, options.samples);
    if (!config)
        config = chooseConfig(m_display, options.depthBits, 0);
    if (!config)
        return Error{"surface.driver", "eglChooseConfig",
                     "the driver has no RGBA8 pbuffer for OpenGL ES 2.0 with " +
                         std::to_string(options.depthBits) + " bits of depth",
                     "ask for 24 bits or fewer"};
    const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 2, EGL_NONE};
    eglBindAPI(EGL_OPENGL_ES_API);
    m_context = eglCreateContext(m_display, *config, EGL_NO_CONTEXT, version);
    if (m_context == EGL_NO_CONTEXT)
        return lastError("eglCreateContext", kInstall);
    m_pbuffer = createPbuffer(*config, options.srgb);
    m_srgbTarget = options.srgb && m_pbuffer != EGL_NO_SURFACE;
    if (m_pbuffer == EGL_NO_SURFACE)
        m_pbuffer = createPbuffer(*config, false);
    if (m_pbuffer == EGL_NO_SURFACE)
        return lastError("eglCreatePbufferSurface", "choose a smaller size");
    eglGetConfigAttrib(m_display, *config, EGL_SAMPLES, &m_samples);
    return makeReady();
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
        return lastError("eglMakeCurrent", "destroy or release the surface in the thread that uses it");
    return {};
}

Result<void> EglSurface::present() {
    if (eglSwapBuffers(m_display, m_pbuffer))
        return {};
    const EGLint error = eglGetError();
    return Error{error == EGL_CONTEXT_LOST ? "surface.lost" : "surface.driver", "eglSwapBuffers",
                 "the driver reports " + nameOf(error), "make a new surface"};
}

} // namespace

Result<std::unique_ptr<Surface>> createEglSurfaceless(const SurfaceOptions& options) {
    static const Result<EGLDisplay> display = openDisplay();
    if (!display)
        return display.error();
    auto surface = std::make_unique<EglSurface>(*display, options.size);
    if (Result<void> opened = surface->open(options); !opened)
        return opened.error();
    return std::unique_ptr<Surface>(std::move(surface));
}

} // namespace franken::platform
