// SPDX-License-Identifier: MIT
#include "../backends.h"
#include "gbm_target.h"
#include "nodes.h"
#include "uevents.h"

namespace franken::platform {

namespace {

using namespace std::chrono_literals;

/// A node that is there but cannot be used yet (udevd has not set its rights) is tried again so often.
constexpr Nanoseconds kOpenAgain = 1s;

bool isSoftware(const std::string& driver) {
    for (const char* name : {"llvmpipe", "softpipe", "swrast", "Software Rasterizer"})
        if (driver.find(name) != std::string::npos)
            return true;
    return false;
}

class KmsSurface final : public Surface {
public:
    explicit KmsSurface(const SurfaceOptions& options) : Surface(Backend::Kms, {}), m_options(options) {
        m_hasContext = false;
        watch(m_poll, m_timer.get());
        if (m_uevents)
            watch(m_poll, m_uevents.get());
    }
    ~KmsSurface() override { close(); }

    /// Success without a context where there is no device yet.
    Result<void> open();

    GetProcAddress getProcAddress() const override { return eglFunction; }
    int descriptor() const override { return m_poll.get(); }
    SurfaceEvents dispatch() override;
    std::shared_ptr<HeldPicture> holdShown() override {
        return m_screen ? m_target->hold(m_screen->shown()) : nullptr;
    }
    Result<void> blank(Blanking blanking) override;
    void pause() override;
    void resume() override;
    void resetScreen() override;

protected:
    Result<void> finishFrame() override;
    void frameBegun() override;
    Result<void> bind() override;
    void unbind() override {
        if (m_target)
            m_target->unbind();
    }

private:
    void close();
    Result<void> openContext();
    void openLater(const std::string& why);
    bool isElsewhere() const;
    void reopen();
    void takeOver();

