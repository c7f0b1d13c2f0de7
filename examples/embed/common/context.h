// SPDX-License-Identifier: MIT
#pragma once

#include <EGL/egl.h>

#include <cstdint>
#include <vector>

/// The application's own way to GLES2: EGL without a window system, and a pbuffer with a depth buffer.
/// FrankenShader has no part in it.
class Context {
public:
    Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    ~Context();

    /// Makes the context, current in this thread. Returns the name of the EGL call that failed, or null.
    const char* open(int width, int height);

    /// From "glClear" to its address.
    static void* getProcAddress(const char* name);

private:
    EGLDisplay m_display = EGL_NO_DISPLAY;
    EGLContext m_context = EGL_NO_CONTEXT;
    EGLSurface m_pbuffer = EGL_NO_SURFACE;
};
