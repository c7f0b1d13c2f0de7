// SPDX-License-Identifier: MIT
#include "screen.h"

#include "commit_error.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace franken::platform {

namespace {

using namespace std::chrono_literals;

/// A refused commit is tried again after 10, 20, 40, 80 and 160 ms.
constexpr Nanoseconds kFirstRetry = 10ms;
constexpr int kRetries = 5;
constexpr Nanoseconds kMasterRetry = 1s;
/// For so long after a refresh, the ones that follow can be told by the mode's rate.
constexpr Nanoseconds kCounted = 1s;

} // namespace

KmsScreen::KmsScreen(KmsDevice& device, KmsBuffers& buffers, const ScreenOptions& options, int maxExtent,
                     Log log)
    : m_device(device),
      m_buffers(buffers),
      m_options(options),
      m_mirrorOptions(options),
      m_maxExtent(maxExtent),
      m_log(std::move(log)) {
    m_mirrorOptions.margins = {};
}

KmsScreen::~KmsScreen() {
    if (m_modeBlob != 0)
        m_device.removeBlob(m_modeBlob);
    if (m_mirror)
        m_device.removeBlob(m_mirror->modeBlob);
}

void KmsScreen::enter(SurfaceState state, std::string status) {
    const bool news = status != m_status;
    m_state = state;
    m_status = std::move(status);
    if (news && m_log)
        m_log(state == SurfaceState::Failed ? LogLevel::Error : LogLevel::Info, m_status);
}

void KmsScreen::fail(Error error) {
    m_failure = std::move(error);
    m_deadline.reset();
    enter(SurfaceState::Failed, toString(m_failure));
}

void KmsScreen::update(Nanoseconds now) {
    m_mirrorRefused = false;
    lookAgain(now);
}

void KmsScreen::lookAgain(Nanoseconds now) {
    m_updateWanted = true;
    settle(now);
}

void KmsScreen::settle(Nanoseconds now) {
    if (m_flying != 0 || m_state == SurfaceState::Failed || m_deviceLost)
        return;
    if (std::exchange(m_pauseWanted, false)) {
        m_device.dropMaster();
        m_paused = m_needsModeset = true;
        m_deadline.reset();
        enter(SurfaceState::Paused, "given to another console");
    }
    if (m_paused)
        return;
    if (std::exchange(m_resetWanted, false) && m_pipe)
        switchOff();
    if (m_updateWanted)
        configure(now);
    else if (m_blanking != m_applied && m_pipe)
        applyBlanking(now);
}

void KmsScreen::waitForMaster(Nanoseconds now) {
    if (m_waiting != 0)
        m_buffers.release(std::exchange(m_waiting, 0));
    m_needsModeset = true;
    m_deadline = now + kMasterRetry;
    enter(SurfaceState::Paused, m_device.node() + ": another process is the screen's master");
}

void KmsScreen::present(std::uint32_t framebuffer, Nanoseconds now) {
    if (!m_pipe) { // Unplugged while it was drawn.
        m_buffers.release(framebuffer);
        return;
    }
    ++m_frame;
    const bool modeset = m_needsModeset;
    const KmsRequest request = modeset ? modesetOf(framebuffer) : flipOf(framebuffer);
    const int error =
        m_device.commit(request, kNonblocking | DRM_MODE_PAGE_FLIP_EVENT | (modeset ? kModeset : 0), m_frame);
    if (error != 0) {
        m_waiting = framebuffer;
        return refused(error, now);
    }
    m_setsMode = modeset;
    m_needsModeset = false;
    m_flying = framebuffer;
    m_awaited = m_mirror ? 2 : 1;
    m_waiting = 0;
    m_retries = 0;
    m_deadline = now + m_options.flipTimeout;
    enter(SurfaceState::Busy, sentence());
}

void KmsScreen::refused(int error, Nanoseconds now) {
    switch (actionFor(error)) {
    case CommitAction::Retry:
        return retryLater(error, now);
    case CommitAction::WaitForMaster:
        return waitForMaster(now);
    case CommitAction::StepDown:
        if (m_waiting != 0)
            m_buffers.release(std::exchange(m_waiting, 0));
        if (!giveUpMirror())
            ++m_step;
        return configure(now);
    case CommitAction::WaitForDevice:
        m_deviceLost = true;
        m_deadline.reset();
        return enter(SurfaceState::NoScreen, m_device.node() + ": the device is gone");
    }
}

void KmsScreen::retryLater(int error, Nanoseconds now) {
    if (m_retries >= kRetries && giveUpMirror())
        m_retries = 0;
    if (m_retries >= kRetries) {
        if (m_resets > 0 || !m_pipe)
            return fail({"screen.commit", m_device.node(),
                         std::string("the kernel keeps refusing frames: ") + std::strerror(-error),
                         "restart the program; if that does not help, the machine"});
        ++m_resets;
        m_retries = 0;
        switchOff();
    }
    m_deadline = now + kFirstRetry * (1 << m_retries++);
    enter(SurfaceState::Recovering, std::string("the kernel refused a frame: ") + std::strerror(-error));
}

