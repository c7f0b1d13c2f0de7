// SPDX-License-Identifier: MIT
#include "kiosk/kiosk.h"

#include "kiosk/screen.h"

#include <csignal>

namespace kiosk {

namespace platform = franken::platform;
using franken::LogLevel;
using franken::Result;
using platform::SurfaceState;

namespace {

Time seconds(double count) { return std::chrono::duration_cast<Time>(std::chrono::duration<double>(count)); }

/// Where that fails, each write says so.
void makeFolder(const std::string& folder) {
    std::error_code ignored;
    if (!folder.empty())
        std::filesystem::create_directories(folder, ignored);
}

std::filesystem::path manifestOf(const Config& config) {
    return config.files.state.empty() ? std::filesystem::path()
                                      : std::filesystem::path(config.files.state) / "programs.manifest";
}

} // namespace

Kiosk::Kiosk(RunOptions options, Config config, franken::Log log, std::unique_ptr<EventLoop> loop,
             std::unique_ptr<platform::Surface> surface)
    : m_options(std::move(options)),
      m_config(std::move(config)),
      m_log(std::move(log)),
      m_loop(std::move(loop)),
      m_surface(std::move(surface)),
      m_lastFrame(now()) {
    m_content = std::make_unique<Content>(*m_loop, m_log, [this] { contentArrived(); });
    m_frameTimer = m_loop->timer([] {}); // The turn of the loop is all that it is for.
    m_aliveTimer = m_loop->timer([] {});
    m_sources.push_back(m_loop->onReadable(m_surface->descriptor(), [this] { surfaceReadable(); }));
    for (const int number : {SIGTERM, SIGINT})
        m_sources.push_back(m_loop->onSignal(number, [this] { m_ends = true; }));
    m_transition.configure(seconds(m_config.content.fadeSeconds),
                           std::chrono::seconds(m_config.content.seconds));
    m_content->configure(m_config);
}

Result<std::unique_ptr<Kiosk>> Kiosk::open(RunOptions options, Config config, franken::Log log) {
    Result<std::unique_ptr<EventLoop>> loop = EventLoop::make();
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

Result<void> Kiosk::makeStage() {
    const Result<franken::Gl> gl = franken::Gl::load(m_surface->getProcAddress());
    if (!gl)
        return gl.error();
    m_stage = std::make_unique<Stage>(*gl, m_surface->driver(), manifestOf(m_config), m_config, m_log);
    m_stage->setTarget(targetOf(*m_surface), m_surface->srgbTarget());
    m_stage->configure(m_config);
    contentArrived();
    return {};
}

void Kiosk::surfaceReadable() {
    const platform::SurfaceEvents events = m_surface->dispatch();
    if (events.contextReplaced && m_stage) {
        m_stage->renderer().contextLost();
        m_stage.reset();
        m_transition.clear();
    }
    if (events.layoutChanged && m_stage)
        m_stage->setTarget(targetOf(*m_surface), m_surface->srgbTarget());
    m_isStale = m_isStale || events.stateChanged || events.layoutChanged || events.contextReplaced;
    m_ends = m_ends || events.closeRequested;
}

void Kiosk::contentArrived() {
    if (!m_stage)
        return;
    if (std::optional<LoadedModel> model = m_content->take()) {
        const std::filesystem::path path = model->path;
        if (const Result<void> prepared = m_stage->prepare(*std::move(model)); !prepared)
            m_content->refuse(path, prepared.error());
    }
    const Playlist& playlist = m_content->playlist();
    if (m_stage->next() != nullptr && !playlist.contains(m_stage->next()->path))
        m_stage->dropNext();
    const Exhibit* shown = m_stage->shown();
    if (shown != nullptr && !playlist.contains(shown->path))
        m_transition.next();
    if (!m_stage->hasNext() && !m_content->isReading())
        m_content->want(shown != nullptr ? std::optional(shown->path) : std::nullopt);
    m_isStale = true;
}

void Kiosk::changeModels() {
    const Exhibit* shown = m_stage->shown();
    const Result<bool> ready = m_stage->nextIsReady();
    if (!ready) {
        const std::filesystem::path path = m_stage->next()->path;
        m_stage->dropNext();
        m_content->refuse(path, ready.error());
    }
    const bool isAlone = shown != nullptr && m_stage->hasNext() && m_stage->next()->path == shown->path;
    if (!m_transition.advance(now(), ready && *ready, isAlone))
        return;
    if (const Result<void> changed = m_stage->change(); !changed)
        m_log(LogLevel::Error, franken::toString(changed.error()));
    m_log(LogLevel::Info, "shows " + m_stage->shown()->path.string());
    m_stage->keepManifest();
    m_content->want(m_stage->shown()->path);
}

bool Kiosk::wantsFrame() const {
    if (!m_stage || m_isStale || m_stage->hasWork())
        return true;
    const Time end = m_transition.end();
    const bool isFading = m_transition.phase() != Transition::Phase::Showing &&
                          m_transition.phase() != Transition::Phase::Empty;
    return isFading || (m_stage->shown() != nullptr && m_stage->shown()->view.moves()) ||
           (m_stage->hasNext() && m_transition.phase() == Transition::Phase::Empty) ||
           (end.count() != 0 && now() >= end && m_stage->hasNext());
}

Result<void> Kiosk::frameIfDue() {
    if (!wantsFrame()) {
        if (const Time end = m_transition.end(); end > now())
            m_frameTimer->arm(end);
        return {};
    }
    if (now() < m_nextFrame) {
        m_frameTimer->arm(m_nextFrame);
        return {};
    }
    const Result<bool> begun = m_surface->begin();
    if (!begun)
        return begun.error();
    return *begun ? frame() : Result<void>();
}

Result<void> Kiosk::frame() {
    if (!m_stage)
        if (Result<void> made = makeStage(); !made)
            return made;
    const Time time = now();
    // Half a refresh early: a frame that is begun late is shown by the same refresh.
    m_nextFrame = time + seconds(1 / m_config.screen.maxFrameRate) - std::chrono::milliseconds(2);
    const double passed = std::chrono::duration<double>(time - m_lastFrame).count();
    m_lastFrame = time;
    m_isStale = false;
    if (const Result<void> worked = m_stage->work(); !worked)
        m_log(LogLevel::Warning, franken::toString(worked.error()));
    changeModels();
    if (m_stage->shown() != nullptr)
        m_stage->shown()->view.advance(passed);
    if (Result<void> drawn = m_stage->draw(m_transition.cover(time)); !drawn)
        m_log(LogLevel::Error, franken::toString(drawn.error()));
    return m_surface->submit();
}

void Kiosk::reportState() {
    const std::string state(m_surface->state() == SurfaceState::Ready ||
                                    m_surface->state() == SurfaceState::Busy
                                ? "drawing"
                                : platform::toString(m_surface->state()));
    if (state != m_state)
        m_log(LogLevel::Info, state + ": " + m_surface->status());
    m_state = state;
    [[maybe_unused]] const bool isTold =
        m_service.ready(state) && m_service.status(m_surface->status()) && m_service.alive();
    if (const auto interval = m_service.watchdogInterval())
        m_aliveTimer->arm(now() + *interval / 2);
}

Result<void> Kiosk::run() {
    while (!m_ends) {
        if (m_surface->state() == SurfaceState::Failed)
            return m_surface->failure();
        if (Result<void> drawn = frameIfDue(); !drawn)
            return drawn;
        reportState();
        if (Result<void> turned = m_loop->turn(); !turned)
            return turned;
    }
    [[maybe_unused]] const auto told = m_service.stopping();
    if (m_stage)
        m_stage->keepManifest();
    return {};
}

} // namespace kiosk
