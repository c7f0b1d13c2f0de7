// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <functional>
#include <thread>

namespace kiosk {

/// Does what may wait for a disk on a thread of its own, so that no frame waits for it: one thing at a time.
class BackgroundTask {
public:
    /// Whether what was started last is not done yet.
    bool runs() const { return m_runs; }

    /// Only while nothing runs.
    void start(std::function<void()> task) {
        m_runs = true;
        m_thread = std::jthread([this, task = std::move(task)] {
            task();
            m_runs = false;
        });
    }

    /// Waits for the end of what runs, as the destructor does.
    void wait() {
        if (m_thread.joinable())
            m_thread.join();
    }

private:
    std::atomic<bool> m_runs = false;
    std::jthread m_thread;
};

} // namespace kiosk
