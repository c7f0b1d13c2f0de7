// SPDX-License-Identifier: MIT
#include "common/progress_bar.h"

#include <unistd.h>

#include <iostream>

namespace {

using namespace std::chrono_literals;

constexpr int kWidth = 40;

} // namespace

ProgressBar::ProgressBar(std::string what)
    : m_what(std::move(what)), m_terminal(isatty(STDERR_FILENO) == 1), m_next(Clock::now() + 500ms) {}

ProgressBar::~ProgressBar() {
    if (m_shown)
        std::cerr << "\r\033[K" << std::flush;
}

void ProgressBar::show(float share) {
    if (!m_terminal || Clock::now() < m_next)
        return;
    m_next = Clock::now() + 100ms;
    m_shown = true;
    const auto filled = static_cast<std::size_t>(share * kWidth);
    std::cerr << "\r\033[K" << m_what << " [" << std::string(filled, '#') << std::string(kWidth - filled, ' ')
              << "] " << static_cast<int>(100 * share) << " %" << std::flush;
}
