// SPDX-License-Identifier: MIT
#pragma once

#include "franken/result.h"

#include <EGL/egl.h>

#include <vector>

namespace franken::platform {

inline constexpr const char* kInstallEgl =
    "install the Debian packages libegl1, libegl-mesa0 and libgl1-mesa-dri, or choose another backend";

/// Of the EGL call that failed just now.
Error lastEglError(const char* call, const char* remedy);

/// All configs of OpenGL ES 2 that draw to surfaces of that type (EGL_PBUFFER_BIT or EGL_WINDOW_BIT), the
/// deepest colours first.
std::vector<EGLConfig> configsFor(EGLDisplay display, EGLint surfaceType, int depthBits, int samples);

/// eglSwapBuffers() with its errors: `surface.lost` when the context is gone, else `surface.driver`.
Result<void> swapEglBuffers(EGLDisplay display, EGLSurface surface);

/// What Surface::getProcAddress() hands out for EGL.
void* eglFunction(const char* name);

} // namespace franken::platform
