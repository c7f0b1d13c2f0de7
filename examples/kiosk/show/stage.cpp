// SPDX-License-Identifier: MIT
#include "kiosk/show/stage.h"

#include "franken/gltf.h"
#include "kiosk/config/checks.h"

#include <algorithm>
#include <array>

namespace kiosk {

using franken::LogLevel;
using franken::ProgramUse;
using franken::Result;

namespace {

constexpr auto kSlice = std::chrono::microseconds(2000); // Of each frame, for uploads.

bool contains(const std::vector<ProgramUse>& uses, const ProgramUse& use) {
    return std::find(uses.begin(), uses.end(), use) != uses.end();
}

franken::SceneSource sourceOf(const std::filesystem::path& path) {
    return [path] {
        return franken::loadGltf(path, {.images = franken::ImageForm::Encoded, .progress = {}, .cancel = {}});
    };
}

} // namespace

Stage::Stage(const franken::Gl& gl, const std::string& driver, std::filesystem::path manifest,
             const Config& config, franken::Log log)
    : m_log(std::move(log)),
      m_driver(driver),
      m_programs(std::move(manifest), m_log),
      m_config(config),
      m_renderer(gl, m_log),
      m_canvas(gl, m_renderer),
      m_labels(m_renderer, config.show.font, m_log) {
    if (const auto sheet = addWhite(m_renderer))
        m_sheet = *sheet;
    m_unwarmed = m_programs.read();
    m_warmed.reserve(m_unwarmed.size());
}

void Stage::configure(const Config& config) {
    m_config = config;
    const Result<franken::Float3> background = parseColor(config.show.background);
    for (std::size_t i = 0; i < 3; ++i)
        m_target.background[i] = std::min((*background)[i], 1.0f);
    for (Exhibit* exhibit : {m_shown.get(), m_next.get()})
        if (exhibit != nullptr)
            exhibit->view.configure(config);
    light();
}

void Stage::contextLost() {
    m_canvas.contextLost();
    m_renderer.contextLost();
}

void Stage::setSky(Sky sky) {
    m_sky = std::move(sky);
    const bool hasBox = m_sky && m_sky->skybox.size > 0;
    for (const Result<void>& set : {m_renderer.setSkybox(hasBox ? &m_sky->skybox : nullptr),
                                    m_renderer.setReflection(m_sky ? &m_sky->reflection : nullptr)})
        if (!set)
            m_log(LogLevel::Error, "the sky: " + franken::toString(set.error()));
    light();
}

void Stage::setControls(const LightControls& controls) {
    m_controls = controls;
    light();
}

void Stage::setTarget(const franken::DrawTarget& target, bool srgbTarget) {
    const franken::Float3 background = m_target.background;
    m_target = target;
    m_target.background = background;
    m_srgbTarget = srgbTarget;
    for (Exhibit* exhibit : {m_shown.get(), m_next.get()})
        if (exhibit != nullptr)
            exhibit->view.setAspect(franken::aspectOf(m_target));
    light();
}

void Stage::light() {
    m_look = lookFor(m_config, m_driver, m_target.bits[0] < 8, m_srgbTarget);
    m_renderer.setLook(m_look);
    if (m_shown)
        m_renderer.setLighting(lightingFor(m_shown->view.still(), m_config, m_sky.get(), m_controls));
}

void Stage::warm(const std::vector<ProgramUse>& uses) {
    for (const ProgramUse& use : uses)
        if (!contains(m_warmed, use) && !contains(m_unwarmed, use)) {
            m_unwarmed.push_back(use);
            m_programs.add(use);
        }
}

double Stage::warmedUp() const {
    const std::size_t all = m_warmed.size() + m_unwarmed.size();
    return all == 0 ? 0 : static_cast<double>(m_warmed.size()) / static_cast<double>(all);
}

Result<void> Stage::prepare(LoadedModel model) {
    dropNext();
    franken::Scene& scene = *model.scene;
    const auto lighting = lightingFor(scene, m_config, m_sky.get(), m_controls);
    Result<std::vector<ProgramUse>> uses = franken::usesOf(scene, lighting, m_look);
    if (!uses)
        return uses.error();
    for (const auto& use :
         {franken::overlayUse(m_look), m_sky ? franken::skyboxUse(m_look) : franken::overlayUse(m_look)})
        if (use)
            uses->push_back(*use);
    View view(std::move(model.still), model.swept, franken::aspectOf(m_target), m_config);
    const Result<franken::ModelId> id = m_renderer.addInSteps(std::move(scene), sourceOf(model.path));
    if (!id)
        return id.error();
    const Result<franken::PlaceId> place = m_renderer.firstPlace(*id);
    if (!place)
        return place.error();
    warm(*uses);
    m_next = std::make_unique<Exhibit>(
        Exhibit{model.path, std::move(model.caption), *id, *place, std::move(view), *std::move(uses)});
    m_isLoading = true;
    return {};
}

void Stage::dropNext() {
    if (m_next)
        m_renderer.remove(m_next->id);
    m_next.reset();
}

Result<bool> Stage::nextIsReady() {
    if (!m_next)
        return false;
    const Result<bool> resident = m_renderer.isResident(m_next->id);
    if (!resident)
        return resident.error();
    return *resident && m_unwarmed.empty();
}

Result<void> Stage::change() {
    const std::unique_ptr<Exhibit> before = std::exchange(m_shown, std::move(m_next));
    light();
    const std::array<franken::ModelId, 1> models{m_shown->id};
    Result<void> shown = m_renderer.show(models);
    if (before)
        m_renderer.remove(before->id);
    return shown;
}

void Stage::clear() {
    [[maybe_unused]] const auto shown = m_renderer.show({});
    if (m_shown)
        m_renderer.remove(m_shown->id);
    m_shown.reset();
}

Result<void> Stage::work() {
    if (!m_unwarmed.empty()) {
        const std::array<ProgramUse, 1> use{m_unwarmed.back()};
        m_unwarmed.pop_back();
        m_warmed.push_back(use[0]);
        const Result<franken::WarmUpReport> warmed = m_renderer.warmUp(m_target, use);
        return warmed ? Result<void>() : warmed.error();
    }
    const Result<franken::StepReport> step = m_renderer.step(kSlice);
    m_isLoading = step && step->more;
    return step ? Result<void>() : step.error();
}

Result<void> Stage::drawModel() {
    franken::Viewpoint viewpoint;
    if (m_shown) {
        if (const franken::Pose* pose = m_shown->view.pose())
            if (Result<void> posed = m_renderer.setPose(m_shown->place, *pose); !posed)
                return posed;
        viewpoint = franken::viewpointOf(m_shown->view.camera(), franken::aspectOf(m_target));
    }
    if (m_resolution >= 1) {
        m_canvas.release();
        return m_renderer.draw(viewpoint, m_target);
    }
    const Result<franken::DrawTarget> small = m_canvas.targetFor(m_target, m_resolution);
    if (!small)
        return m_renderer.draw(viewpoint, m_target).and_then([&] { return Result<void>(small.error()); });
    if (Result<void> drawn = m_renderer.draw(viewpoint, *small); !drawn)
        return drawn;
    const franken::OverlayQuad quad = m_canvas.quad(m_target);
    return m_renderer.drawOverlay({&quad, 1}, m_target);
}

Result<void> Stage::draw(double cover, std::optional<double> loaded, Shift shift) {
    const Result<void> drawn = drawModel();
    return drawn ? drawOver(cover, loaded, shift) : drawn;
}

Result<void> Stage::drawOver(double cover, std::optional<double> loaded, Shift shift) {
    const franken::OverlayRect area = viewerArea(m_target);
    const float width = area.width, height = area.height;
    const franken::Float3& back = m_target.background;
    std::vector<franken::OverlayQuad> quads;
    if (cover > 0)
        quads.push_back({.picture = m_sheet,
                         .place = area,
                         .color = {back[0], back[1], back[2], static_cast<float>(cover)}});
    if (loaded) {
        const franken::OverlayRect bar{0.3f * width, 0.5f * height, 0.4f * width,
                                       std::max(2.0f, 0.008f * height)};
        franken::OverlayRect done = bar;
        done.width *= static_cast<float>(*loaded);
        quads.push_back({.picture = m_sheet, .place = bar, .color = {1, 1, 1, 0.15f}});
        quads.push_back({.picture = m_sheet, .place = done, .color = {1, 1, 1, 0.7f}});
    }
    const Result<void> drawn = quads.empty() ? Result<void>() : m_renderer.drawOverlay(quads, m_target);
    return drawn ? m_labels.draw(m_target, cover, shift) : drawn;
}

void Stage::keepPrograms() {
    for (const ProgramUse& use : m_renderer.takeMisses())
        m_programs.add(use);
    m_programs.keep();
}

void Stage::report(Statistics& statistics) {
    statistics.programs = m_renderer.programCounters().links;
    statistics.compiles = m_renderer.programCounters().compiles;
    statistics.fallbacks = m_renderer.fallbacks().size();
    statistics.gpuBytes = static_cast<double>(m_renderer.memory().used());
    statistics.gpuBudgetBytes = static_cast<double>(m_renderer.memory().budget());
}

} // namespace kiosk
