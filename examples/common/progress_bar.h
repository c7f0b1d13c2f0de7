// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

/// A line on a terminal's standard error that fills as work gets done, overwritten at most ten times a
/// second; nothing where standard error is no terminal, and nothing for work that is done in half a second.
/// Wiped away at the end.
class ProgressBar {
public:
    explicit ProgressBar(std::string what);
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;
    ~ProgressBar();

    /// share: 0 to 1.
    void show(float share);

private:
    using Clock = std::chrono::steady_clock;

    std::string m_what;
    bool m_terminal;
    bool m_shown = false;
    Clock::time_point m_next;
};
