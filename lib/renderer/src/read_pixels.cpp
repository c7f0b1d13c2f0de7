// SPDX-License-Identifier: MIT
#include "read_pixels.h"

#include "franken/context_check.h"

#include <algorithm>

namespace franken {

Result<Image> readPixels(const Gl& gl, const DrawTarget& target) {
    const TargetArea area = areaOf(target);
    const auto rowBytes = 4 * static_cast<std::size_t>(area.width);
    Image image{"", area.width, area.height, {}};
    image.rgba.resize(rowBytes * static_cast<std::size_t>(area.height));
    gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        return Error{"renderer.target", "framebuffer", "it is not complete, or the context is gone",
                     "attach a colour buffer that the driver draws to"};
    gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
    if (Result<void> before = checkErrors(gl); !before) // Those of others are not of reading.
        return before.error();
    gl.ReadPixels(area.x, area.y, area.width, area.height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    const Error unreadable{"renderer.target", "framebuffer",
                           "the driver cannot read it: it has several samples a pixel, or no colours",
                           "resolve it into a framebuffer of one sample a pixel, and read that"};
    if (Result<void> checked = checkErrors(gl, &unreadable); !checked)
        return checked.error();
    const auto row = [&](int y) {
        return image.rgba.begin() + static_cast<std::ptrdiff_t>(rowBytes) * static_cast<std::ptrdiff_t>(y);
    };
    for (int low = 0, high = area.height - 1; low < high; ++low, --high)
        std::swap_ranges(row(low), row(low + 1), row(high));
    return image;
}

} // namespace franken
