// SPDX-License-Identifier: MIT
#include "context.h"

#include <EGL/eglext.h>

const char* Context::open(int width, int height) {
    m_display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (!eglInitialize(m_display, nullptr, nullptr))
        return "eglInitialize";
    // The deepest colours come first: alpha of 8 bits leaves those of 10 bits out.
    const EGLint wanted[] = {EGL_RED_SIZE,   8, EGL_GREEN_SIZE, 8,  EGL_BLUE_SIZE,    8,
                             EGL_ALPHA_SIZE, 8, EGL_DEPTH_SIZE, 24, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT,
                             EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(m_display, wanted, &config, 1, &count) || count == 0)
        return "eglChooseConfig";
    eglBindAPI(EGL_OPENGL_ES_API);
    const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 2, EGL_NONE};
    m_context = eglCreateContext(m_display, config, EGL_NO_CONTEXT, version);
    const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
    m_pbuffer = eglCreatePbufferSurface(m_display, config, size);
    return eglMakeCurrent(m_display, m_pbuffer, m_pbuffer, m_context) ? nullptr : "eglMakeCurrent";
}

Context::~Context() {
    if (m_display != EGL_NO_DISPLAY)
        eglTerminate(m_display);
}

void* Context::getProcAddress(const char* name) { return reinterpret_cast<void*>(eglGetProcAddress(name)); }
