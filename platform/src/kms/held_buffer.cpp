// SPDX-License-Identifier: MIT
#include "held_buffer.h"

#include <drm_fourcc.h>
#include <gbm.h>

#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

namespace franken::platform {

namespace {

/// Where a colour is in a pixel.
struct Channel {
    unsigned shift, bits;

    /// Rounded to 8 bits, as GL does.
    std::uint8_t of(std::uint32_t pixel) const {
        const std::uint32_t most = (1u << bits) - 1;
        return static_cast<std::uint8_t>(((pixel >> shift & most) * 255 + most / 2) / most);
    }
};

struct Layout {
    std::size_t bytes;
    Channel red, green, blue;
};

std::optional<Layout> layoutOf(std::uint32_t format) {
    switch (format) {
    case DRM_FORMAT_XRGB8888:
        return Layout{4, {16, 8}, {8, 8}, {0, 8}};
    case DRM_FORMAT_XRGB2101010:
        return Layout{4, {20, 10}, {10, 10}, {0, 10}};
    case DRM_FORMAT_RGB565:
        return Layout{2, {11, 5}, {5, 6}, {0, 5}};
    default:
        return std::nullopt;
    }
}

} // namespace

std::vector<std::uint8_t> toRgba(const std::byte* rows, std::size_t stride, Size size, std::uint32_t format) {
    const std::optional<Layout> layout = layoutOf(format);
    if (!layout)
        return {};
    const auto width = static_cast<std::size_t>(size.width), height = static_cast<std::size_t>(size.height);
    std::vector<std::uint8_t> rgba;
    rgba.reserve(4 * width * height);
    // A screen's memory is not cached: it is read in long pieces.
    std::vector<std::byte> row(width * layout->bytes);
    for (std::size_t y = 0; y < height; ++y) {
        std::memcpy(row.data(), rows + y * stride, row.size());
        for (std::size_t x = 0; x < width; ++x) {
            std::uint32_t pixel = 0; // Both are little-endian: the format, and all that this runs on.
            std::memcpy(&pixel, row.data() + x * layout->bytes, layout->bytes);
            rgba.insert(rgba.end(),
                        {layout->red.of(pixel), layout->green.of(pixel), layout->blue.of(pixel), 255});
        }
    }
    return rgba;
}

Result<ScreenPicture> HeldBuffer::read() {
    const std::lock_guard lock(*m_mapping);
    const auto failure = [](const char* what, std::string why) {
        return Error{"surface.picture", what, std::move(why), "read the picture of a later frame"};
    };
    if (m_buffer == nullptr)
        return failure("screen", "the buffers of this picture are gone");
    const std::uint32_t width = gbm_bo_get_width(m_buffer), height = gbm_bo_get_height(m_buffer);
    std::uint32_t stride = 0;
    void* mapping = nullptr;
    const auto* const rows = static_cast<const std::byte*>(
        gbm_bo_map(m_buffer, 0, 0, width, height, GBM_BO_TRANSFER_READ, &stride, &mapping));
    if (rows == nullptr)
        return failure("gbm_bo_map", std::strerror(errno));
    ScreenPicture picture{{static_cast<int>(width), static_cast<int>(height)}, {}};
    picture.rgba = toRgba(rows, stride, picture.size, gbm_bo_get_format(m_buffer));
    gbm_bo_unmap(m_buffer, mapping);
    if (picture.rgba.empty())
        return failure("gbm_bo_get_format", "the buffer's format is unknown");
    return picture;
}

void HeldBuffer::revoke() {
    const std::lock_guard lock(*m_mapping);
    m_buffer = nullptr;
}

} // namespace franken::platform