void KmsScreen::flipIsLate(Nanoseconds now) {
    ++m_frame; // Should it come after all, it is not taken for another one.
    m_waiting = std::exchange(m_flying, 0);
    giveUpMirror();
    if (m_resets > 0)
        return fail({"screen.flip-timeout", m_device.node(), "the driver does not answer page flips",
                     "restart the program; if that does not help, the machine"});
    ++m_resets;
    switchOff();
    if (m_pauseWanted || m_updateWanted)
        return settle(now);
    present(m_waiting, now);
}

void KmsScreen::tick(Nanoseconds now) {
    if (!m_deadline || now < *m_deadline)
        return;
    m_deadline.reset();
    if (m_flying != 0)
        return flipIsLate(now);
    if (m_state == SurfaceState::Paused)
        return lookAgain(now);
    if (m_updateWanted || m_blanking != m_applied)
        return settle(now);
    if (m_waiting != 0)
        return present(m_waiting, now);
    if (m_state == SurfaceState::Recovering)
        return lookAgain(now);
    readyOrHeld(now);
}

std::optional<CompletedFrame> KmsScreen::readFlips(Nanoseconds now) {
    std::vector<KmsFlip> flips;
    if (const int error = m_device.readFlips(flips); error != 0) {
        refused(error, now);
        return std::nullopt;
    }
    std::optional<CompletedFrame> completed;
    for (const KmsFlip& flip : flips) {
        if (flip.frame != m_frame || m_flying == 0)
            continue;
        if (!m_mirror || flip.crtc != m_mirror->pipe.crtc.id)
            m_answer = flip;
        if (--m_awaited == 0)
            flipped(completed.emplace());
    }
    if (!completed)
        return completed;
    m_deadline.reset();
    readyOrHeld(now);
    settle(now);
    return completed;
}

void KmsScreen::flipped(CompletedFrame& completed) {
    if (m_shown != 0 && m_shown != m_flying)
        m_buffers.release(m_shown);
    m_shown = std::exchange(m_flying, 0);
    m_resets = 0;
    completed = {m_answer.sequence, m_answer.time.count(), 0};
    // Refreshes are counted anew with a mode, and what its first frame is told of them may be nothing: 0 at 0.
    if (m_due && !m_setsMode && m_answer.sequence > *m_due)
        completed.missed = static_cast<int>(m_answer.sequence - *m_due);
    m_due.reset();
    m_last.reset();
    if (!m_setsMode)
        m_last = completed;
}

Nanoseconds KmsScreen::period() const {
    return Nanoseconds(1'000'000'000'000 / std::max(1, refreshMilliHertz(m_layout.mode.mode)));
}

void KmsScreen::frameBegun(Nanoseconds now) {
    m_due.reset();
    const Nanoseconds since = now - Nanoseconds(m_last ? m_last->nanoseconds : 0);
    if (!m_last || since > kCounted)
        return;
    m_due = m_last->sequence + 1 + static_cast<std::uint64_t>(std::max<std::int64_t>(0, since / period()));
}

void KmsScreen::readyOrHeld(Nanoseconds now) {
    if (m_options.maxFrameRate > 0 && m_last) {
        const double refresh = refreshMilliHertz(m_layout.mode.mode) / 1000.0;
        const auto refreshes = std::max(1L, std::lround(std::ceil(refresh / m_options.maxFrameRate - 0.01)));
        // A little after the refresh before the one that the frame is for.
        const Nanoseconds begin =
            Nanoseconds(m_last->nanoseconds) + (refreshes - 1) * period() + period() / 16;
        if (refreshes > 1 && begin > now) {
            m_deadline = begin;
            return enter(SurfaceState::Busy, sentence());
        }
    }
    enter(SurfaceState::Ready, sentence());
}

void KmsScreen::blank(Blanking blanking, Nanoseconds now) {
    m_blanking = blanking;
    settle(now);
}

void KmsScreen::pause(Nanoseconds now) {
    m_pauseWanted = true;
    settle(now);
}

void KmsScreen::resume(Nanoseconds now) {
    m_pauseWanted = m_paused = false;
    update(now);
}

void KmsScreen::reset(Nanoseconds now) {
    m_resetWanted = true;
    settle(now);
}

void KmsScreen::applyBlanking(Nanoseconds now) {
    if (m_waiting != 0)
        m_buffers.release(std::exchange(m_waiting, 0));
    if (m_blanking == Blanking::None) {
        m_applied = Blanking::None;
        m_needsModeset = true;
        return readyOrHeld(now);
    }
    KmsRequest request = offOf();
    std::uint32_t black = 0;
    if (m_blanking == Blanking::Black && m_device.addBlack(m_layout.mode.buffer, black) == 0)
        request = modesetOf(black);
    if (const int error = m_device.commit(request, kModeset | kNonblocking, 0); error != 0)
        return refused(error, now);
    m_applied = m_blanking;
    m_needsModeset = true;
    m_retries = 0;
    if (m_shown != 0)
        m_buffers.release(std::exchange(m_shown, 0));
    m_deadline.reset();
    enter(SurfaceState::Blanked, m_applied == Blanking::Black ? "black" : "switched off");
}

} // namespace franken::platform
