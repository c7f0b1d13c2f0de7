// SPDX-License-Identifier: MIT
//
// The program's own definitions of these functions come before those of the libraries.
#include "support/faults.h"

#include <EGL/egl.h>
#include <dlfcn.h>
#include <gbm.h>
#include <xf86drm.h>
#include <xf86drmMode.h>

#include <cerrno>

namespace franken::test {

std::function<int(Call)> onCall;

const char* toString(Call call) {
    constexpr const char* kNames[] = {"SetClientCap", "GetResources",  "CreateGbmDevice", "GetDisplay",
                                      "Initialize",   "CreateContext", "CreateBuffer",    "AddFramebuffer",
                                      "CreateBlob",   "TestCommit",    "CreateSurface",   "CreateWindow",
                                      "MakeCurrent",  "SwapBuffers",   "LockBuffer",      "Commit"};
    return kNames[static_cast<int>(call)];
}

namespace {

int ask(Call call) { return onCall ? onCall(call) : kPass; }

/// The library's function.
template<typename Function>
Function* next(Function*, const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

/// Fails as libdrm does: -1 and errno, or a negative errno.
int asLibdrm(int answer) {
    errno = -answer;
    return answer == kLose ? 0 : answer;
}

template<typename Pointer>
Pointer asNull(int answer) {
    errno = -answer;
    return nullptr;
}

} // namespace

} // namespace franken::test

using namespace franken::test;

// NOLINTBEGIN(readability-identifier-naming)
extern "C" {

int drmSetClientCap(int device, uint64_t capability, uint64_t value) {
    const int answer = ask(Call::SetClientCap);
    return answer != kPass ? asLibdrm(answer)
                           : next(&drmSetClientCap, "drmSetClientCap")(device, capability, value);
}

drmModeResPtr drmModeGetResources(int device) {
    const int answer = ask(Call::GetResources);
    return answer != kPass ? asNull<drmModeResPtr>(answer)
                           : next(&drmModeGetResources, "drmModeGetResources")(device);
}

gbm_device* gbm_create_device(int device) {
    const int answer = ask(Call::CreateGbmDevice);
    return answer != kPass ? asNull<gbm_device*>(answer)
                           : next(&gbm_create_device, "gbm_create_device")(device);
}

EGLDisplay eglGetPlatformDisplay(EGLenum platform, void* native, const EGLAttrib* attributes) {
    return ask(Call::GetDisplay) != kPass
               ? EGL_NO_DISPLAY
               : next(&eglGetPlatformDisplay, "eglGetPlatformDisplay")(platform, native, attributes);
}

EGLBoolean eglInitialize(EGLDisplay display, EGLint* major, EGLint* minor) {
    return ask(Call::Initialize) != kPass ? EGL_FALSE
                                          : next(&eglInitialize, "eglInitialize")(display, major, minor);
}

EGLContext eglCreateContext(EGLDisplay display, EGLConfig config, EGLContext share,
                            const EGLint* attributes) {
    return ask(Call::CreateContext) != kPass
               ? EGL_NO_CONTEXT
               : next(&eglCreateContext, "eglCreateContext")(display, config, share, attributes);
}

gbm_bo* gbm_bo_create_with_modifiers2(gbm_device* gbm, uint32_t width, uint32_t height, uint32_t format,
                                      const uint64_t* modifiers, unsigned count, uint32_t flags) {
    const int answer = ask(Call::CreateBuffer);
    return answer != kPass ? asNull<gbm_bo*>(answer)
                           : next(&gbm_bo_create_with_modifiers2, "gbm_bo_create_with_modifiers2")(
                                 gbm, width, height, format, modifiers, count, flags);
}

gbm_bo* gbm_bo_create(gbm_device* gbm, uint32_t width, uint32_t height, uint32_t format, uint32_t flags) {
    const int answer = ask(Call::CreateBuffer);
    return answer != kPass ? asNull<gbm_bo*>(answer)
                           : next(&gbm_bo_create, "gbm_bo_create")(gbm, width, height, format, flags);
}

int drmModeAddFB2(int device, uint32_t width, uint32_t height, uint32_t format, const uint32_t handles[4],
                  const uint32_t strides[4], const uint32_t offsets[4], uint32_t* framebuffer,
                  uint32_t flags) {
    const int answer = ask(Call::AddFramebuffer);
    return answer != kPass ? asLibdrm(answer)
                           : next(&drmModeAddFB2, "drmModeAddFB2")(device, width, height, format, handles,
                                                                   strides, offsets, framebuffer, flags);
}

int drmModeAddFB2WithModifiers(int device, uint32_t width, uint32_t height, uint32_t format,
                               const uint32_t handles[4], const uint32_t strides[4],
                               const uint32_t offsets[4], const uint64_t modifiers[4], uint32_t* framebuffer,
                               uint32_t flags) {
    const int answer = ask(Call::AddFramebuffer);
    return answer != kPass
               ? asLibdrm(answer)
               : next(&drmModeAddFB2WithModifiers, "drmModeAddFB2WithModifiers")(
                     device, width, height, format, handles, strides, offsets, modifiers, framebuffer, flags);
}

int drmModeCreatePropertyBlob(int device, const void* data, size_t bytes, uint32_t* blob) {
    const int answer = ask(Call::CreateBlob);
    return answer != kPass
               ? asLibdrm(answer)
               : next(&drmModeCreatePropertyBlob, "drmModeCreatePropertyBlob")(device, data, bytes, blob);
}

gbm_surface* gbm_surface_create(gbm_device* gbm, uint32_t width, uint32_t height, uint32_t format,
                                uint32_t flags) {
    const int answer = ask(Call::CreateSurface);
    return answer != kPass
               ? asNull<gbm_surface*>(answer)
               : next(&gbm_surface_create, "gbm_surface_create")(gbm, width, height, format, flags);
}

gbm_surface* gbm_surface_create_with_modifiers2(gbm_device* gbm, uint32_t width, uint32_t height,
                                                uint32_t format, const uint64_t* modifiers, unsigned count,
                                                uint32_t flags) {
    const int answer = ask(Call::CreateSurface);
    return answer != kPass ? asNull<gbm_surface*>(answer)
                           : next(&gbm_surface_create_with_modifiers2, "gbm_surface_create_with_modifiers2")(
                                 gbm, width, height, format, modifiers, count, flags);
}

EGLSurface eglCreatePlatformWindowSurface(EGLDisplay display, EGLConfig config, void* window,
                                          const EGLAttrib* attributes) {
    return ask(Call::CreateWindow) != kPass
               ? EGL_NO_SURFACE
               : next(&eglCreatePlatformWindowSurface, "eglCreatePlatformWindowSurface")(display, config,
                                                                                         window, attributes);
}

EGLBoolean eglMakeCurrent(EGLDisplay display, EGLSurface draw, EGLSurface read, EGLContext context) {
    if (context != EGL_NO_CONTEXT && ask(Call::MakeCurrent) != kPass)
        return EGL_FALSE;
    return next(&eglMakeCurrent, "eglMakeCurrent")(display, draw, read, context);
}

EGLBoolean eglSwapBuffers(EGLDisplay display, EGLSurface surface) {
    return ask(Call::SwapBuffers) != kPass ? EGL_FALSE
                                           : next(&eglSwapBuffers, "eglSwapBuffers")(display, surface);
}

gbm_bo* gbm_surface_lock_front_buffer(gbm_surface* surface) {
    const int answer = ask(Call::LockBuffer);
    return answer != kPass ? asNull<gbm_bo*>(answer)
                           : next(&gbm_surface_lock_front_buffer, "gbm_surface_lock_front_buffer")(surface);
}

int drmModeAtomicCommit(int device, drmModeAtomicReqPtr request, uint32_t flags, void* user) {
    const int answer = ask((flags & DRM_MODE_ATOMIC_TEST_ONLY) != 0 ? Call::TestCommit : Call::Commit);
    return answer != kPass ? asLibdrm(answer)
                           : next(&drmModeAtomicCommit, "drmModeAtomicCommit")(device, request, flags, user);
}

} // extern "C"
// NOLINTEND(readability-identifier-naming)
