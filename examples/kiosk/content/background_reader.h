// SPDX-License-Identifier: MIT
#pragma once

#include <sys/eventfd.h>
#include <unistd.h>

#include <condition_variable>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

namespace kiosk {

/// Reads files on a thread of its own, one at a time. All calls return at once, but for the destructor.
template<typename Value>
class BackgroundReader {
public:
    using Path = std::filesystem::path;
    /// Called on the thread. What it returns after a stop was requested is dropped.
    using Read = std::function<Value(const Path&, const std::stop_token&)>;

    explicit BackgroundReader(Read read)
        : m_read(std::move(read)),
          m_done(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
          m_thread([this](const std::stop_token& stop) { run(stop); }) {}

    /// Waits for the file that is being read.
    ~BackgroundReader() {
        cancel();
        m_thread.request_stop();
        m_thread.join();
        close(m_done);
    }
    BackgroundReader(const BackgroundReader&) = delete;
    BackgroundReader& operator=(const BackgroundReader&) = delete;

    /// Reads that file; what an earlier request asked for is dropped.
    void request(const Path& path) {
        cancel();
        const std::lock_guard lock(m_mutex);
        m_requested = path;
        m_wake.notify_one();
    }

    void cancel() {
        const std::lock_guard lock(m_mutex);
        eventfd_t count = 0;
        eventfd_read(m_done, &count); // Nobody is called for what is dropped.
        m_reading.request_stop();
        m_requested.reset();
        m_value.reset();
    }

    /// A descriptor that is readable when take() has something.
    int descriptor() const { return m_done; }

    std::optional<Value> take() {
        eventfd_t count = 0;
        eventfd_read(m_done, &count);
        const std::lock_guard lock(m_mutex);
        return std::exchange(m_value, std::nullopt);
    }

private:
    void run(const std::stop_token& stop) {
        std::unique_lock lock(m_mutex);
        while (m_wake.wait(lock, stop, [this] { return m_requested.has_value(); })) {
            const Path path = *std::exchange(m_requested, std::nullopt);
            m_reading = std::stop_source();
            const std::stop_token cancelled = m_reading.get_token();
            lock.unlock();
            Value value = m_read(path, cancelled);
            lock.lock();
            if (cancelled.stop_requested())
                continue;
            m_value = std::move(value);
            eventfd_write(m_done, 1);
        }
    }

    Read m_read;
    int m_done; ///< An eventfd.
    std::mutex m_mutex;
    std::condition_variable_any m_wake;
    std::optional<Path> m_requested;
    std::stop_source m_reading; ///< Of what is being read.
    std::optional<Value> m_value;
    std::jthread m_thread; ///< Last: it uses all of the above.
};

} // namespace kiosk
