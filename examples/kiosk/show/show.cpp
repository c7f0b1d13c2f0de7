// SPDX-License-Identifier: MIT
#include "kiosk/show/show.h"

#include "franken/printable.h"
#include "kiosk/screen.h"

#include <algorithm>

namespace kiosk {

namespace platform = franken::platform;
using franken::LogLevel;
using franken::Result;

namespace {

constexpr double kExposureStep = 1.25;
constexpr double kMostExposure = 16;

std::filesystem::path manifestOf(const Config& config) {
    return config.files.state.empty() ? std::filesystem::path()
                                      : std::filesystem::path(config.files.state) / "programs.manifest";
}

} // namespace

Show::Show(EventLoop& loop, const Config& config, Machine machine, franken::Log log,
           EventLoop::Handler changed)
    : m_config(config),
      m_machine(std::move(machine)),
      m_log(std::move(log)),
      m_changed(std::move(changed)),
      m_skyReader([](const auto& path, const auto&) { return readSky(path); }),
      m_captions(config.show.caption),
      m_statistics(config.show.statistics) {
    m_content = std::make_unique<Content>(loop, m_log, [this] { contentArrived(); });
    m_skySource = loop.onReadable(m_skyReader.descriptor(), [this] { skyArrived(); });
    m_transition.configure(toTime(config.content.fadeSeconds), std::chrono::seconds(config.content.seconds));
    m_content->configure(config);
    requestSky();
}

void Show::requestSky() {
    m_sky.reset();
    if (!m_config.show.sky.empty())
        return m_skyReader.request(m_config.show.sky);
    m_skyReader.cancel();
    if (m_stage)
        m_stage->setSky(nullptr);
}

void Show::skyArrived() {
    const std::optional<Result<Sky>> sky = m_skyReader.take();
    if (!sky)
        return;
    if (*sky)
        m_sky = **sky;
    else
        m_log(LogLevel::Error, "the sky: " + franken::toString(sky->error()));
    if (m_stage)
        m_stage->setSky(m_sky);
    m_changed();
}

void Show::configure(const Config& config) {
    m_captions = config.show.caption;
    m_statistics = config.show.statistics;
    const bool isOtherSky = config.show.sky != m_config.show.sky;
    m_config = config;
    m_transition.configure(toTime(config.content.fadeSeconds), std::chrono::seconds(config.content.seconds));
    if (m_stage)
        m_stage->configure(config);
    m_content->configure(config);
    if (isOtherSky)
        requestSky();
    contentArrived();
}

Result<void> Show::open(const platform::Surface& surface) {
    const Result<franken::Gl> gl = franken::Gl::load(surface.getProcAddress());
    if (!gl)
        return gl.error();
    m_stage = std::make_unique<Stage>(*gl, surface.driver(), manifestOf(m_config), m_config, m_log);
    m_stage->renderer().memory().setBudget(memoryBudget(m_config.content.memoryMebibytes, m_machine));
    m_stage->setTarget(targetOf(surface), surface.srgbTarget());
    m_stage->configure(m_config);
    m_stage->setControls(m_lights);
    m_stage->setResolution(m_resolution);
    if (m_sky)
        m_stage->setSky(m_sky);
    contentArrived();
    return {};
}

void Show::contextLost() {
    if (m_stage)
        m_stage->contextLost();
    m_stage.reset();
    m_transition.clear();
    m_before.reset();
    m_content->cancel();
}

void Show::layoutChanged(const platform::Surface& surface) {
    if (m_stage)
        m_stage->setTarget(targetOf(surface), surface.srgbTarget());
}

void Show::wantNext(int direction) {
    m_direction = direction;
    const Exhibit* shown = m_stage->shown();
    m_content->want(shown != nullptr ? std::optional(shown->path) : m_before, direction);
    if (shown != nullptr || m_content->isReading() || !m_before)
        return;
    m_before.reset(); // The only whole model is the one that was shown last.
    m_content->want({}, direction);
}

/// A shop that removes a model does not want to see it any longer, even if there is no other one.
void Show::leaveIfGone() {
    const Exhibit* shown = m_stage->shown();
    if (shown != nullptr && !m_content->playlist().contains(shown->path) &&
        !m_content->following(shown->path))
        m_transition.leave();
}

void Show::showNothing() {
    m_log(LogLevel::Info, "shows nothing: there is no model");
    m_stage->clear();
    m_before.reset();
    contentArrived();
}

void Show::contentArrived() {
    if (!m_stage)
        return;
    if (std::optional<LoadedModel> model = m_content->take()) {
        const std::filesystem::path path = model->path;
        if (const Result<void> prepared = m_stage->prepare(*std::move(model)); !prepared)
            m_content->refuse(path, prepared.error());
    }
    const Exhibit* shown = m_stage->shown();
    const std::optional<std::filesystem::path> path = shown != nullptr ? shown->path : m_before;
    if (shown != nullptr && (!m_content->playlist().contains(*path) || m_content->isReplaced(*path)))
        m_transition.next();
    leaveIfGone();
    const Exhibit* next = m_stage->next();
    const bool isStale =
        next != nullptr && (!m_content->playlist().contains(next->path) || m_content->isReplaced(next->path));
    // The shown model follows itself only where its file was replaced.
    const bool isSurpassed =
        m_direction > 0 && next != nullptr && path != next->path && m_content->following(path) != next->path;
    if (isStale || isSurpassed)
        m_stage->dropNext();
    if (!m_stage->hasNext() && !m_content->isReading() && (m_mayPreload || shown == nullptr))
        wantNext();
    m_changed();
}

void Show::makeRoom(Time now) {
    const bool isOver = m_transition.end().count() != 0 && now >= m_transition.end();
    if (m_mayPreload || !isOver || m_stage->hasNext() || m_content->isReading() ||
        !m_content->following(m_before))
        return;
    wantNext();
    m_stage->clear();
    m_transition.clear();
}

void Show::change(Time now) {
    const Result<bool> ready = m_stage->nextIsReady();
    if (!ready) {
        const std::filesystem::path path = m_stage->next()->path;
        m_stage->dropNext();
        m_content->refuse(path, ready.error());
    }
    if (!m_transition.advance(now, ready && *ready)) {
        if (m_transition.phase() == Transition::Phase::Empty && m_stage->shown() != nullptr)
            showNothing();
        return;
    }
    if (const Result<void> changed = m_stage->change(); !changed)
        m_log(LogLevel::Error, franken::toString(changed.error()));
    m_log(LogLevel::Info, "shows " + franken::printable(m_stage->shown()->path.string()));
    ++m_modelsShown;
    m_before = m_stage->shown()->path;
    m_stage->shown()->view.setPaused(m_paused);
    m_stage->keepPrograms();
    if (m_mayPreload)
        wantNext();
}

bool Show::moves(Time now) const {
    if (!m_stage || m_stage->hasWork())
        return true;
    const Time end = m_transition.end();
    const Transition::Phase phase = m_transition.phase();
    const bool isFading = phase == Transition::Phase::FadingIn || phase == Transition::Phase::FadingOut;
    const bool isDue = end.count() != 0 && now >= end &&
                       (m_stage->hasNext() || (!m_mayPreload && m_content->following(m_before)));
    const bool isFilling = m_stage->shown() == nullptr && m_content->isReading(); // The bar.
    const bool wanders = !m_stage->labels().areEmpty() && wander(now, m_config.show.pixelShift) != m_shift;
    return isFading || isDue || isFilling || wanders || m_transition.leaves() ||
           (m_stage->hasNext() && (phase == Transition::Phase::Empty || m_transition.isAsked())) ||
           (m_stage->shown() != nullptr && m_stage->shown()->view.moves());
}

Time Show::nextMove(Time now) const {
    if (!m_stage)
        return Time::max();
    const Time end = m_transition.end();
    const Time change = end > now ? end : Time::max();
    const bool canWander = m_config.show.pixelShift > 0 && !m_stage->labels().areEmpty();
    return canWander ? std::min(change, nextWander(now)) : change;
}

void Show::draw(Time now) {
    const double passed = m_last.count() == 0 ? 0 : std::chrono::duration<double>(now - m_last).count();
    m_last = now;
    m_working.note(m_stage->work(), m_log);
    change(now);
    makeRoom(now);
    if (m_stage->shown() != nullptr)
        m_stage->shown()->view.advance(passed);
    const bool isLoading = m_stage->shown() == nullptr && (m_content->isReading() || m_stage->hasNext());
    if (!isLoading)
        m_loaded = 0;
    label(isLoading);
    m_shift = wander(now, m_config.show.pixelShift);
    m_drawing.note(
        m_stage->draw(m_transition.cover(now), isLoading ? std::optional(loaded()) : std::nullopt, m_shift),
        m_log);
}

/// Reading is one half of it, programs are the other; more of these may turn out to be needed.
double Show::loaded() {
    const double read = m_stage->hasNext() ? 1 : static_cast<double>(m_content->progress());
    m_loaded = std::max(m_loaded, (read + m_stage->warmedUp()) / 2);
    return m_loaded;
}

void Show::label(bool isLoading) {
    const Exhibit* shown = m_stage->shown();
    Labels& labels = m_stage->labels();
    labels.setCaption(m_captions && shown != nullptr ? shown->caption : "");
    const bool isEmpty = shown == nullptr && !isLoading;
    labels.setNotice(isLoading ? kLoadingNotice : isEmpty ? "No model is there that can be shown" : "");
    if (!m_statistics)
        labels.setStatistics({});
}

void Show::setStatistics(const Statistics& statistics) {
    if (m_stage)
        m_stage->labels().setStatistics(toLines(statistics));
    m_changed();
}

void Show::act(Action action) {
    if (!m_stage)
        return;
    Exhibit* shown = m_stage->shown();
    if (action == Action::Next || action == Action::Previous) {
        const int direction = action == Action::Next ? 1 : -1;
        m_transition.next();
        if (direction != m_direction || (!m_stage->hasNext() && !m_content->isReading())) {
            m_stage->dropNext();
            wantNext(direction);
        }
    }
    if (action == Action::Pause)
        m_paused = !m_paused;
    if (action == Action::Caption)
        m_captions = !m_captions;
    if (action == Action::Statistics)
        m_statistics = !m_statistics;
    if (action == Action::Lights)
        m_lights.suns = !m_lights.suns;
    if (action == Action::Brighter || action == Action::Darker)
        m_lights.exposure =
            std::clamp(m_lights.exposure * (action == Action::Brighter ? kExposureStep : 1 / kExposureStep),
                       1 / kMostExposure, kMostExposure);
    if (shown != nullptr) {
        shown->view.setPaused(m_paused);
        if (action == Action::NextCamera)
            shown->view.nextCamera();
    }
    m_stage->setControls(m_lights);
    m_changed();
}

void Show::drag(double x, double y) {
    if (m_stage && m_stage->shown() != nullptr)
        m_stage->shown()->view.drag(x * franken::aspectOf(m_stage->target()), y);
    m_changed();
}

void Show::zoom(double factor) {
    if (m_stage && m_stage->shown() != nullptr)
        m_stage->shown()->view.zoom(factor);
    m_changed();
}

void Show::relieve(const Relief& relief) {
    m_mayPreload = relief.mayPreload();
    m_resolution = relief.resolution();
    if (m_stage)
        m_stage->setResolution(m_resolution);
    if (!m_mayPreload && m_stage && m_stage->shown() != nullptr) {
        m_stage->dropNext();
        m_content->cancel();
    }
    contentArrived();
}

void Show::report(Statistics& statistics) const {
    statistics.models = m_content->playlist().models().size();
    statistics.modelsBroken = m_content->playlist().broken().size();
    statistics.modelsShown = m_modelsShown;
    if (m_stage)
        m_stage->report(statistics);
}

} // namespace kiosk
