// SPDX-License-Identifier: MIT
#include "kiosk/kiosk.h"

#include "franken/crc32.h"
#include "franken/platform/heartbeat.h"
#include "kiosk/screen.h"

#include <algorithm>
#include <csignal>
#include <ctime>
#include <utility>

namespace kiosk {

namespace platform = franken::platform;
using franken::LogLevel;
using franken::Result;
using platform::SurfaceState;

namespace {

constexpr Time kHeartbeat = std::chrono::seconds(10);
// Longer, nothing stands still: another program may have taken the screen, and the GPU is tested by frames.
constexpr Time kLongestStill = std::chrono::minutes(1);
constexpr Time kTick = std::chrono::seconds(1); // How often the GPU and the clock are looked at.
// A restart that is due for a minute must not be done over and over within it.
constexpr Time kLeastUptime = std::chrono::minutes(5);

/// Where that fails, each write says so.
void makeFolder(const std::string& folder) {
    std::error_code ignored;
    if (!folder.empty())
        std::filesystem::create_directories(folder, ignored);
}

std::tm localTime() {
    const std::time_t time = std::time(nullptr);
    std::tm local{};
    tzset(); // The time zone may have been changed.
    localtime_r(&time, &local);
    return local;
}

Result<franken::Image> imageOf(Result<platform::ScreenPicture> picture) {
    if (!picture)
        return picture.error();
    return franken::Image{.name = {},
                          .width = picture->size.width,
                          .height = picture->size.height,
                          .rgba = std::move(picture->rgba)};
}

} // namespace

ReadConfig configOf(const RunOptions& options) {
    ReadConfig read = readConfig(options.config, options.overrides);
    if (!options.models.empty())
        read.config.content.playlist.clear();
    for (const std::string& model : options.models)
        read.config.content.playlist.push_back(std::filesystem::absolute(model).string());
    return read;
}

Kiosk::Kiosk(RunOptions options, Config config, franken::Log log, std::unique_ptr<EventLoop> loop,
             std::unique_ptr<platform::Surface> surface)
    : m_options(std::move(options)),
      m_config(std::move(config)),
      m_log(std::move(log)),
      m_loop(std::move(loop)),
      m_surface(std::move(surface)),
      m_screenshots(m_config.files.state, m_log),
      m_started(now()) {
    m_opening.configure(m_config);
    m_opening.presence.seen(m_started);
    m_show = std::make_unique<Show>(*m_loop, m_config, Machine(m_options.root), m_log,
                                    [this] { m_isStale = true; });
    m_monitor = std::make_unique<Monitor>(
        *m_loop, m_config, Machine(m_options.root),
        Monitor::Handlers{.relieved = [this](const Relief& relief) { m_show->relieve(relief); },
                          .report =
                              [this](Statistics& statistics) {
                                  statistics.frames = m_frameTimes;
                                  statistics.state = m_state;
                                  m_show->report(statistics);
                              }},
        m_log);
    listen();
    openConsole();
    m_controls = std::make_unique<Controls>(*m_loop, m_config, m_surface->rotation(), handlers(), m_log);
}

Result<std::unique_ptr<Kiosk>> Kiosk::open(RunOptions options, Config config, franken::Log log) {
    Result<std::unique_ptr<EventLoop>> loop = EventLoop::make({SIGTERM, SIGINT, SIGHUP, SIGUSR1});
    if (!loop)
        return loop.error();
    makeFolder(config.files.state);
    Result<std::unique_ptr<platform::Surface>> surface =
        platform::create(options.backend, surfaceOptionsOf(config, log));
    if (!surface)
        return surface.error();
    return std::unique_ptr<Kiosk>(new Kiosk(std::move(options), std::move(config), std::move(log),
                                            *std::move(loop), *std::move(surface)));
}

void Kiosk::listen() {
    const auto nothing = [] {}; // These only wake the loop.
    m_frameTimer = m_loop->timer(nothing);
    m_clockTimer = m_loop->timer(nothing);
    m_aliveTimer = m_loop->timer(nothing);
    m_sources.push_back(m_loop->onClockSet(nothing));
    m_sources.push_back(m_loop->onReadable(m_surface->descriptor(), [this] { surfaceReadable(); }));
    for (const int number : {SIGTERM, SIGINT})
        m_sources.push_back(m_loop->onSignal(number, [this] { m_ends = true; }));
    m_sources.push_back(m_loop->onSignal(SIGHUP, [this] { reload(); }));
    m_sources.push_back(m_loop->onSignal(SIGUSR1, [this] { act(Action::Screenshot); }));
    if (m_options.config.empty())
        return;
    m_fileWatch = std::make_unique<FileWatch>(*m_loop, m_options.config, m_log, [this] { reload(); });
}

Controls::Handlers Kiosk::handlers() {
    return {.act = [this](Action action) { act(action); },
            .drag = [this](double x, double y) { m_show->drag(x, y); },
            .zoom = [this](double factor) { m_show->zoom(factor); },
            .touched = [this] { m_opening.presence.seen(now()); },
            .motion = [this](bool motion) { m_opening.presence.setMotion(motion, now()); }};
}

void Kiosk::openConsole() {
    if (m_surface->backend() != platform::Backend::Kms)
        return;
    Result<std::unique_ptr<platform::Console>> console = platform::Console::open();
    if (!console)
        return m_log(LogLevel::Info, "keys may reach a console: " + franken::toString(console.error()));
    m_console = *std::move(console);
    m_sources.push_back(m_loop->onReadable(m_console->descriptor(), [this] { consoleReadable(); }));
}

void Kiosk::consoleReadable() {
    switch (m_console->dispatch()) {
    case platform::Console::Event::Leaving:
        return m_surface->pause();
    case platform::Console::Event::Returned:
        return m_surface->resume();
    case platform::Console::Event::None:
        break;
    }
}

void Kiosk::surfaceReadable() {
    const platform::SurfaceEvents events = m_surface->dispatch();
    if (events.completed) {
        m_watch.completed();
        m_pace.shown(Time(events.completed->nanoseconds));
        m_frameTimes.add(m_frameWork, events.completed->missed);
        if (m_takesScreenshot || m_beats)
            if (std::shared_ptr<platform::HeldPicture> shown = m_surface->holdShown()) // Until it is copied.
                givePicture([shown = std::move(shown)]() mutable {
                    return imageOf(std::exchange(shown, nullptr)->read());
                });
    }
    if (events.contextReplaced) {
        m_show->contextLost();
        m_health.reset();
    }
    if (events.layoutChanged) {
        m_show->layoutChanged(*m_surface);
        m_controls->setScreenRotation(m_surface->rotation());
    }
    if (events.stateChanged && m_console && m_surface->state() == SurfaceState::Paused)
        if (const Result<void> left = m_console->left(); !left)
            m_log(LogLevel::Warning, franken::toString(left.error()));
    m_isStale = m_isStale || events.layoutChanged || events.contextReplaced;
    m_ends = m_ends || events.closeRequested;
}

void Kiosk::reload() {
    const ReadConfig read = configOf(m_options);
    for (const franken::Error& fault : read.faults)
        m_log(LogLevel::Error, franken::toString(fault));
    if (!read.faults.empty())
        return m_log(LogLevel::Error, "the configuration stays as it was");
    for (const std::string& key : needRestart(m_config, read.config))
        m_log(LogLevel::Warning, key + " takes effect after a restart");
    m_config = read.config;
    m_opening.configure(m_config);
    m_show->configure(m_config);
    m_controls->configure(m_config);
    m_monitor->configure(m_config);
    m_isStale = true;
    m_log(LogLevel::Info, "the configuration was read again");
}

void Kiosk::act(Action action) {
    m_log(LogLevel::Info, "asked for: " + std::string(kActions[static_cast<std::size_t>(action)]));
    m_wantsScreenshot = m_wantsScreenshot || action == Action::Screenshot;
    m_show->act(action);
    m_isStale = true;
}

void Kiosk::followClock() {
    const std::tm local = localTime();
    const bool isSynchronised = isClockSynchronised(m_options.root);
    std::string dark = m_opening.darkBecause(now(), local, isSynchronised);
    if (dark.empty() != m_dark.empty()) {
        const platform::Blanking darkness =
            m_config.screen.blanking == "black" ? platform::Blanking::Black : platform::Blanking::Off;
        const Result<void> blanked = m_surface->blank(dark.empty() ? platform::Blanking::None : darkness);
        if (!blanked)
            m_log(LogLevel::Warning, franken::toString(blanked.error()));
        m_log(LogLevel::Info, dark.empty() ? "the screen wakes" : "the screen is dark: " + dark);
        m_isStale = true;
    }
    m_dark = std::move(dark);
    m_clockTimer->arm(m_opening.nextLook(now(), local));
    if (m_opening.isRestartDue(local, isSynchronised) && now() - m_started > kLeastUptime) {
        m_log(LogLevel::Info, "ends for the daily restart");
        m_ends = true;
    }
}

/// When a frame is due although nothing moves.
Time Kiosk::nextByTime() const {
    Time next = std::min(m_show->nextMove(now()), m_lastFrame + kLongestStill);
    if (m_show->showsStatistics())
        next = std::min(next, m_nextStatistics);
    if (!m_config.files.heartbeat.empty())
        next = std::min(next, m_nextHeartbeat);
    return next;
}

Result<void> Kiosk::frameIfDue() {
    if (!m_dark.empty())
        return {};
    const Time next = nextByTime();
    const bool isOutdated = m_isStale || m_surface->wantsFrame() || m_wantsScreenshot;
    if (!isOutdated && !m_show->moves(now()) && next > now()) {
        m_frameTimer->arm(next);
        return {};
    }
    const bool isOnScreen = m_surface->backend() == platform::Backend::Kms;
    m_pace.configure(m_config.screen.maxFrameRate * m_monitor->relief().frameRate(),
                     isOnScreen ? m_surface->refreshMilliHertz() : 0);
    if (const Time begin = m_pace.next(now()); begin > now()) {
        m_frameTimer->arm(begin);
        return {};
    }
    const Result<bool> begun = m_surface->begin();
    if (!begun)
        return begun.error();
    return *begun ? frame() : Result<void>();
}

Result<void> Kiosk::frame() {
    if (!m_show->isOpen()) {
        if (Result<void> opened = m_show->open(*m_surface); !opened)
            return opened;
        m_health = std::make_unique<platform::GpuHealth>(m_surface->getProcAddress());
    }
    const Time begun = now();
    m_pace.begun(begun);
    m_lastFrame = begun;
    if (m_show->showsStatistics() && begun >= m_nextStatistics) {
        m_nextStatistics = begun + kTick;
        m_show->setStatistics(m_monitor->statistics());
    }
    m_isStale = false;
    checkGpu(); // Waits for the GPU, which has nothing to do yet.
    m_show->draw(begun);
    noteCopies();
    m_frameWork = now() - begun;
    m_watch.submitted(begun);
    return m_surface->submit();
}

/// Whether the screen's picture can be read while the next one is drawn. That takes one buffer more.
bool Kiosk::canHold() const {
    return m_surface->backend() == platform::Backend::Kms && m_monitor->relief().mayPreload();
}

/// What is to be made of the frame in the making.
void Kiosk::noteCopies() {
    if (m_wantsScreenshot && !m_screenshots.areBusy()) {
        m_wantsScreenshot = false;
        m_takesScreenshot = true;
    }
    if (!m_config.files.heartbeat.empty() && now() >= m_nextHeartbeat) {
        m_nextHeartbeat = now() + kHeartbeat;
        m_beats = !m_beat.runs();
    }
    if ((m_takesScreenshot || m_beats) && !canHold())
        givePicture(
            [picture = std::make_shared<const Result<franken::Image>>(
                 m_show->stage()->renderer().readPixels(m_show->stage()->target()))] { return *picture; });
}

void Kiosk::givePicture(const PictureSource& picture) {
    if (std::exchange(m_takesScreenshot, false))
        m_screenshots.write(picture);
    if (std::exchange(m_beats, false))
        beat(picture);
}

void Kiosk::beat(const PictureSource& picture) {
    m_beat.start([this, file = m_config.files.heartbeat, frames = m_frameTimes.frames(), picture] {
        const Result<franken::Image> image = picture();
        m_beating.note(image ? platform::writeHeartbeat(
                                   file, frames, platform::crc32(image->rgba.data(), image->rgba.size()))
                             : image.error(),
                       m_log);
    });
}

void Kiosk::checkGpu() {
    if (m_watch.canaryDue(now())) {
        m_watch.canary(m_health->canaryLives());
        m_show->stage()->renderer().invalidateState();
    }
    if (m_watch.errorDue(now()))
        m_watch.error(m_health->takeError());
}

Result<void> Kiosk::obeyWatch() {
    if (m_surface->state() != SurfaceState::Ready && m_surface->state() != SurfaceState::Busy)
        m_watch.idle();
    switch (m_watch.step(now())) {
    case platform::Watch::Step::ResetScreen:
        m_log(LogLevel::Error, m_watch.reason() + ": the screen is reset");
        m_surface->resetScreen();
        break;
    case platform::Watch::Step::Exit:
        return franken::Error{
            "kiosk.gpu", m_surface->status(), m_watch.reason(),
            "the service manager starts the program again, and reboots if that does not help"};
    case platform::Watch::Step::None:
        break;
    }
    return {};
}

void Kiosk::reportState() {
    const std::string state = stateName(m_surface->state());
    if (state != m_state)
        m_log(LogLevel::Info, state + ": " + m_surface->status());
    m_state = state;
    [[maybe_unused]] const bool isTold =
        m_service.ready(state) && m_service.status(m_surface->status()) && m_service.alive();
    const Time watchdog = m_service.watchdogInterval().value_or(std::chrono::seconds(10));
    m_aliveTimer->arm(now() + std::min<Time>(kTick, watchdog / 2));
}

Result<void> Kiosk::run() {
    while (!m_ends) {
        if (m_surface->state() == SurfaceState::Failed)
            return m_surface->failure();
        followClock();
        if (Result<void> drawn = frameIfDue(); !drawn)
            return drawn;
        reportState();
        if (Result<void> fine = obeyWatch(); !fine)
            return fine;
        if (Result<void> turned = m_loop->turn(); !turned)
            return turned;
    }
    [[maybe_unused]] const auto told = m_service.stopping();
    if (m_show->stage() != nullptr)
        m_show->stage()->keepPrograms();
    return {};
}

} // namespace kiosk
