// SPDX-License-Identifier: MIT
#pragma once

#include "kiosk/event_loop.h"

#include <optional>
#include <string>

namespace kiosk {

/// Measurements of the machine; a value that it does not offer is empty.
struct Strain {
    std::optional<double> celsius;
    std::optional<bool> throttled;
    std::optional<double> freeMebibytes; ///< Contiguous memory (CmaFree).
};

struct ReliefOptions {
    double hotCelsius = 80;
    double lowMebibytes = 16;
    Time patience = std::chrono::seconds(10); ///< How long strain lasts before the next step.
    Time recovery = std::chrono::minutes(2);  ///< How long there is none before a step back.
};

/// Relieves a machine that is too hot or throttled: each step lowers the resolution or the frame rate. Pure:
/// the caller passes the time.
class Relief {
public:
    static constexpr int kMostSteps = 4;

    void configure(const ReliefOptions& options) { m_options = options; }

    /// Returns whether the step has changed. Heat counts from hotCelsius on, until the machine is 5 degrees
    /// below it.
    bool observe(const Strain& strain, Time now);

    int step() const { return m_step; }
    double resolution() const; ///< Of width and height, 0.5 to 1.
    double frameRate() const;  ///< Share of the usual one, 0.25 to 1.
    /// Whether there is memory to load a model ahead: not from lowMebibytes down, until twice as much is free
    /// for the time of recovery.
    bool mayPreload() const { return m_mayPreload; }
    /// For the log: "step 2 of 4: 75 % of the resolution, 50 % of the frame rate, because ...".
    std::string reason() const;

private:
    enum class Level { None, Some, High };
    Level levelOf(const Strain& strain);
    bool observeMemory(const Strain& strain, Time now);

    ReliefOptions m_options;
    int m_step = 0;
    bool m_mayPreload = true;
    Level m_level = Level::None;
    Time m_since{0};       ///< Of the level, or of the last step.
    Time m_sinceMemory{0}; ///< When memory last was as mayPreload() says.
    std::string m_cause;
};

} // namespace kiosk
