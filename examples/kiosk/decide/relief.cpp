// SPDX-License-Identifier: MIT
#include "kiosk/decide/relief.h"

#include <array>
#include <cstdio>

namespace kiosk {

namespace {

constexpr double kHysteresis = 5; // Degrees.
constexpr double kEnough = 2;     // Free memory, in shares of what is too little.

struct Step {
    double resolution, frameRate;
};
constexpr std::array<Step, Relief::kMostSteps + 1> kSteps = {
    {{1, 1}, {0.75, 1}, {0.75, 0.5}, {0.5, 0.5}, {0.5, 0.25}}};

} // namespace

Relief::Level Relief::levelOf(const Strain& strain) {
    std::array<char, 80> text{};
    if (strain.celsius && *strain.celsius >= m_options.hotCelsius) {
        std::snprintf(text.data(), text.size(), "the processor has %.0f °C", *strain.celsius);
        m_cause = text.data();
        return Level::High;
    }
    if (strain.throttled.value_or(false)) {
        m_cause = "the firmware throttles the processor";
        return Level::High;
    }
    return strain.celsius && *strain.celsius >= m_options.hotCelsius - kHysteresis ? Level::Some
                                                                                   : Level::None;
}

bool Relief::observeMemory(const Strain& strain, Time now) {
    const double least = m_options.lowMebibytes * (m_mayPreload ? 1 : kEnough);
    const bool isEnough = !strain.freeMebibytes || *strain.freeMebibytes >= least;
    if (isEnough == m_mayPreload)
        m_sinceMemory = now;
    // A model that is loaded ahead takes what was free without it: there must be enough for a while.
    const Time patience = m_mayPreload ? Time{0} : m_options.recovery;
    if (isEnough == m_mayPreload || now - m_sinceMemory < patience)
        return false;
    m_mayPreload = isEnough;
    m_sinceMemory = now;
    return true;
}

bool Relief::observe(const Strain& strain, Time now) {
    const Level level = levelOf(strain);
    if (level != m_level) {
        m_level = level;
        m_since = now;
    }
    bool isChanged = observeMemory(strain, now);
    const Time lasted = now - m_since;
    if (level == Level::High && lasted >= m_options.patience && m_step < kMostSteps) {
        ++m_step;
        m_since = now;
        isChanged = true;
    }
    if (level == Level::None && lasted >= m_options.recovery && m_step > 0) {
        --m_step;
        m_since = now;
        m_cause = "the processor has cooled down";
        isChanged = true;
    }
    return isChanged;
}

double Relief::resolution() const { return kSteps[static_cast<std::size_t>(m_step)].resolution; }
double Relief::frameRate() const { return kSteps[static_cast<std::size_t>(m_step)].frameRate; }

std::string Relief::reason() const {
    std::array<char, 240> text{};
    std::snprintf(text.data(), text.size(),
                  "relief %d of %d: %.0f %% of the resolution, %.0f %% of the frame rate%s%s%s", m_step,
                  kMostSteps, 100 * resolution(), 100 * frameRate(), m_cause.empty() ? "" : ", because ",
                  m_cause.c_str(),
                  m_mayPreload ? "" : "; too little contiguous memory is free to load ahead");
    return text.data();
}

} // namespace kiosk
