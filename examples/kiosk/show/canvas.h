// SPDX-License-Identifier: MIT
#pragma once

#include "franken/draw_target.h"
#include "franken/renderer.h"

#include <optional>

namespace kiosk {

/// A smaller picture that is drawn in place of the target's, and stretched over it: for a machine that is too
/// hot for all pixels.
class Canvas {
public:
    Canvas(const franken::Gl& gl, franken::Renderer& renderer) : m_gl(gl), m_renderer(renderer) {}
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    /// The target to draw to: `share` of the width and height, upright. Makes it anew where the size changes.
    /// Fails as an upload does, and with "kiosk.canvas" where the driver refuses it.
    franken::Result<franken::DrawTarget> targetFor(const franken::DrawTarget& target, double share);
    /// Over all of the target, as its viewer sees it.
    franken::OverlayQuad quad(const franken::DrawTarget& target) const;
    /// Gives the memory back.
    void release();
    /// Forgets its objects: their names may be those of another context's objects by now.
    void contextLost() { m_framebuffer = 0; }

private:
    franken::Result<void> make(int width, int height);

    franken::Gl m_gl;
    franken::Renderer& m_renderer;
    unsigned m_framebuffer = 0, m_texture = 0, m_depth = 0;
    int m_width = 0, m_height = 0;
    std::optional<franken::PictureId> m_picture;
    franken::MemoryLease m_lease;
};

/// One white pixel, to fill areas of the overlay with a colour.
franken::Result<franken::PictureId> addWhite(franken::Renderer& renderer);

/// Width and height of a target as its viewer sees it.
franken::OverlayRect viewerArea(const franken::DrawTarget& target);

} // namespace kiosk
