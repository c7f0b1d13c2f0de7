// SPDX-License-Identifier: MIT
#include "descriptor.h"

#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>

namespace franken::platform {

void FileDescriptor::reset() {
    if (m_descriptor >= 0)
        close(m_descriptor);
    m_descriptor = -1;
}

Nanoseconds monotonicNow() {
    timespec now = {};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return std::chrono::seconds(now.tv_sec) + Nanoseconds(now.tv_nsec);
}

FileDescriptor makeEvent() { return FileDescriptor(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)); }

void signal(const FileDescriptor& event) { eventfd_write(event.get(), 1); }

void drain(const FileDescriptor& eventOrTimer) {
    std::uint64_t count = 0;
    [[maybe_unused]] const ssize_t bytes = read(eventOrTimer.get(), &count, sizeof count);
}

FileDescriptor makeTimer() {
    return FileDescriptor(timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC | TFD_NONBLOCK));
}

void arm(const FileDescriptor& timer, std::optional<Nanoseconds> time) {
    itimerspec when = {}; // Zero disarms.
    if (time) {
        const std::int64_t count = std::max<std::int64_t>(time->count(), 1);
        when.it_value = {static_cast<time_t>(count / 1'000'000'000),
                         static_cast<long>(count % 1'000'000'000)};
    }
    timerfd_settime(timer.get(), TFD_TIMER_ABSTIME, &when, nullptr);
}

FileDescriptor makePoll() { return FileDescriptor(epoll_create1(EPOLL_CLOEXEC)); }

void watch(const FileDescriptor& poll, int descriptor) {
    epoll_event event = {};
    event.events = EPOLLIN;
    event.data.fd = descriptor;
    epoll_ctl(poll.get(), EPOLL_CTL_ADD, descriptor, &event);
}

} // namespace franken::platform
