// SPDX-License-Identifier: MIT
// What a copy of the screen makes of the pixels of its formats.
#include "kms/held_buffer.h"

#include <drm_fourcc.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>

namespace franken::platform {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Two rows of two pixels, with four bytes behind each row.
template<typename Pixel>
Bytes copyOf(const std::array<Pixel, 4>& pixels, std::uint32_t format) {
    const std::size_t stride = 2 * sizeof(Pixel) + 4;
    std::vector<std::byte> rows(2 * stride, std::byte{0xEE});
    std::memcpy(rows.data(), pixels.data(), 2 * sizeof(Pixel));
    std::memcpy(rows.data() + stride, pixels.data() + 2, 2 * sizeof(Pixel));
    return toRgba(rows.data(), stride, {2, 2}, format);
}

TEST(HeldBuffer, EachFormatBecomesEightBitsAsGlRoundsThem) {
    EXPECT_EQ(copyOf<std::uint32_t>({0xFF112233, 0x00FFFFFF, 0, 0x12800040}, DRM_FORMAT_XRGB8888),
              (Bytes{0x11, 0x22, 0x33, 255, 255, 255, 255, 255, 0, 0, 0, 255, 0x80, 0, 0x40, 255}));
    // 341 of 1023 is a third, 512 a little more than a half, 2 rounds to 0 and 3 to 1.
    EXPECT_EQ(copyOf<std::uint32_t>(
                  {341u << 20 | 512u << 10 | 1023u, 3u << 30, 2u << 20 | 3u << 10 | 1u, 1023u << 20},
                  DRM_FORMAT_XRGB2101010),
              (Bytes{85, 128, 255, 255, 0, 0, 0, 255, 0, 1, 0, 255, 255, 0, 0, 255}));
    // 16 of 31 is 131.6, 32 of 63 is 129.5, 1 of 31 is 8.2, 1 of 63 is 4.05.
    EXPECT_EQ(copyOf<std::uint16_t>({0x8410, 0x0821, 0xF800, 0x07E0}, DRM_FORMAT_RGB565),
              (Bytes{132, 130, 132, 255, 8, 4, 8, 255, 255, 0, 0, 255, 0, 255, 0, 255}));
}

TEST(HeldBuffer, AnUnknownFormatHasNoColours) {
    EXPECT_EQ(copyOf<std::uint32_t>({}, DRM_FORMAT_NV12), Bytes());
}

} // namespace
} // namespace franken::platform
