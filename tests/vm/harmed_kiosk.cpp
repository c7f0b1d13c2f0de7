// SPDX-License-Identifier: MIT
//
// harmed_kiosk [HARM [CALL]]: a kiosk for lifecycle_test to harm. It takes a console, a button, touch and a
// screen, draws, watches over itself, and ends with 0 after SIGTERM, with 1 where its ladder says so, with 4
// where the screen is another process'. Harms:
//   kill CALL, term CALL  sends itself SIGKILL or SIGTERM at the first such call (faults.h)
//   lose                  flips are never answered
//   canary                the GPU does not draw
//   freeze                the loop stands still after a second
#include "franken/platform/console.h"
#include "franken/platform/gpio.h"
#include "franken/platform/input.h"
#include "franken/platform/service.h"
#include "franken/platform/watch.h"
#include "support/faults.h"
#include "support/scene.h"

#include <poll.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <iostream>

using namespace franken;
using namespace franken::platform;

namespace {

std::string harm;

void print(LogLevel, std::string_view text) { std::cout << text << std::endl; }

void prepareHarm(const std::string& call) {
    if (harm == "kill" || harm == "term")
        test::onCall = [call](test::Call now) {
            if (call == toString(now))
                raise(harm == "kill" ? SIGKILL : SIGTERM);
            return test::kPass;
        };
    if (harm == "lose")
        test::onCall = [](test::Call now) { return now == test::Call::Commit ? test::kLose : test::kPass; };
}

GetProcAddress functions;

GetProcAddress harmedFunctions(const Surface& surface) {
    functions = surface.getProcAddress();
    if (harm != "canary")
        return functions;
    return [](const char* name) {
        void (*const drawsNothing)(unsigned) = [](unsigned) {};
        return std::strcmp(name, "glClear") == 0 ? reinterpret_cast<void*>(drawsNothing) : functions(name);
    };
}

/// SIGTERM as a descriptor.
int blockedTerm() {
    sigset_t term;
    sigemptyset(&term);
    sigaddset(&term, SIGTERM);
    sigprocmask(SIG_BLOCK, &term, nullptr);
    return signalfd(-1, &term, SFD_CLOEXEC | SFD_NONBLOCK);
}

Watch::Time now() { return std::chrono::steady_clock::now().time_since_epoch(); }

Watch::Step watched(Watch& watch, GpuHealth& health, const SurfaceEvents& events, const Surface& surface) {
    if (events.completed || (surface.state() != SurfaceState::Ready && surface.state() != SurfaceState::Busy))
        watch.completed();
    if (surface.state() == SurfaceState::Ready && watch.canaryDue(now()))
        watch.canary(health.canaryLives());
    if (surface.state() == SurfaceState::Ready && watch.errorDue(now()))
        watch.error(health.takeError());
    return watch.step(now());
}

int fail(const std::string& why) {
    print(LogLevel::Error, why);
    return 1;
}

int run(Surface& surface, int term) {
    const test::VmScene scene(surface.getProcAddress());
    GpuHealth health(harmedFunctions(surface));
    Watch watch;
    ServiceManager service;
    const Watch::Time start = now();
    while (surface.state() != SurfaceState::Failed) {
        if (surface.begin().value()) {
            scene.draw(surface.size(), surface.rotation());
            if (const Result<void> submitted = surface.submit(); !submitted)
                return fail(toString(submitted.error()));
            watch.submitted(now());
        }
        pollfd ready[] = {{surface.descriptor(), POLLIN, 0}, {term, POLLIN, 0}};
        poll(ready, std::size(ready), 100);
        if (ready[1].revents != 0)
            return 0;
        if (harm == "freeze" && now() - start > std::chrono::seconds(1))
            poll(nullptr, 0, -1);
        const Watch::Step step = watched(watch, health, surface.dispatch(), surface);
        if (step == Watch::Step::ResetScreen)
            surface.resetScreen();
        if (step == Watch::Step::Exit)
            return fail(watch.reason());
        if (!service.ready(toString(surface.state())) || !service.alive())
            return fail("the service manager does not listen");
    }
    return fail(toString(surface.failure()));
}

} // namespace

int main(int count, char** arguments) {
    harm = count > 1 ? arguments[1] : "";
    prepareHarm(count > 2 ? arguments[2] : "");
    const int term = blockedTerm();
    const auto console = Console::open("/dev/tty1"); // There is none in every guest.
    GpioInputs buttons({{.name = "next", .pin = {.number = 17}}}, {}, print);
    const auto input = Input::open({.grab = true, .log = print});
    const auto surface = create(Backend::Kms, {.log = print, .screen = {.allowSoftware = true}});
    if (!surface)
        return surface.error().code == "screen.busy" ? 4 : fail(toString(surface.error()));
    return run(**surface, term);
}
