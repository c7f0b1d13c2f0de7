// SPDX-License-Identifier: MIT
#include "kiosk/show/canvas.h"

#include <algorithm>
#include <cmath>

namespace kiosk {

using franken::Result;

franken::OverlayRect viewerArea(const franken::DrawTarget& target) {
    const auto width = static_cast<float>(target.width), height = static_cast<float>(target.height);
    return franken::swapsAxes(target.rotation) ? franken::OverlayRect{0, 0, height, width}
                                               : franken::OverlayRect{0, 0, width, height};
}

franken::Result<franken::PictureId> addWhite(franken::Renderer& renderer) {
    static const franken::Image white{.name = "white", .width = 1, .height = 1, .rgba = {255, 255, 255, 255}};
    return renderer.addPicture(white, [] { return white; });
}

Canvas::~Canvas() { release(); }

void Canvas::release() {
    if (m_picture)
        m_renderer.removePicture(*m_picture);
    m_picture.reset();
    if (m_framebuffer != 0) {
        m_gl.DeleteFramebuffers(1, &m_framebuffer);
        m_gl.DeleteTextures(1, &m_texture);
        m_gl.DeleteRenderbuffers(1, &m_depth);
        m_renderer.invalidateState();
    }
    m_framebuffer = 0;
    m_width = m_height = 0;
    m_lease = {};
}

Result<void> Canvas::make(int width, int height) {
    release();
    constexpr std::size_t kBytesPerPixel = 6; // RGBA8, and 16 bits of depth.
    Result<franken::MemoryLease> lease = m_renderer.memory().reserve(
        franken::MemoryUse::Targets,
        static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * kBytesPerPixel);
    if (!lease)
        return lease.error();
    m_lease = *std::move(lease);
    m_gl.GenFramebuffers(1, &m_framebuffer);
    m_gl.GenTextures(1, &m_texture);
    m_gl.GenRenderbuffers(1, &m_depth);
    m_gl.BindTexture(GL_TEXTURE_2D, m_texture);
    m_gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    for (const auto& [name, value] : {std::pair{GL_TEXTURE_MIN_FILTER, GL_LINEAR},
                                      {GL_TEXTURE_MAG_FILTER, GL_LINEAR},
                                      {GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE},
                                      {GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE}})
        m_gl.TexParameteri(GL_TEXTURE_2D, static_cast<GLenum>(name), value);
    m_gl.BindRenderbuffer(GL_RENDERBUFFER, m_depth);
    m_gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT16, width, height);
    m_gl.BindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    m_gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_texture, 0);
    m_gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, m_depth);
    const bool isComplete = m_gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    m_renderer.invalidateState();
    if (!isComplete)
        return franken::Error{"kiosk.canvas", {}, "the driver refuses a target of its own", {}};
    const Result<franken::PictureId> picture = m_renderer.addApplicationTexture(m_texture);
    if (!picture)
        return picture.error();
    m_picture = *picture;
    m_width = width;
    m_height = height;
    return {};
}

Result<franken::DrawTarget> Canvas::targetFor(const franken::DrawTarget& target, double share) {
    const franken::OverlayRect area = viewerArea(target);
    const int width = std::max(1, static_cast<int>(std::lround(static_cast<double>(area.width) * share)));
    const int height = std::max(1, static_cast<int>(std::lround(static_cast<double>(area.height) * share)));
    if (width != m_width || height != m_height)
        if (const Result<void> made = make(width, height); !made) {
            release();
            return made.error();
        }
    return franken::DrawTarget{
        .framebuffer = m_framebuffer, .width = width, .height = height, .background = target.background};
}

franken::OverlayQuad Canvas::quad(const franken::DrawTarget& target) const {
    // Row 0 of what was drawn is at the bottom, of a picture at the top.
    return {.picture = *m_picture, .place = viewerArea(target), .part = {0, 1, 1, -1}};
}

} // namespace kiosk
