// SPDX-License-Identifier: MIT
#pragma once

#include "franken/platform/surface.h"

#include <cstddef>
#include <mutex>

struct gbm_bo;

namespace franken::platform {

/// The 8-bit colours of rows of pixels of a DRM format that a screen's target may have: XRGB8888, XRGB2101010
/// or RGB565; nothing for another one. `stride`: bytes from row to row.
std::vector<std::uint8_t> toRgba(const std::byte* rows, std::size_t stride, Size size, std::uint32_t format);

/// A buffer that nobody draws to. Its owner takes it away with revoke() before it destroys it.
class HeldBuffer final : public HeldPicture {
public:
    /// `mapping`: locked while any buffer of the device is mapped: GBM has one context for that.
    HeldBuffer(gbm_bo* buffer, std::shared_ptr<std::mutex> mapping)
        : m_buffer(buffer), m_mapping(std::move(mapping)) {}

    Result<ScreenPicture> read() override;
    /// Waits for a read() that runs.
    void revoke();

private:
    gbm_bo* m_buffer; ///< Null once it is revoked.
    std::shared_ptr<std::mutex> m_mapping;
};

} // namespace franken::platform
