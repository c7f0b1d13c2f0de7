// SPDX-License-Identifier: MIT
#include "backends.h"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <mutex>
#include <optional>
#include <vector>

namespace franken::platform {

namespace {

const char* errorName(EGLint error) {
    switch (error) {
    case EGL_SUCCESS:
        return "no error";
    case EGL_NOT_INITIALIZED:
        return "EGL_NOT_INITIALIZED";
    case EGL_BAD_ACCESS:
        return "EGL_BAD_ACCESS";
    case EGL_BAD_ALLOC:
        return "EGL_BAD_ALLOC";
    case EGL_BAD_ATTRIBUTE:
        return "EGL_BAD_ATTRIBUTE";
    case EGL_BAD_CONFIG:
        return "EGL_BAD_CONFIG";
    case EGL_BAD_CONTEXT:
        return "EGL_BAD_CONTEXT";
    case EGL_BAD_CURRENT_SURFACE:
        return "EGL_BAD_CURRENT_SURFACE";
    case EGL_BAD_DISPLAY:
        return "EGL_BAD_DISPLAY";
    case EGL_BAD_MATCH:
        return "EGL_BAD_MATCH";
    case EGL_BAD_NATIVE_PIXMAP:
        return "EGL_BAD_NATIVE_PIXMAP";
    case EGL_BAD_NATIVE_WINDOW:
        return "EGL_BAD_NATIVE_WINDOW";
    case EGL_BAD_PARAMETER:
        return "EGL_BAD_PARAMETER";
    case EGL_BAD_SURFACE:
        return "EGL_BAD_SURFACE";
    case EGL_CONTEXT_LOST:
        return "EGL_CONTEXT_LOST";
    default:
        return "an unknown EGL error";
    }
}

Error driverError(const char* call, std::string what) {
    return Error{
        "surface.driver", call, std::move(what),
        "install the Debian packages libegl1, libegl-mesa0 and libgl1-mesa-dri, or choose another backend"};
}

/// Of the call that failed just now.
Error lastError(const char* call) {
    const EGLint error = eglGetError();
    return driverError(call, std::string("the driver reports ") + errorName(error));
}

/// EGL keeps one display for the process, whose eglTerminate() takes all contexts with it: the surfaces share
/// it.
class Display {
public:
    static Result<std::shared_ptr<Display>> acquire();
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;
    ~Display() { eglTerminate(m_display); }
    EGLDisplay get() const { return m_display; }

private:
    explicit Display(EGLDisplay display) : m_display(display) {}
    EGLDisplay m_display;
};

Result<std::shared_ptr<Display>> Display::acquire() {
    static std::mutex mutex;
    static std::weak_ptr<Display> shared;
    const std::lock_guard lock(mutex);
    if (std::shared_ptr<Display> display = shared.lock())
        return display;
    const EGLDisplay handle =
        eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (handle == EGL_NO_DISPLAY)
        return lastError("eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA)");
    if (!eglInitialize(handle, nullptr, nullptr))
        return lastError("eglInitialize");
    std::shared_ptr<Display> display(new Display(handle));
    shared = display;
    return display;
}

/// eglChooseConfig() puts the deepest colours first; the target has to be RGBA8 everywhere, to compare
/// pictures.
std::optional<EGLConfig> chooseConfig(EGLDisplay display, int depthBits) {
    const EGLint attributes[] = {EGL_SURFACE_TYPE,
                                 EGL_PBUFFER_BIT,
                                 EGL_RENDERABLE_TYPE,
                                 EGL_OPENGL_ES2_BIT,
                                 EGL_RED_SIZE,
                                 8,
                                 EGL_GREEN_SIZE,
                                 8,
                                 EGL_BLUE_SIZE,
                                 8,
                                 EGL_ALPHA_SIZE,
                                 8,
                                 EGL_DEPTH_SIZE,
                                 depthBits,
                                 EGL_NONE};
    EGLint count = 0;
    eglChooseConfig(display, attributes, nullptr, 0, &count);
    std::vector<EGLConfig> configs(static_cast<std::size_t>(count));
    eglChooseConfig(display, attributes, configs.data(), count, &count);
    const auto is = [&](EGLConfig config, EGLint attribute, EGLint wanted) {
        EGLint value = 0;
        return eglGetConfigAttrib(display, config, attribute, &value) && value == wanted;
    };
    for (EGLConfig config : configs)
        if (is(config, EGL_BUFFER_SIZE, 32) && is(config, EGL_ALPHA_SIZE, 8) && is(config, EGL_RED_SIZE, 8))
            return config;
    return std::nullopt;
}

class EglSurface final : public Surface {
public:
    EglSurface(std::shared_ptr<Display> display, Size size) : Surface(size), m_display(std::move(display)) {}

    ~EglSurface() override {
        const Detached detached(*this);
        if (m_pbuffer != EGL_NO_SURFACE)
            eglDestroySurface(m_display->get(), m_pbuffer);
        if (m_context != EGL_NO_CONTEXT)
            eglDestroyContext(m_display->get(), m_context);
    }

    Result<void> open(int depthBits);

    std::string_view backend() const override { return "egl"; }

    GetProcAddress getProcAddress() const override {
        return [](const char* name) { return reinterpret_cast<void*>(eglGetProcAddress(name)); };
    }

    Result<void> present() override;

protected:
    Result<void> bind() override;
    void unbind() override {
        eglMakeCurrent(m_display->get(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }

private:
    std::shared_ptr<Display> m_display;
    EGLContext m_context = EGL_NO_CONTEXT;
    EGLSurface m_pbuffer = EGL_NO_SURFACE;
};

Result<void> EglSurface::open(int depthBits) {
    const std::optional<EGLConfig> config = chooseConfig(m_display->get(), depthBits);
    if (!config)
        return driverError("eglChooseConfig", "the driver has no RGBA8 pbuffer for OpenGL ES 2.0 with " +
                                                  std::to_string(depthBits) + " bits of depth");
    const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 2, EGL_NONE};
    eglBindAPI(EGL_OPENGL_ES_API);
    m_context = eglCreateContext(m_display->get(), *config, EGL_NO_CONTEXT, version);
    if (m_context == EGL_NO_CONTEXT)
        return lastError("eglCreateContext");
    const EGLint extent[] = {EGL_WIDTH, m_size.width, EGL_HEIGHT, m_size.height, EGL_NONE};
    m_pbuffer = eglCreatePbufferSurface(m_display->get(), *config, extent);
    if (m_pbuffer == EGL_NO_SURFACE)
        return lastError("eglCreatePbufferSurface");
    return makeReady();
}

Result<void> EglSurface::bind() {
    if (!eglMakeCurrent(m_display->get(), m_pbuffer, m_pbuffer, m_context))
        return lastError("eglMakeCurrent");
    return {};
}

Result<void> EglSurface::present() {
    if (eglSwapBuffers(m_display->get(), m_pbuffer))
        return {};
    const EGLint error = eglGetError();
    return Error{error == EGL_CONTEXT_LOST ? "surface.lost" : "surface.driver", "eglSwapBuffers",
                 std::string("the driver reports ") + errorName(error), "make a new surface"};
}

} // namespace

Result<std::unique_ptr<Surface>> createEglSurfaceless(const SurfaceOptions& options) {
    Result<std::shared_ptr<Display>> display = Display::acquire();
    if (!display)
        return display.error();
    auto surface = std::make_unique<EglSurface>(*std::move(display), options.size);
    if (Result<void> opened = surface->open(options.depthBits); !opened)
        return opened.error();
    return std::unique_ptr<Surface>(std::move(surface));
}

} // namespace franken::platform