    SurfaceOptions m_options;
    FileDescriptor m_poll = makePoll(), m_timer = makeTimer(), m_uevents = openUevents();
    std::unique_ptr<KmsDevice> m_device;
    std::unique_ptr<GbmTarget> m_target;
    std::unique_ptr<KmsScreen> m_screen;
    int m_layoutSeen = 0, m_drawnFor = 0, m_contexts = 0;
    Blanking m_blanking = Blanking::None;
    bool m_paused = false;
};

void KmsSurface::close() {
    letGo();
    m_hasContext = false;
    m_screen.reset();
    m_target.reset();
    m_device.reset();
}

Result<void> KmsSurface::open() {
    Result<std::unique_ptr<KmsDevice>> device = findKmsDevice(m_options.screen);
    if (!device)
        return device.error();
    if (!*device) {
        openLater(m_options.screen.devices + ": no device has this output yet");
        return {};
    }
    m_device = *std::move(device);
    if (!m_device->isMaster() && m_device->setMaster() != 0) {
        const std::string holders = holdersOf(m_device->node());
        return Error{"screen.busy", m_device->node(),
                     "another process is the screen's master" + (holders.empty() ? "" : ": " + holders),
                     "end it, or start from a console of your own"};
    }
    watch(m_poll, m_device->descriptor());
    return openContext();
}

Result<void> KmsSurface::openContext() {
    Result<std::unique_ptr<GbmTarget>> target =
        GbmTarget::open(*m_device, m_options.depthBits, m_options.samples);
    if (!target)
        return target.error();
    m_target = *std::move(target);
    if (Result<void> ready = makeReady(); !ready)
        return ready;
    if (isSoftware(m_driver) && !m_options.screen.allowSoftware)
        return Error{"surface.software", m_driver, "the screen would be drawn by the CPU",
                     "put the user into the group render; or allow software rendering"};
    using GetInteger = void (*)(unsigned, int*);
    constexpr unsigned kMaxTextureSize = 0x0D33; // As in any GL header.
    int extent = 2048;
    if (const auto getInteger = reinterpret_cast<GetInteger>(eglFunction("glGetIntegerv")))
        getInteger(kMaxTextureSize, &extent);
    m_screen = std::make_unique<KmsScreen>(*m_device, *m_target, m_options.screen, extent, m_options.log);
    m_hasContext = true;
    ++m_contexts;
    m_layoutSeen = 0;
    m_screen->blank(m_blanking, monotonicNow());
    m_screen->update(monotonicNow());
    takeOver();
    return {};
}

void KmsSurface::openLater(const std::string& why) {
    close();
    if (m_options.log && why != m_status)
        m_options.log(LogLevel::Warning, why);
    m_state = SurfaceState::NoScreen;
    m_status = why;
    arm(m_timer, monotonicNow() + kOpenAgain);
}

/// Whether another node has the screen that this one lacks.
bool KmsSurface::isElsewhere() const {
    if (m_screen->state() != SurfaceState::NoScreen)
        return false;
    const Result<std::vector<ScreenInfo>> screens = listScreens(m_options.screen.devices);
    if (!screens || screens->empty())
        return false;
    for (const ScreenInfo& screen : *screens)
        if (screen.connection != Connection::Disconnected && screen.node != m_device->node() &&
            (m_options.screen.output.empty() || screen.output == m_options.screen.output) &&
            (m_options.screen.driver.empty() || screen.driver == m_options.screen.driver))
            return true;
    return false;
}

void KmsSurface::reopen() {
    close();
    if (Result<void> opened = open(); !opened)
        openLater(toString(opened.error()));
}

/// What the screen says becomes what this surface says.
void KmsSurface::takeOver() {
    m_state = m_screen->state();
    m_status = m_screen->status();
    m_wantsFrame = m_screen->wantsFrame() || m_target->wantsFrame();
    m_failure = m_screen->failure();
    arm(m_timer, m_screen->deadline());
    if (m_screen->layoutCount() == 0)
        return;
    const KmsLayout& layout = m_screen->layout();
    m_size = layout.mode.buffer;
    m_rotation = layout.rotation;
    m_format = layout.format.format;
    m_refreshMilliHertz = platform::refreshMilliHertz(layout.mode.mode);
    m_samples = m_target->samples();
}

SurfaceEvents KmsSurface::dispatch() {
    SurfaceEvents events;
    const SurfaceState before = m_state;
    const int contexts = m_contexts;
    const bool changed = readScreenUevents(m_uevents);
    drain(m_timer);
    const Nanoseconds now = monotonicNow();
    if (m_screen) {
        events.completed = m_screen->readFlips(now);
        m_screen->tick(now);
        if (changed)
            m_screen->update(now);
        if (m_screen->deviceLost() || (changed && isElsewhere()))
            reopen();
    } else if (!m_paused) {
        reopen();
    }
    if (m_screen) {
        takeOver();
        events.layoutChanged =
            m_screen->layoutCount() != std::exchange(m_layoutSeen, m_screen->layoutCount());
    }
    events.contextReplaced = m_contexts != contexts;
    events.stateChanged = m_state != before;
    return events;
}

void KmsSurface::frameBegun() {
    m_drawnFor = m_target->generation();
    m_screen->frameBegun(monotonicNow());
}

Result<void> KmsSurface::finishFrame() {
    if (!m_screen || m_drawnFor != m_target->generation())
        return {}; // The target that it was drawn to is gone; the next one is announced.
    const Result<std::uint32_t> framebuffer = m_target->swap();
    if (!framebuffer)
        return framebuffer.error();
    m_screen->present(*framebuffer, monotonicNow());
    takeOver();
    return {};
}

Result<void> KmsSurface::bind() {
    if (!m_target)
        return Error{"surface.state", m_status, "there is no context yet", "wait until hasContext()"};
    return m_target->bind();
}

Result<void> KmsSurface::blank(Blanking blanking) {
    m_blanking = blanking;
    if (m_screen) {
        m_screen->blank(blanking, monotonicNow());
        takeOver();
    }
    return {};
}

void KmsSurface::pause() {
    m_paused = true;
    if (m_screen) {
        m_screen->pause(monotonicNow());
        takeOver();
    }
}

void KmsSurface::resume() {
    m_paused = false;
    if (m_screen) {
        m_screen->resume(monotonicNow());
        takeOver();
    }
}

void KmsSurface::resetScreen() {
    if (m_screen) {
        m_screen->reset(monotonicNow());
        takeOver();
    }
}

} // namespace

Result<std::unique_ptr<Surface>> createKms(const SurfaceOptions& options) {
    auto surface = std::make_unique<KmsSurface>(options);
    if (Result<void> opened = surface->open(); !opened)
        return opened.error();
    return std::unique_ptr<Surface>(std::move(surface));
}

} // namespace franken::platform
