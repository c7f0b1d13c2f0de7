// SPDX-License-Identifier: MIT
#pragma once

#include "franken/gl_object.h"
#include "franken/platform/surface.h"

#include <cstdint>
#include <vector>

namespace franken::test {

/// Colours that no rotation or mirror maps to itself: a gradient over everything, a triangle that it passes
/// through, a white mark at the upper left as the viewer sees it.
class VmScene {
public:
    explicit VmScene(const platform::GetProcAddress& getProcAddress);

    /// Into the framebuffer that is bound, which has that size before it is turned. Upside down is how Mesa
    /// draws to windows and screens: a framebuffer object gets the same roundings only so.
    void draw(platform::Size size, platform::Rotation rotation, bool upsideDown = false) const;
    const Gl& gl() const { return m_gl; }

private:
    Gl m_gl;
    GlProgram m_program;
};

/// Rows from the top, 0xRRGGBB a pixel.
struct VmPicture {
    platform::Size size;
    std::vector<std::uint32_t> pixels;
    bool operator==(const VmPicture&) const = default;
    std::uint32_t at(int x, int y) const { return pixels.at(static_cast<std::size_t>(y * size.width + x)); }
};

/// Reads the framebuffer that is bound.
VmPicture readPicture(const Gl& gl, platform::Size size);

/// For a look at it: GUEST_KEEP has guest.sh hand it out.
void writePpm(const VmPicture& picture, const std::string& name);

/// "0 of 19200 differ", or where they do.
std::string difference(const VmPicture& a, const VmPicture& b);

} // namespace franken::test
