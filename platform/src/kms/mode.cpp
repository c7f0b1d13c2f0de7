// SPDX-License-Identifier: MIT
#include "mode.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <tuple>

namespace franken::platform {

namespace {

struct Limits {
    int extent;
    double pixels;
    bool allow(Size size) const {
        return std::max(size.width, size.height) <= extent &&
               static_cast<double>(size.width) * size.height <= pixels;
    }
};

Size sizeOf(const drm_mode_modeinfo& mode) { return {mode.hdisplay, mode.vdisplay}; }

/// The largest size of the same shape within the limits; even numbers, for tiled layouts.
Size shrunk(Size size, const Limits& limits) {
    const double area = static_cast<double>(size.width) * size.height;
    const double scale =
        std::min({1.0, static_cast<double>(limits.extent) / std::max(size.width, size.height),
                  std::sqrt(limits.pixels / area)});
    const auto even = [&](int extent) { return std::max(2, static_cast<int>(extent * scale) / 2 * 2); };
    return {even(size.width), even(size.height)};
}

bool matches(const drm_mode_modeinfo& mode, const ModeRequest& request) {
    return sizeOf(mode) == request.size &&
           (request.refresh == 0 || std::lround(refreshMilliHertz(mode) / 1000.0) == request.refresh);
}

/// The kernel command line's (video=) first, then the preferred one, then larger before smaller, then faster
/// before slower.
bool comesBefore(const drm_mode_modeinfo& a, const drm_mode_modeinfo& b) {
    const auto order = [](const drm_mode_modeinfo& mode) {
        return std::tuple((mode.type & DRM_MODE_TYPE_USERDEF) == 0,
                          (mode.type & DRM_MODE_TYPE_PREFERRED) == 0,
                          -int{mode.hdisplay} * int{mode.vdisplay}, -refreshMilliHertz(mode));
    };
    return order(a) < order(b);
}

/// Best first; without interlaced ones.
std::vector<drm_mode_modeinfo> progressiveModes(const KmsConnector& connector) {
    std::vector<drm_mode_modeinfo> modes = connector.modes;
    std::erase_if(modes,
                  [](const drm_mode_modeinfo& mode) { return (mode.flags & DRM_MODE_FLAG_INTERLACE) != 0; });
    std::stable_sort(modes.begin(), modes.end(), comesBefore);
    return modes;
}

} // namespace

int refreshMilliHertz(const drm_mode_modeinfo& mode) {
    if (mode.htotal == 0 || mode.vtotal == 0)
        return static_cast<int>(mode.vrefresh) * 1000;
    const double lines = static_cast<double>(mode.htotal) * mode.vtotal;
    return static_cast<int>(std::lround(mode.clock * 1e6 / lines));
}

std::string describe(const drm_mode_modeinfo& mode) {
    return std::to_string(mode.hdisplay) + "x" + std::to_string(mode.vdisplay) + "@" +
           std::to_string(std::lround(refreshMilliHertz(mode) / 1000.0));
}

drm_mode_modeinfo toMode(const Modeline& modeline) {
    const auto narrow = [](int value) { return static_cast<std::uint16_t>(value); };
    drm_mode_modeinfo mode = {};
    mode.clock = static_cast<std::uint32_t>(modeline.clock);
    mode.hdisplay = narrow(modeline.width);
    mode.hsync_start = narrow(modeline.hsyncStart);
    mode.hsync_end = narrow(modeline.hsyncEnd);
    mode.htotal = narrow(modeline.htotal);
    mode.vdisplay = narrow(modeline.height);
    mode.vsync_start = narrow(modeline.vsyncStart);
    mode.vsync_end = narrow(modeline.vsyncEnd);
    mode.vtotal = narrow(modeline.vtotal);
    mode.flags = (modeline.positiveHsync ? DRM_MODE_FLAG_PHSYNC : DRM_MODE_FLAG_NHSYNC) |
                 (modeline.positiveVsync ? DRM_MODE_FLAG_PVSYNC : DRM_MODE_FLAG_NVSYNC);
    mode.type = DRM_MODE_TYPE_USERDEF;
    mode.vrefresh = static_cast<std::uint32_t>(std::lround(refreshMilliHertz(mode) / 1000.0));
    std::snprintf(mode.name, sizeof mode.name, "%s", describe(mode).c_str());
    return mode;
}

std::vector<ModeChoice> modeChoices(const KmsConnector& connector, const ScreenOptions& options,
                                    int maxExtent) {
    const Limits limits{options.maxExtent > 0 ? options.maxExtent : maxExtent,
                        static_cast<double>(options.maxPixels)};
    std::vector<drm_mode_modeinfo> modes = progressiveModes(connector);
    if (options.modeline)
        modes.insert(modes.begin(), toMode(*options.modeline));
    if (options.mode)
        std::stable_partition(modes.begin(), modes.end(),
                              [&](const drm_mode_modeinfo& mode) { return matches(mode, *options.mode); });
    std::vector<ModeChoice> choices;
    for (const drm_mode_modeinfo& mode : modes)
        if (limits.allow(sizeOf(mode)))
            choices.push_back({mode, sizeOf(mode)});
    for (const drm_mode_modeinfo& mode : modes)
        if (!limits.allow(sizeOf(mode)))
            choices.push_back({mode, shrunk(sizeOf(mode), limits)});
    return choices;
}

std::vector<ModeChoice> mirrorChoices(const KmsConnector& connector, Size buffer, int refreshMilliHertz) {
    std::vector<ModeChoice> choices;
    for (const drm_mode_modeinfo& mode : progressiveModes(connector))
        choices.push_back({mode, buffer});
    std::stable_sort(choices.begin(), choices.end(), [&](const ModeChoice& a, const ModeChoice& b) {
        const auto order = [&](const ModeChoice& choice) {
            const int off = std::abs(platform::refreshMilliHertz(choice.mode) - refreshMilliHertz);
            return std::pair(choice.scaled(), choice.scaled() ? 0 : off);
        };
        return order(a) < order(b);
    });
    return choices;
}

std::vector<FormatChoice> formatChoices(const KmsPlane& plane, PixelFormat wanted) {
    struct Row {
        PixelFormat format;
        std::uint32_t fourcc;
    };
    std::vector<Row> rows = {{PixelFormat::Rgb8, DRM_FORMAT_XRGB8888}};
    if (wanted == PixelFormat::Rgb10)
        rows.insert(rows.begin(), {PixelFormat::Rgb10, DRM_FORMAT_XRGB2101010});
    if (wanted == PixelFormat::Rgb565)
        rows.insert(rows.begin(), {PixelFormat::Rgb565, DRM_FORMAT_RGB565});
    const std::vector<std::uint64_t> linear = {DRM_FORMAT_MOD_LINEAR};
    std::vector<FormatChoice> choices;
    for (const auto& [format, fourcc] : rows) {
        const auto taken = plane.formats.find(fourcc);
        if (taken == plane.formats.end())
            continue;
        const std::vector<std::uint64_t>& modifiers = taken->second;
        if (!modifiers.empty() && modifiers != linear)
            choices.push_back({format, fourcc, modifiers});
        if (std::find(modifiers.begin(), modifiers.end(), linear.front()) != modifiers.end())
            choices.push_back({format, fourcc, linear});
        choices.push_back({format, fourcc, {}});
    }
    return choices;
}

} // namespace franken::platform
