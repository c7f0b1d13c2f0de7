// SPDX-License-Identifier: MIT
#include "kiosk/event_loop.h"

#include <sys/epoll.h>
#include <sys/timerfd.h>
#include <systemd/sd-event.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <ctime>

namespace kiosk {

using franken::Error;
using franken::Result;

namespace {

Error failure(const char* call, int code) { return {"kiosk.event-loop", call, std::strerror(-code), {}}; }

std::uint64_t microseconds(Time time) {
    return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::microseconds>(time).count());
}

struct HandledSource : EventLoop::Timer {
    EventLoop::Handler handler;
    sd_event_source* source = nullptr;

    explicit HandledSource(EventLoop::Handler given) : handler(std::move(given)) {}
    ~HandledSource() override { sd_event_source_disable_unref(source); }

    void arm(Time when) override {
        sd_event_source_set_time(source, microseconds(when));
        sd_event_source_set_enabled(source, SD_EVENT_ONESHOT);
    }
    void disarm() override { sd_event_source_set_enabled(source, SD_EVENT_OFF); }
};

int onDescriptor(sd_event_source*, int, std::uint32_t, void* userdata) {
    static_cast<HandledSource*>(userdata)->handler();
    return 0;
}

int onSignalEvent(sd_event_source*, const signalfd_siginfo*, void* userdata) {
    static_cast<HandledSource*>(userdata)->handler();
    return 0;
}

int onTime(sd_event_source*, std::uint64_t, void* userdata) {
    static_cast<HandledSource*>(userdata)->handler();
    return 0;
}

/// A timer far in the future, which the kernel cancels whenever the clock is set.
class ClockWatch : public EventLoop::Source {
public:
    ClockWatch() : m_timer(timerfd_create(CLOCK_REALTIME, TFD_CLOEXEC | TFD_NONBLOCK)) { set(); }
    ~ClockWatch() override {
        source.reset();
        if (m_timer >= 0)
            close(m_timer);
    }
    ClockWatch(const ClockWatch&) = delete;
    ClockWatch& operator=(const ClockWatch&) = delete;

    int descriptor() const { return m_timer; }
    /// The read fails with ECANCELED, and the timer has to be set again.
    void acknowledge() const {
        std::uint64_t expirations = 0;
        [[maybe_unused]] const ssize_t got = read(m_timer, &expirations, sizeof expirations);
        set();
    }
    std::unique_ptr<EventLoop::Source> source;

private:
    void set() const {
        const itimerspec never{.it_interval = {},
                               .it_value = {.tv_sec = std::time(nullptr) + 1'000'000'000, .tv_nsec = 0}};
        timerfd_settime(m_timer, TFD_TIMER_ABSTIME | TFD_TIMER_CANCEL_ON_SET, &never, nullptr);
    }
    int m_timer;
};

} // namespace

Time now() {
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

struct EventLoop::State {
    sd_event* event = nullptr;
    ~State() { sd_event_unref(event); }
};

EventLoop::EventLoop(std::unique_ptr<State> state) : m_state(std::move(state)) {}
EventLoop::~EventLoop() = default;

Result<std::unique_ptr<EventLoop>> EventLoop::make(std::initializer_list<int> signals) {
    sigset_t blocked;
    sigemptyset(&blocked);
    for (const int number : signals)
        sigaddset(&blocked, number);
    pthread_sigmask(SIG_BLOCK, &blocked, nullptr);
    auto state = std::make_unique<State>();
    if (const int code = sd_event_new(&state->event); code < 0)
        return failure("sd_event_new", code);
    return std::unique_ptr<EventLoop>(new EventLoop(std::move(state)));
}

std::unique_ptr<EventLoop::Source> EventLoop::onReadable(int descriptor, Handler handler) {
    auto source = std::make_unique<HandledSource>(std::move(handler));
    if (sd_event_add_io(m_state->event, &source->source, descriptor, EPOLLIN, onDescriptor, source.get()) < 0)
        return nullptr;
    return source;
}

std::unique_ptr<EventLoop::Source> EventLoop::onSignal(int number, Handler handler) {
    auto source = std::make_unique<HandledSource>(std::move(handler));
    if (sd_event_add_signal(m_state->event, &source->source, number, onSignalEvent, source.get()) < 0)
        return nullptr;
    return source;
}

std::unique_ptr<EventLoop::Source> EventLoop::onClockSet(Handler handler) {
    auto watch = std::make_unique<ClockWatch>();
    watch->source = onReadable(watch->descriptor(), [watch = watch.get(), handler = std::move(handler)] {
        watch->acknowledge();
        handler();
    });
    return watch;
}

std::unique_ptr<EventLoop::Timer> EventLoop::timer(Handler handler) {
    auto source = std::make_unique<HandledSource>(std::move(handler));
    if (sd_event_add_time(m_state->event, &source->source, CLOCK_MONOTONIC, 0, 1, onTime, source.get()) < 0)
        return nullptr;
    source->disarm();
    return source;
}

Result<void> EventLoop::turn() {
    constexpr std::uint64_t kForever = ~std::uint64_t{0};
    if (const int code = sd_event_run(m_state->event, kForever); code < 0)
        return failure("sd_event_run", code);
    return {};
}

} // namespace kiosk
