// SPDX-License-Identifier: MIT
#include "egl.h"

#include <string>

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

} // namespace

Error lastEglError(const char* call, const char* remedy) {
    return Error{"surface.driver", call, "the driver reports " + nameOf(eglGetError()), remedy};
}

std::vector<EGLConfig> configsFor(EGLDisplay display, EGLint surfaceType, int depthBits, int samples) {
    const EGLint attributes[] = {
        EGL_DEPTH_SIZE,     depthBits,   EGL_SURFACE_TYPE, surfaceType, EGL_RENDERABLE_TYPE,
        EGL_OPENGL_ES2_BIT, EGL_SAMPLES, samples,          EGL_NONE};
    EGLint count = 0;
    eglChooseConfig(display, attributes, nullptr, 0, &count);
    std::vector<EGLConfig> configs(static_cast<std::size_t>(count));
    eglChooseConfig(display, attributes, configs.data(), count, &count);
    return configs;
}

Result<void> swapEglBuffers(EGLDisplay display, EGLSurface surface) {
    if (eglSwapBuffers(display, surface))
        return {};
    const EGLint error = eglGetError();
    return Error{error == EGL_CONTEXT_LOST ? "surface.lost" : "surface.driver", "eglSwapBuffers",
                 "the driver reports " + nameOf(error), "make a new surface"};
}

void* eglFunction(const char* name) { return reinterpret_cast<void*>(eglGetProcAddress(name)); }

} // namespace franken::platform
