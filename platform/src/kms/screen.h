// SPDX-License-Identifier: MIT
#pragma once

#include "../descriptor.h"
#include "franken/log.h"
#include "franken/platform/surface.h"
#include "request.h"

namespace franken::platform {

/// Who makes the buffers that a screen shows.
class KmsBuffers {
public:
    virtual ~KmsBuffers() = default;

    /// A buffer as the target's would be, kept until the next call. A negative errno where there can be none.
    virtual int tryBuffer(Size size, const FormatChoice& format, KmsBuffer& buffer) = 0;
    /// Replaces the target by one whose buffers are like that one.
    virtual Result<void> makeTarget(const KmsBuffer& like, PixelFormat format) = 0;
    /// The framebuffer is not shown any more: it can be drawn to again.
    virtual void release(std::uint32_t framebuffer) = 0;
};

/// A second screen that shows the buffers of the first.
struct KmsMirror {
    KmsPipe pipe;
    KmsLayout layout;
    std::uint32_t modeBlob = 0;
};

/// One screen of a device, whatever may happen to it: what is shown, what is on its way, what is waited for.
/// Nothing here waits or looks at a clock: times are handed in, and deadline() says when tick() is due.
class KmsScreen {
public:
    /// `maxExtent`: what the GPU can render. Becomes master of the device, where it is free.
    KmsScreen(KmsDevice& device, KmsBuffers& buffers, const ScreenOptions& options, int maxExtent, Log log);
    ~KmsScreen();
    KmsScreen(const KmsScreen&) = delete;
    KmsScreen& operator=(const KmsScreen&) = delete;

    /// Looks at the connectors again: at the start, and when the kernel says that something changed.
    void update(Nanoseconds now);
    void frameBegun(Nanoseconds now);
    /// Shows it. It is released when another one is shown, or the target is replaced.
    void present(std::uint32_t framebuffer, Nanoseconds now);
    /// When the device's descriptor is readable.
    std::optional<CompletedFrame> readFlips(Nanoseconds now);
    /// When deadline() has come.
    void tick(Nanoseconds now);
    std::optional<Nanoseconds> deadline() const { return m_deadline; }

    void blank(Blanking blanking, Nanoseconds now);
    void pause(Nanoseconds now);
    void resume(Nanoseconds now);
    void reset(Nanoseconds now);

    SurfaceState state() const { return m_state; }
    const std::string& status() const { return m_status; }
    const Error& failure() const { return m_failure; }
    /// The device is gone: only another KmsScreen on another KmsDevice can go on.
    bool deviceLost() const { return m_deviceLost; }
    /// No frame of this screen's is shown, or on its way or waiting to be.
    bool wantsFrame() const { return m_flying == 0 && m_waiting == 0 && (m_shown == 0 || m_needsModeset); }
    /// The framebuffer that is scanned out; 0: none of KmsBuffers.
    std::uint32_t shown() const { return m_shown; }
    /// The current one, and how often it was another before.
    const KmsLayout& layout() const { return m_layout; }
    int layoutCount() const { return m_layoutCount; }

private:
    void enter(SurfaceState state, std::string status);
    void fail(Error error);
    void waitForMaster(Nanoseconds now);
    void lookAgain(Nanoseconds now);
    void settle(Nanoseconds now);
    void configure(Nanoseconds now);
    /// Falls from choice to choice until TEST_ONLY says yes; false where it entered another state.
    bool chooseLayout(const KmsResources& resources, const KmsPipe& pipe, Nanoseconds now);
    int tryLayout(const KmsResources& resources, const KmsPipe& pipe, const KmsLayout& layout,
                  KmsBuffer& buffer);
    bool adopt(const KmsPipe& pipe, const KmsLayout& layout, const KmsBuffer& buffer);
    /// The mirror that TEST_ONLY takes beside that request, if any; else m_mirrorLack says why.
    std::optional<KmsMirror> findMirror(const KmsResources& resources, const KmsPipe& pipe,
                                        const KmsLayout& layout, const KmsRequest& request,
                                        std::uint32_t framebuffer);
    void adoptMirror(std::optional<KmsMirror> mirror);
    /// Goes on without it until something is plugged; false where there was none.
    bool giveUpMirror();
    KmsRequest modesetOf(std::uint32_t framebuffer) const;
    KmsRequest flipOf(std::uint32_t framebuffer) const;
    KmsRequest offOf() const;
    void switchOff();
    std::string sentence() const;
    void refused(int error, Nanoseconds now);
    void retryLater(int error, Nanoseconds now);
    void applyBlanking(Nanoseconds now);
    void flipped(CompletedFrame& completed);
    void flipIsLate(Nanoseconds now);
    Nanoseconds period() const;
    void readyOrHeld(Nanoseconds now);

    KmsDevice& m_device;
    KmsBuffers& m_buffers;
    ScreenOptions m_options, m_mirrorOptions; ///< Margins are the first screen's alone.
    int m_maxExtent;
    Log m_log;

    SurfaceState m_state = SurfaceState::NoScreen;
    std::string m_status;
    Error m_failure;
    std::optional<Nanoseconds> m_deadline;
    bool m_deviceLost = false;

    KmsResources m_resources;
    std::optional<KmsPipe> m_pipe;
    KmsLayout m_layout;
    int m_layoutCount = 0;
    std::size_t m_step = 0; ///< Of the choices: those before were refused.
    std::uint32_t m_modeBlob = 0;
    bool m_needsModeset = true;
    std::optional<KmsMirror> m_mirror;
    bool m_mirrorRefused = false;
    std::string m_mirrorLack; ///< Why there is none, although one is asked for.

    std::uint32_t m_shown = 0, m_flying = 0,
                  m_waiting = 0; ///< Framebuffers; m_waiting was refused and is tried again.
    std::uint64_t m_frame = 0;   ///< The number of the last commit.
    KmsFlip m_answer = {};       ///< Of the first screen to the last commit.
    int m_awaited = 0;           ///< Screens that have not answered it.
    int m_retries = 0, m_resets = 0;

    // What is done as soon as no flip is on its way.
    bool m_updateWanted = false, m_pauseWanted = false, m_resetWanted = false;
    bool m_paused = false; ///< By pause(): only resume() ends it.
    Blanking m_blanking = Blanking::None, m_applied = Blanking::None;

    bool m_setsMode = false; ///< The last commit.
    std::optional<CompletedFrame> m_last;
    std::optional<std::uint64_t> m_due; ///< The sequence that the frame in the making is due at.
};

} // namespace franken::platform
