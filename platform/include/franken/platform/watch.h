// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/platform/surface.h"

#include <chrono>
#include <optional>

/// On a Raspberry Pi a GPU hang is not reported: Mesa's vc4 and v3d never report a lost context. A hang shows
/// as frames that are not completed, as garbage, or as GL errors. GpuHealth tests the GPU, Watch decides what
/// to do.
namespace franken {
namespace FRANKEN_API platform {

/// Tests the GPU of the current context. The calls wait for the GPU: if it never answers, the loop freezes,
/// and the service manager's watchdog ends the process.
class GpuHealth {
public:
    /// Takes the functions of the context that is current.
    explicit GpuHealth(const GetProcAddress& getProcAddress);

    /// Draws a canary, one pixel of a colour that differs from the last one, into a target of its own, and
    /// reads it back; false where the GPU did not draw it. Restores the framebuffer binding, clear colour,
    /// colour mask and scissor test, which it queries from GL: call it once a minute, not in every frame.
    bool canaryLives();

    /// The first error since the last call, as glGetError() names it; 0 without. Once a second is enough.
    unsigned takeError();

private:
    struct Functions;
    std::shared_ptr<const Functions> m_gl;
    unsigned m_framebuffer = 0, m_colour = 0;
    unsigned m_turn = 0;
};

/// What counts as a fault, and when it is looked for.
struct WatchOptions {
    /// A frame that is not completed after this time is a fault. A KMS surface acts by itself after
    /// ScreenOptions::flipTimeout; make this limit longer, for hangs that the surface cannot see.
    std::chrono::milliseconds frameLimit{12'000};
    std::chrono::milliseconds canaryInterval{60'000}; ///< How often a test frame is read back.
    std::chrono::milliseconds errorInterval{1'000};   ///< How often GL is asked for errors.
    int errorLimit = 5; ///< GL errors in this many successive intervals are a fault.
    /// After this time without a fault, the next one counts as the first again.
    std::chrono::milliseconds forgetAfter{600'000};
};

/// Escalates: after the first fault the screen is reset; after the next the process should end with an error;
/// the unit's StartLimitAction reboots the machine if that happens too often. Uses no clock: the caller
/// passes the time.
class Watch {
public:
    /// Of any clock that does not jump.
    using Time = std::chrono::nanoseconds;
    /// Begins without a fault.
    explicit Watch(const WatchOptions& options = {}) : m_options(options) {}

    /// A frame was handed over.
    void submitted(Time now) { m_submitted = now; }
    /// It is shown: nothing is overdue.
    void completed() { m_submitted.reset(); }
    /// Nothing is drawn for now (no screen, blanked, paused): nothing is overdue.
    void idle() { m_submitted.reset(); }

    /// Whether the next test is due; true once per interval.
    bool canaryDue(Time now) { return isDue(m_canary, m_options.canaryInterval, now); }
    bool errorDue(Time now) { return isDue(m_error, m_options.errorInterval, now); }
    /// The test frame came back, or did not.
    void canary(bool lives) { m_deadCanary = !lives; }
    /// What glGetError() returned; 0 is no error.
    void error(unsigned glError) { m_errors = glError == 0 ? 0 : m_errors + 1; }

    /// What is to be done.
    enum class Step {
        None,
        ResetScreen, ///< Surface::resetScreen().
        Exit         ///< End the process, with reason() as the last words.
    };
    /// What to do now. Each fault is answered once.
    Step step(Time now);
    /// Why step() said so: one sentence.
    const std::string& reason() const { return m_reason; }

private:
    static bool isDue(std::optional<Time>& last, Time interval, Time now);
    std::optional<std::string> fault(Time now) const;

    WatchOptions m_options;
    std::optional<Time> m_submitted, m_canary, m_error, m_lastFault;
    bool m_deadCanary = false;
    int m_errors = 0;
    std::string m_reason;
};

} // namespace platform
} // namespace franken
