// SPDX-License-Identifier: MIT
#include "support/offscreen.h"

#include <algorithm>
#include <cstdlib>

namespace franken::test {

ReadBack::Pixel ReadBack::pixel(int x, int y) const {
    const auto index =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    return {rgba.at(index), rgba.at(index + 1), rgba.at(index + 2), rgba.at(index + 3)};
}

Result<Offscreen> openOffscreen(platform::Backend backend, platform::Size size, int samples) {
    constexpr int kKeep = 0;
    setenv("GALLIUM_DRIVER", "softpipe", kKeep);
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", kKeep);
    Result<std::unique_ptr<platform::Surface>> surface =
        platform::create(backend, {.size = size, .samples = samples});
    if (!surface)
        return surface.error();
    Result<Gl> gl = Gl::load((*surface)->getProcAddress());
    if (!gl)
        return gl.error();
    gl->Viewport(0, 0, size.width, size.height);
    return Offscreen{*std::move(surface), *gl};
}

ReadBack readBack(const Offscreen& offscreen) {
    return readBack(offscreen, offscreen.surface->framebuffer());
}

ReadBack readBack(const Offscreen& offscreen, unsigned framebuffer) {
    const auto [width, height] = offscreen.surface->size();
    const auto rowBytes = 4 * static_cast<std::size_t>(width);
    ReadBack image;
    image.width = width;
    image.height = height;
    image.rgba.resize(rowBytes * static_cast<std::size_t>(height));
    offscreen.gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    offscreen.gl.ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    const auto row = [&](int y) { return image.rgba.data() + rowBytes * static_cast<std::size_t>(y); };
    for (int low = 0, high = height - 1; low < high; ++low, --high)
        std::swap_ranges(row(low), row(low) + rowBytes, row(high));
    return image;
}

void OffscreenTest::SetUp() {
    Result<Offscreen> offscreen = openOffscreen(GetParam(), m_size);
    if (!offscreen && offscreen.error().code == "surface.not-installed")
        GTEST_SKIP() << toString(offscreen.error());
    ASSERT_TRUE(offscreen) << toString(offscreen.error());
    m_offscreen = *std::move(offscreen);
}

void OffscreenTest::replaceContext(platform::Size size) {
    m_offscreen = {};
    Result<Offscreen> offscreen = openOffscreen(GetParam(), size);
    ASSERT_TRUE(offscreen) << toString(offscreen.error());
    m_offscreen = *std::move(offscreen);
}

} // namespace franken::test
