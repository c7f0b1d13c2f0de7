// SPDX-License-Identifier: MIT
#include "gbm_target.h"

#include <EGL/eglext.h>
#include <gbm.h>

#include <cerrno>

namespace franken::platform {

namespace {

constexpr std::uint32_t kUse = GBM_BO_USE_SCANOUT | GBM_BO_USE_RENDERING;

/// What a buffer of GBM carries with it.
struct Attached {
    KmsDevice& device;
    std::uint32_t framebuffer;
    ~Attached() { device.removeFramebuffer(framebuffer); }
};

KmsBuffer describe(gbm_bo* buffer, bool withModifier) {
    return {{static_cast<int>(gbm_bo_get_width(buffer)), static_cast<int>(gbm_bo_get_height(buffer))},
            gbm_bo_get_format(buffer),
            withModifier ? gbm_bo_get_modifier(buffer) : DRM_FORMAT_MOD_INVALID,
            gbm_bo_get_handle(buffer).u32,
            gbm_bo_get_stride(buffer),
            gbm_bo_get_offset(buffer, 0)};
}

} // namespace

Result<std::unique_ptr<GbmTarget>> GbmTarget::open(KmsDevice& device, int depthBits, int samples) {
    std::unique_ptr<GbmTarget> target(new GbmTarget(device, depthBits, samples));
    if (Result<void> opened = target->openContext(); !opened)
        return opened.error();
    return target;
}

GbmTarget::~GbmTarget() {
    dropTarget();
    if (m_tried != nullptr)
        gbm_bo_destroy(m_tried);
    if (m_context != EGL_NO_CONTEXT)
        eglDestroyContext(m_display, m_context);
    if (m_display != EGL_NO_DISPLAY)
        eglTerminate(m_display);
    if (m_gbm != nullptr)
        gbm_device_destroy(m_gbm);
}

Result<void> GbmTarget::openContext() {
    m_gbm = gbm_create_device(m_device.descriptor());
    if (m_gbm == nullptr)
        return Error{"surface.driver", "gbm_create_device", "Mesa has no driver for " + m_device.node(),
                     kInstallEgl};
    m_display = eglGetPlatformDisplay(EGL_PLATFORM_GBM_KHR, m_gbm, nullptr);
    if (m_display == EGL_NO_DISPLAY)
        return lastEglError("eglGetPlatformDisplay", kInstallEgl);
    if (!eglInitialize(m_display, nullptr, nullptr))
        return lastEglError("eglInitialize", kInstallEgl);
    eglBindAPI(EGL_OPENGL_ES_API);
    // Without a config (EGL_KHR_no_config_context) it goes with targets of any format.
    const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 2, EGL_NONE};
    m_context = eglCreateContext(m_display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
    if (m_context == EGL_NO_CONTEXT)
        return lastEglError("eglCreateContext", kInstallEgl);
    return {};
}

Result<EGLConfig> GbmTarget::chooseConfig(std::uint32_t fourcc, int samples) const {
    for (EGLConfig config : configsFor(m_display, EGL_WINDOW_BIT, m_depthBits, samples)) {
        EGLint visual = 0;
        if (eglGetConfigAttrib(m_display, config, EGL_NATIVE_VISUAL_ID, &visual) &&
            static_cast<std::uint32_t>(visual) == fourcc)
            return config;
    }
    return Error{"surface.driver", "eglChooseConfig",
                 "the driver cannot draw to buffers of the screen's format", "choose another format"};
}

int GbmTarget::tryBuffer(Size size, const FormatChoice& format, KmsBuffer& buffer) {
    if (m_tried != nullptr)
        gbm_bo_destroy(std::exchange(m_tried, nullptr));
    if (!chooseConfig(format.fourcc, 0))
        return -EINVAL;
    const auto width = static_cast<std::uint32_t>(size.width),
               height = static_cast<std::uint32_t>(size.height);
    const bool withModifier = !format.modifiers.empty();
    m_tried =
        withModifier
            ? gbm_bo_create_with_modifiers2(m_gbm, width, height, format.fourcc, format.modifiers.data(),
                                            static_cast<unsigned>(format.modifiers.size()), kUse)
            : gbm_bo_create(m_gbm, width, height, format.fourcc, kUse);
    // Whatever the reason (GBM leaves different ones in errno), it is this way of making it that failed.
    if (m_tried == nullptr || (withModifier && gbm_bo_get_modifier(m_tried) == DRM_FORMAT_MOD_INVALID))
        return -EINVAL;
    buffer = describe(m_tried, withModifier);
    return 0;
}

Result<void> GbmTarget::makeTarget(const KmsBuffer& like, PixelFormat) {
    dropTarget();
    m_like = like;
    Result<EGLConfig> config = chooseConfig(like.format, m_wantedSamples);
    if (!config)
        config = chooseConfig(like.format, 0);
    if (!config)
        return config.error();
    const auto width = static_cast<std::uint32_t>(like.size.width),
               height = static_cast<std::uint32_t>(like.size.height);
    m_surface =
        like.modifier == DRM_FORMAT_MOD_INVALID
            ? gbm_surface_create(m_gbm, width, height, like.format, kUse)
            : gbm_surface_create_with_modifiers2(m_gbm, width, height, like.format, &like.modifier, 1, kUse);
    if (m_surface == nullptr)
        return Error{"surface.driver", "gbm_surface_create", "the driver cannot create the screen's buffers",
                     "choose a smaller mode"};
    m_window = eglCreatePlatformWindowSurface(m_display, *config, m_surface, nullptr);
    if (m_window == EGL_NO_SURFACE)
        return lastEglError("eglCreatePlatformWindowSurface", "choose a smaller mode");
    eglGetConfigAttrib(m_display, *config, EGL_SAMPLES, &m_samples);
    ++m_generation;
    return bind();
}

void GbmTarget::dropTarget() {
    for (const auto& [framebuffer, held] : m_held)
        if (const std::shared_ptr<HeldBuffer> reader = held.lock())
            reader->revoke();
    if (m_display != EGL_NO_DISPLAY)
        unbind();
    if (m_window != EGL_NO_SURFACE)
        eglDestroySurface(m_display, std::exchange(m_window, EGL_NO_SURFACE));
    if (m_surface != nullptr)
        gbm_surface_destroy(std::exchange(m_surface, nullptr));
    m_locked.clear();
    m_held.clear();
    m_toRelease.clear();
}

Result<void> GbmTarget::bind() {
    releaseUnheld(); // Before the driver chooses the buffer that is drawn to.
    if (!eglMakeCurrent(m_display, m_window, m_window, m_context))
        return lastEglError("eglMakeCurrent", "destroy or release the surface in the thread that uses it");
    return {};
}

void GbmTarget::unbind() { eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }

Result<std::uint32_t> GbmTarget::swap() {
    Result<void> swapped = swapEglBuffers(m_display, m_window);
    // EGL_BAD_ALLOC: there was no memory for the buffer that a held picture takes.
    m_wantsFrame = !swapped && takeBack();
    if (m_wantsFrame)
        swapped = swapEglBuffers(m_display, m_window);
    if (!swapped)
        return swapped.error();
    gbm_bo* buffer = gbm_surface_lock_front_buffer(m_surface);
    if (buffer == nullptr)
        return Error{"surface.driver", "gbm_surface_lock_front_buffer", "the driver returned no buffer",
                     "make a new surface"};
    Result<std::uint32_t> framebuffer = framebufferOf(buffer);
    if (framebuffer)
        m_locked[*framebuffer] = buffer;
    else
        gbm_surface_release_buffer(m_surface, buffer);
    return framebuffer;
}

Result<std::uint32_t> GbmTarget::framebufferOf(gbm_bo* buffer) {
    if (const auto* attached = static_cast<const Attached*>(gbm_bo_get_user_data(buffer)))
        return attached->framebuffer;
    std::uint32_t framebuffer = 0;
    const bool withModifier = m_like.modifier != DRM_FORMAT_MOD_INVALID;
    if (const int error = m_device.addFramebuffer(describe(buffer, withModifier), framebuffer); error != 0)
        return Error{"surface.driver", m_device.node(), "the kernel cannot create another framebuffer",
                     "choose a smaller mode, or give the kernel more memory (cma=)"};
    gbm_bo_set_user_data(buffer, new Attached{m_device, framebuffer},
                         [](gbm_bo*, void* attached) { delete static_cast<Attached*>(attached); });
    return framebuffer;
}

void GbmTarget::release(std::uint32_t framebuffer) {
    if (const auto held = m_held.find(framebuffer); held != m_held.end() && !held->second.expired()) {
        m_toRelease.insert(framebuffer);
        return;
    }
    if (const auto locked = m_locked.find(framebuffer); locked != m_locked.end()) {
        gbm_surface_release_buffer(m_surface, locked->second);
        m_locked.erase(locked);
    }
}

std::shared_ptr<HeldPicture> GbmTarget::hold(std::uint32_t framebuffer) {
    const auto locked = m_locked.find(framebuffer);
    if (locked == m_locked.end())
        return nullptr;
    if (std::shared_ptr<HeldBuffer> held = m_held[framebuffer].lock())
        return held;
    const auto held = std::make_shared<HeldBuffer>(locked->second, m_mapping);
    m_held[framebuffer] = held;
    return held;
}

void GbmTarget::releaseUnheld() {
    std::erase_if(m_held, [](const auto& entry) { return entry.second.expired(); });
    for (const std::uint32_t framebuffer : std::exchange(m_toRelease, {}))
        release(framebuffer);
}

bool GbmTarget::takeBack() {
    const std::set<std::uint32_t> taken = std::exchange(m_toRelease, {});
    for (const std::uint32_t framebuffer : taken) {
        if (const std::shared_ptr<HeldBuffer> held = m_held[framebuffer].lock())
            held->revoke();
        m_held.erase(framebuffer);
        release(framebuffer);
    }
    return !taken.empty();
}

} // namespace franken::platform
