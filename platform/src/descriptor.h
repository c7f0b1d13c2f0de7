// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <optional>
#include <utility>

namespace franken::platform {

using Nanoseconds = std::chrono::nanoseconds;

/// A file descriptor that is closed when its owner goes.
class FileDescriptor {
public:
    FileDescriptor() = default;
    explicit FileDescriptor(int descriptor) : m_descriptor(descriptor) {}
    FileDescriptor(FileDescriptor&& other) noexcept : m_descriptor(std::exchange(other.m_descriptor, -1)) {}
    FileDescriptor& operator=(FileDescriptor&& other) noexcept {
        std::swap(m_descriptor, other.m_descriptor);
        return *this;
    }
    ~FileDescriptor() { reset(); }

    explicit operator bool() const { return m_descriptor >= 0; }
    int get() const { return m_descriptor; }
    void reset();

private:
    int m_descriptor = -1;
};

/// CLOCK_MONOTONIC.
Nanoseconds monotonicNow();

/// An eventfd. signal() makes it readable, drain() makes it unreadable again.
FileDescriptor makeEvent();
void signal(const FileDescriptor& event);
void drain(const FileDescriptor& eventOrTimer);

/// A timerfd of CLOCK_MONOTONIC: readable from that time on, or never.
FileDescriptor makeTimer();
void arm(const FileDescriptor& timer, std::optional<Nanoseconds> time);

/// An epoll descriptor that is readable when one of those watched is; they leave it when they are closed.
FileDescriptor makePoll();
void watch(const FileDescriptor& poll, int descriptor);

} // namespace franken::platform
