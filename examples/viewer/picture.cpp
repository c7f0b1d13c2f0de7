// SPDX-License-Identifier: MIT
#include "picture.h"

#include <algorithm>

using namespace franken;

Image readTopDown(const Gl& gl, const platform::Surface& surface) {
    const platform::Size size = surface.size();
    const std::size_t row = 4 * static_cast<std::size_t>(size.width);
    Image image;
    image.width = size.width;
    image.height = size.height;
    image.rgba.resize(row * static_cast<std::size_t>(size.height));
    gl.BindFramebuffer(GL_FRAMEBUFFER, surface.framebuffer());
    gl.ReadPixels(0, 0, size.width, size.height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    const auto rowAt = [&](int y) { return image.rgba.begin() + static_cast<std::ptrdiff_t>(row) * y; };
    for (int low = 0, high = size.height - 1; low < high; ++low, --high)
        std::swap_ranges(rowAt(low), rowAt(low + 1), rowAt(high));
    return image;
}

Image halved(const Image& image) {
    Image half;
    half.width = image.width / 2;
    half.height = image.height / 2;
    const std::size_t row = 4 * static_cast<std::size_t>(image.width);
    for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x)
            for (std::size_t channel = 0; channel < 4; ++channel) {
                const std::uint8_t* p = image.rgba.data() + 2 * static_cast<std::size_t>(y) * row +
                                        8 * static_cast<std::size_t>(x) + channel;
                half.rgba.push_back(static_cast<std::uint8_t>((p[0] + p[4] + p[row] + p[row + 4] + 2) / 4));
            }
    return half;
}
