// SPDX-License-Identifier: MIT
#include "franken/platform/console.h"

#include "descriptor.h"

#include <fcntl.h>
#include <linux/kd.h>
#include <linux/vt.h>
#include <sys/eventfd.h>
#include <sys/ioctl.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

namespace franken::platform {

namespace {

class KernelConsole final : public ConsoleCalls {
public:
    explicit KernelConsole(FileDescriptor device) : m_device(std::move(device)) {}
    int call(unsigned long request, unsigned long argument) override {
        return ioctl(m_device.get(), request, argument) < 0 ? -errno : 0;
    }

private:
    FileDescriptor m_device;
};

// What the signal handlers touch, and nothing else of this file.
std::atomic<int> signalled = -1;
std::atomic<bool> leaving = false, returned = false;

void onSignal(int number) {
    const int before = errno;
    (number == SIGRTMIN ? leaving : returned) = true;
    eventfd_write(signalled, 1);
    errno = before;
}

Console* current = nullptr; ///< For std::exit().

void restoreAtExit() {
    if (current != nullptr)
        current->restore();
}

unsigned long address(void* pointer) { return reinterpret_cast<unsigned long>(pointer); }

Error missing(const std::string& where, int error) {
    if (error == EACCES || error == EPERM)
        return {"console.permission", where, "it may not be opened",
                "put the user into the group tty, or run as a unit with TTYPath="};
    return {"console.missing", where, std::strerror(error), "run on a virtual console"};
}

} // namespace

struct Console::State {
    std::unique_ptr<ConsoleCalls> calls;
    FileDescriptor event = makeEvent();
    // What was before, as far as it was changed.
    std::optional<int> keyboard, picture;
    std::optional<vt_mode> switching;
    struct sigaction onLeaving = {}, onReturned = {};
};

Console::Console(std::unique_ptr<ConsoleCalls> calls) : m_state(std::make_unique<State>()) {
    m_state->calls = std::move(calls);
}

Result<std::unique_ptr<Console>> Console::open(const std::string& path) {
    const std::string shown = path.empty() ? "/dev/tty0" : path;
    FileDescriptor device(::open(shown.c_str(), O_RDWR | O_CLOEXEC | O_NOCTTY));
    if (!device)
        return missing(shown, errno);
    return open(std::make_unique<KernelConsole>(std::move(device)));
}

Result<std::unique_ptr<Console>> Console::open(std::unique_ptr<ConsoleCalls> calls) {
    if (current != nullptr)
        return Error{"console.busy", "", "this process has a Console already", "destroy that one first"};
    std::unique_ptr<Console> console(new Console(std::move(calls)));
    if (Result<void> taken = console->take(); !taken)
        return taken.error();
    static const int registered = std::atexit(restoreAtExit);
    static_cast<void>(registered);
    return console;
}

Result<void> Console::take() {
    State& state = *m_state;
    current = this; // What is taken from here on is put back, whatever fails.
    int keyboard = 0, picture = 0;
    if (const int error = state.calls->call(KDGKBMODE, address(&keyboard)); error != 0)
        return missing("KDGKBMODE", -error);
    if (const int error = state.calls->call(KDGETMODE, address(&picture)); error != 0)
        return missing("KDGETMODE", -error);
    vt_mode switching = {};
    if (const int error = state.calls->call(VT_GETMODE, address(&switching)); error != 0)
        return missing("VT_GETMODE", -error);

    // So a program that was killed left it, and what is put back later has to work.
    keyboard = keyboard == K_OFF ? K_UNICODE : keyboard;
    picture = picture == KD_GRAPHICS ? KD_TEXT : picture;
    if (switching.mode == VT_PROCESS)
        switching = {.mode = VT_AUTO, .waitv = 0, .relsig = 0, .acqsig = 0, .frsig = 0};

    signalled = state.event.get();
    struct sigaction action = {};
    action.sa_handler = onSignal;
    action.sa_flags = SA_RESTART;
    sigaction(SIGRTMIN, &action, &state.onLeaving);
    sigaction(SIGRTMIN + 1, &action, &state.onReturned);
    state.switching = switching;
    vt_mode ours = {};
    ours.mode = VT_PROCESS;
    ours.relsig = static_cast<short>(SIGRTMIN);
    ours.acqsig = static_cast<short>(SIGRTMIN + 1);
    if (const int error = state.calls->call(VT_SETMODE, address(&ours)); error != 0)
        return missing("VT_SETMODE", -error);
    state.keyboard = keyboard;
    if (const int error = state.calls->call(KDSKBMODE, K_OFF); error != 0)
        return missing("KDSKBMODE", -error);
    state.picture = picture;
    if (const int error = state.calls->call(KDSETMODE, KD_GRAPHICS); error != 0)
        return missing("KDSETMODE", -error);
    return {};
}

Console::~Console() { restore(); }

void Console::restore() {
    State& state = *m_state;
    if (state.picture)
        state.calls->call(KDSETMODE, static_cast<unsigned long>(*state.picture));
    if (state.keyboard)
        state.calls->call(KDSKBMODE, static_cast<unsigned long>(*state.keyboard));
    if (state.switching) {
        state.calls->call(VT_SETMODE, address(&*state.switching));
        signalled = -1;
        sigaction(SIGRTMIN, &state.onLeaving, nullptr);
        sigaction(SIGRTMIN + 1, &state.onReturned, nullptr);
        leaving = returned = false;
    }
    state.picture.reset();
    state.keyboard.reset();
    state.switching.reset();
    if (current == this)
        current = nullptr;
}

int Console::descriptor() const { return m_state->event.get(); }

Console::Event Console::dispatch() {
    drain(m_state->event);
    if (leaving.exchange(false))
        return Event::Leaving;
    if (!returned.exchange(false))
        return Event::None;
    m_state->calls->call(VT_RELDISP, VT_ACKACQ);
    return Event::Returned;
}

Result<void> Console::left() {
    if (const int error = m_state->calls->call(VT_RELDISP, 1); error != 0)
        return missing("VT_RELDISP", -error);
    return {};
}

} // namespace franken::platform
