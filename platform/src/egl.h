// SPDX-License-Identifier: MIT
#pragma once

#include "franken/result.h"

#include <EGL/egl.h>

namespace franken::platform {

inline constexpr const char* kInstallEgl =
    "install the Debian packages libegl1, libegl-mesa0 and libgl1-mesa-dri, or choose another backend";

/// Of the EGL call that failed just now.
Error lastEglError(const char* call, const char* remedy);

/// eglSwapBuffers() with its errors: `surface.lost` when the context is gone, else `surface.driver`.
Result<void> swapEglBuffers(EGLDisplay display, EGLSurface surface);

/// What Surface::getProcAddress() hands out for EGL.
void* eglFunction(const char* name);

} // namespace franken::platform
