// SPDX-License-Identifier: MIT
#pragma once

#include "kiosk/event_loop.h"

#include <array>
#include <cstdint>
#include <optional>

namespace kiosk {

/// Percentiles of the frames' drawing times, and counts. Allocates nothing.
class FrameTimes {
public:
    /// `work`: from the frame's beginning until it was handed to the driver. `late`: refreshes that it
    /// missed.
    void add(Time work, int late);

    std::uint64_t frames() const { return m_frames; }
    std::uint64_t late() const { return m_late; }
    double seconds() const { return m_seconds; } ///< The sum of all.

    /// Of the last kWindow frames, 0-100; nothing before the first.
    std::optional<double> percentile(double percent) const;
    static constexpr std::size_t kWindow = 600;

private:
    std::array<double, kWindow> m_window{}; ///< Seconds.
    std::uint64_t m_frames = 0, m_late = 0;
    double m_seconds = 0;
};

} // namespace kiosk
