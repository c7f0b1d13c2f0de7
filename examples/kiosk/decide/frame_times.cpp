// SPDX-License-Identifier: MIT
#include "kiosk/decide/frame_times.h"

#include <algorithm>
#include <cmath>

namespace kiosk {

void FrameTimes::add(Time work, int late) {
    const double seconds = std::chrono::duration<double>(work).count();
    m_window[m_frames % kWindow] = seconds;
    ++m_frames;
    m_late += late > 0 ? 1 : 0;
    m_seconds += seconds;
}

std::optional<double> FrameTimes::percentile(double percent) const {
    const std::size_t count = std::min<std::uint64_t>(m_frames, kWindow);
    if (count == 0)
        return {};
    // The nearest rank.
    const auto rank = static_cast<std::size_t>(std::ceil(percent / 100 * static_cast<double>(count)));
    std::array<double, kWindow> sorted = m_window;
    const auto at = sorted.begin() + static_cast<std::ptrdiff_t>(std::clamp<std::size_t>(rank, 1, count) - 1);
    std::nth_element(sorted.begin(), at, sorted.begin() + static_cast<std::ptrdiff_t>(count));
    return *at;
}

} // namespace kiosk
