// SPDX-License-Identifier: MIT
#pragma once

#include "mode.h"
#include "output.h"

namespace franken::platform {

inline constexpr std::uint32_t kNonblocking = DRM_MODE_ATOMIC_NONBLOCK;
inline constexpr std::uint32_t kModeset = DRM_MODE_ATOMIC_ALLOW_MODESET;

/// How the screen is set.
struct KmsLayout {
    ModeChoice mode;
    FormatChoice format;
    Rotation rotation = Rotation::None;
};

/// Everything, whatever was set before: the connector gets the CRTC, the CRTC the mode, its primary plane the
/// framebuffer. Other planes of the CRTC are switched off, other connectors taken from it.
KmsRequest modesetRequest(const KmsResources& resources, const KmsPipe& pipe, const KmsLayout& layout,
                          std::uint32_t modeBlob, std::uint32_t framebuffer, const ScreenOptions& options);

/// The framebuffer alone.
KmsRequest flipRequest(const KmsPipe& pipe, const KmsLayout& layout, std::uint32_t framebuffer);

/// No signal.
KmsRequest offRequest(const KmsPipe& pipe);

void append(KmsRequest& request, const KmsRequest& more);

} // namespace franken::platform
