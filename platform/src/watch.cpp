// SPDX-License-Identifier: MIT
#include "franken/platform/watch.h"

namespace franken::platform {

bool Watch::isDue(std::optional<Time>& last, Time interval, Time now) {
    if (last && now - *last < interval)
        return false;
    last = now;
    return true;
}

std::optional<std::string> Watch::fault(Time now) const {
    if (m_submitted && now - *m_submitted >= m_options.frameLimit)
        return "a frame was not completed for " + std::to_string(m_options.frameLimit.count()) + " ms";
    if (m_deadCanary)
        return "the GPU does not draw what it is told to";
    if (m_errors >= m_options.errorLimit)
        return "GL reports errors again and again";
    return std::nullopt;
}

Watch::Step Watch::step(Time now) {
    const std::optional<std::string> found = fault(now);
    if (!found)
        return Step::None;
    m_reason = *found;
    const bool again = m_lastFault && now - *m_lastFault < m_options.forgetAfter;
    m_lastFault = now;
    // Answered: what comes next is told by the next frame, canary and errors. The canary is asked at once.
    m_submitted.reset();
    m_canary.reset();
    m_deadCanary = false;
    m_errors = 0;
    return again ? Step::Exit : Step::ResetScreen;
}

} // namespace franken::platform
