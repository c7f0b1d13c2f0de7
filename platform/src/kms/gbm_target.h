// SPDX-License-Identifier: MIT
#pragma once

#include "../egl.h"
#include "held_buffer.h"
#include "screen.h"

#include <map>
#include <mutex>
#include <set>

struct gbm_device;
struct gbm_surface;

namespace franken::platform {

/// A GLES2 context on a KMS device, and the buffers that it draws to, by GBM and EGL. The context stays when
/// the target is replaced.
class GbmTarget final : public KmsBuffers {
public:
    /// Fails with `surface.driver` and `surface.not-installed`.
    static Result<std::unique_ptr<GbmTarget>> open(KmsDevice& device, int depthBits, int samples);
    ~GbmTarget() override;

    int tryBuffer(Size size, const FormatChoice& format, KmsBuffer& buffer) override;
    Result<void> makeTarget(const KmsBuffer& like, PixelFormat format) override;
    void release(std::uint32_t framebuffer) override;

    /// Current without a target as well.
    Result<void> bind();
    void unbind();
    /// Ends the frame; the framebuffer that holds it.
    Result<std::uint32_t> swap();
    /// Keeps that framebuffer from being drawn to, if it is the target's, until the last owner lets it go.
    std::shared_ptr<HeldPicture> hold(std::uint32_t framebuffer);
    /// The last frame was lost for want of a buffer, and an older picture is shown in its place.
    bool wantsFrame() const { return m_wantsFrame; }
    int samples() const { return m_samples; }
    /// Counts the targets, so that a frame can be told from one for an older target.
    int generation() const { return m_generation; }

private:
    explicit GbmTarget(KmsDevice& device, int depthBits, int samples)
        : m_device(device), m_depthBits(depthBits), m_wantedSamples(samples) {}
    Result<void> openContext();
    Result<EGLConfig> chooseConfig(std::uint32_t fourcc, int samples) const;
    void dropTarget();
    void releaseUnheld();
    /// Takes from their holders what is not shown any more; false where they have nothing.
    bool takeBack();
    Result<std::uint32_t> framebufferOf(gbm_bo* buffer);

    KmsDevice& m_device;
    int m_depthBits, m_wantedSamples, m_samples = 0, m_generation = 0;
    gbm_device* m_gbm = nullptr;
    EGLDisplay m_display = EGL_NO_DISPLAY;
    EGLContext m_context = EGL_NO_CONTEXT;
    gbm_surface* m_surface = nullptr;
    EGLSurface m_window = EGL_NO_SURFACE;
    gbm_bo* m_tried = nullptr;
    KmsBuffer m_like;
    std::map<std::uint32_t, gbm_bo*> m_locked; ///< By framebuffer.
    std::map<std::uint32_t, std::weak_ptr<HeldBuffer>> m_held;
    std::set<std::uint32_t> m_toRelease; ///< Once nobody holds them.
    bool m_wantsFrame = false;
    std::shared_ptr<std::mutex> m_mapping = std::make_shared<std::mutex>();
};

} // namespace franken::platform
