// SPDX-License-Identifier: MIT
#pragma once

#include "device.h"

namespace franken::platform {

/// Refreshes a second in thousandths.
int refreshMilliHertz(const drm_mode_modeinfo& mode);

/// "1280x720@60".
std::string describe(const drm_mode_modeinfo& mode);

drm_mode_modeinfo toMode(const Modeline& modeline);

/// A way to fill the screen: a mode, and the size of the buffer; where that is smaller, the plane scales.
struct ModeChoice {
    drm_mode_modeinfo mode;
    Size buffer;
    bool scaled() const { return buffer != Size{mode.hdisplay, mode.vdisplay}; }
};

/// What to try, in this order: what the options ask for; the modeline; the mode of the kernel's command
/// line (video=); the preferred one; then, from the largest down, smaller ones. Those that exceed the limits
/// come last, with a buffer that the plane scales. `maxExtent` is what the GPU can render, where the options
/// do not say. Interlaced modes are left out.
std::vector<ModeChoice> modeChoices(const KmsConnector& connector, const ScreenOptions& options,
                                    int maxExtent);

/// Modes for a second screen that shows a buffer of that size, in the order to try them: those of its size,
/// at best of that refresh rate (in thousandths), then the preferred one and the others from the largest
/// down.
std::vector<ModeChoice> mirrorChoices(const KmsConnector& connector, Size buffer, int refreshMilliHertz);

/// A format, and the modifiers that the buffer is made with; an empty list is "none, by AddFB2".
struct FormatChoice {
    PixelFormat format;
    std::uint32_t fourcc;
    std::vector<std::uint64_t> modifiers;
};

/// What to try, in this order: the wanted format, then 8 bits; each with all modifiers that the plane takes
/// (whoever makes the buffer picks one of them that the GPU can draw to), then LINEAR, then without.
std::vector<FormatChoice> formatChoices(const KmsPlane& plane, PixelFormat wanted);

} // namespace franken::platform
