// SPDX-License-Identifier: MIT
#include "franken/renderer.h"

#include "read_pixels.h"
#include "renderer_state.h"

#include <chrono>
#include <optional>

namespace franken {
Renderer::Renderer(const Gl& gl, Log log) : Renderer(gl, Capabilities::query(gl), std::move(log)) {}

Renderer::Renderer(const Gl& gl, const Capabilities& capabilities, Log log)
    : m_state([&] {
          const KeptState kept(gl);
          return std::make_unique<State>(gl, capabilities, std::move(log));
      }()) {
    invalidateState();
}

Renderer::~Renderer() = default;

Result<ModelId> Renderer::add(const Scene& scene, SceneSource source) {
    return m_state->call("add()", [&] { return m_state->models.add(scene, std::move(source)); });
}

Result<ModelId> Renderer::addInSteps(Scene scene, SceneSource source) {
    return m_state->note("addInSteps()",
                         [&] { return m_state->models.addInSteps(std::move(scene), std::move(source)); });
}

Result<void> Renderer::show(std::span<const ModelId> models, Wait wait) {
    return m_state->call("show()", [&] { return m_state->models.show(models, wait); });
}

Result<bool> Renderer::isResident(ModelId model) const {
    return m_state->note("isResident()", [&] { return m_state->models.isResident(model); });
}

Result<StepReport> Renderer::step(std::chrono::microseconds budget) {
    return m_state->call("step()", [&]() -> Result<StepReport> {
        const auto begin = std::chrono::steady_clock::now();
        const auto hasTime = [&] { // Of any budget: a sum with the longest would overflow.
            return std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() -
                                                                         begin) < budget;
        };
        StepReport total;
        do {
            if (Result<void> done = m_state->stepOnce(total); !done)
                return done.error();
        } while (total.more && !m_state->models.isWaiting() && hasTime());
        return total;
    });
}

void Renderer::remove(ModelId model) { m_state->models.remove(model); }

Result<PlaceId> Renderer::addPlace(ModelId model, const glm::dmat4& world) {
    return m_state->note("addPlace()", [&] { return m_state->models.addPlace(model, world); });
}

Result<PlaceId> Renderer::firstPlace(ModelId model) const {
    return m_state->note("firstPlace()", [&] { return m_state->models.firstPlace(model); });
}

void Renderer::removePlace(PlaceId place) { m_state->models.removePlace(place); }

Result<void> Renderer::setWorld(PlaceId place, const glm::dmat4& world) {
    return m_state->note("setWorld()", [&] { return m_state->models.setWorld(place, world); });
}

Result<void> Renderer::setPose(PlaceId place, const Pose& pose) {
    return m_state->note("setPose()", [&] { return m_state->models.setPose(place, pose); });
}

Result<void> Renderer::setVisible(PlaceId place, bool visible) {
    return m_state->note("setVisible()", [&] { return m_state->models.setVisible(place, visible); });
}

Result<void> Renderer::setVariant(ModelId model, std::string_view name) {
    return m_state->note("setVariant()", [&] { return m_state->models.setVariant(model, name); });
}

Result<void> Renderer::setVariant(PlaceId place, std::string_view name) {
    return m_state->note("setVariant()", [&] { return m_state->models.setVariant(place, name); });
}

Result<void> Renderer::setMaterial(ModelId model, int material, const Material& values) {
    return m_state->note("setMaterial()",
                         [&] { return m_state->models.setMaterial(model, material, values); });
}

Result<Material> Renderer::materialOf(ModelId model, int material) const {
    return m_state->note("materialOf()", [&] { return m_state->models.materialOf(model, material); });
}

Result<void> Renderer::setTexture(ModelId model, int texture, const Image& image, PictureSource source) {
    const auto set = [&] { return m_state->models.setTexture(model, texture, image, std::move(source)); };
    return m_state->call("setTexture()", set);
}

Result<ModelNames> Renderer::namesOf(ModelId model) const {
    return m_state->note("namesOf()", [&] { return m_state->models.namesOf(model); });
}

Result<void> Renderer::setPickTree(ModelId model, std::optional<PickTree> tree) {
    return m_state->note("setPickTree()",
                         [&] { return m_state->models.setPickTree(model, std::move(tree)); });
}

Result<std::optional<PlaceHit>> Renderer::pick(const Ray& ray) const {
    return m_state->note("pick()", [&] { return m_state->models.pick(ray); });
}

Result<void> Renderer::load(const Scene& scene, SceneSource source) {
    return m_state->call("load()", [&] { return m_state->models.load(scene, std::move(source)); });
}

Result<void> Renderer::setSkybox(const SkyboxMap* cube, SkyboxSource source) {
    m_state->frame.forgetPrograms();
    return m_state->call("setSkybox()", [&] { return m_state->skybox.set(cube, std::move(source)); });
}

Result<void> Renderer::setReflection(const ReflectionMaps* maps, ReflectionSource source) {
    return m_state->call("setReflection()", [&] { return m_state->reflection.set(maps, std::move(source)); });
}

void Renderer::setLighting(const Lighting& lighting) {
    State& state = *m_state;
    state.lightingError = check(lighting);
    if (!state.lightingError)
        return;
    const std::string fitting = fittingOf(lighting);
    if (!fitting.empty() && fitting != state.saidOfLights && state.device.log)
        state.device.log(LogLevel::Warning, fitting);
    if (!fitting.empty())
        state.saidOfLights = fitting;
    fitting.empty() ? state.frame.setLighting(lighting) : state.frame.setLighting(fittedLighting(lighting));
}

void Renderer::setLook(const Look& look) { m_state->setLook(look); }

void Renderer::setSnippets(const SnippetSet& snippets) {
    m_state->programs.manager.setSnippets(snippets);
    m_state->frame.forgetPrograms();
    m_state->overlay.forgetProgram();
}

const SnippetSet& Renderer::snippets() const { return m_state->programs.manager.snippets(); }

Result<void> Renderer::setEffectValues(std::span<const Float4> values) {
    return m_state->note("setEffectValues()", [&]() -> Result<void> {
        const Result<EffectBlock> block = effectBlock(values);
        if (!block)
            return block.error();
        m_state->frame.setEffectValues(*block);
        return {};
    });
}

Result<void> Renderer::setEffectValues(PlaceId place, std::span<const Float4> values) {
    return m_state->note("setEffectValues()", [&] { return m_state->models.setEffectValues(place, values); });
}

Result<void> Renderer::prepare() {
    return m_state->call("prepare()", [&]() -> Result<void> {
        if (!m_state->lightingError)
            return m_state->lightingError;
        return m_state->frame.resolvePrograms(nullptr);
    });
}

Result<WarmUpReport> Renderer::warmUp(const DrawTarget& target, std::span<const ProgramUse> uses,
                                      const WarmUpProgress& progress) {
    return m_state->call("warmUp()", [&]() -> Result<WarmUpReport> {
        if (Result<void> checked = check(target); !checked)
            return checked.error();
        Result<WarmUpReport> report =
            m_state->programs.manager.warmUp(m_state->asHere(uses), target, progress);
        m_state->device.state.invalidate();
        return report;
    });
}

void Renderer::setCompileBudget(unsigned programsPerFrame) {
    m_state->programs.manager.setBudget(programsPerFrame);
}

std::vector<ProgramUse> Renderer::takeMisses() { return m_state->programs.manager.takeMisses(); }

const std::vector<Fallback>& Renderer::fallbacks() const { return m_state->programs.manager.fallbacks(); }

const ProgramCounters& Renderer::programCounters() const { return m_state->programs.manager.counters(); }

Result<void> Renderer::draw(const Viewpoint& viewpoint, const DrawTarget& target) {
    State& state = *m_state;
    return state.call("draw()", [&]() -> Result<void> {
        if (Result<void> checked = check(target); !checked)
            return checked;
        if (Result<void> checked = check(viewpoint); !checked)
            return checked;
        state.device.frameBegan = ++state.device.clock;
        state.programs.manager.resetBudget();
        state.models.setAnisotropy(state.anisotropy());
        Result<void> resolved = state.frame.resolvePrograms(&target);
        if (!resolved && resolved.error().code == franken::contextLost().code)
            return resolved;
        Result<void> drawn = state.frame.draw(viewpoint, target);
        if (!drawn && resolved)
            resolved = std::move(drawn);
        return state.lightingError ? resolved : state.lightingError;
    });
}

Result<PictureId> Renderer::addPicture(const Image& picture, PictureSource source) {
    return m_state->call("addPicture()", [&] { return m_state->pictures.add(picture, std::move(source)); });
}

Result<void> Renderer::updatePicture(PictureId picture, const Image& image, int x, int y) {
    return m_state->call("updatePicture()", [&] { return m_state->pictures.update(picture, image, x, y); });
}

Result<PictureId> Renderer::addApplicationTexture(unsigned texture) {
    return m_state->call("addApplicationTexture()",
                         [&] { return m_state->pictures.addOfApplication(texture); });
}

Result<void> Renderer::setApplicationTexture(PictureId picture, unsigned texture) {
    return m_state->call("setApplicationTexture()",
                         [&] { return m_state->pictures.setOfApplication(picture, texture); });
}

void Renderer::removePicture(PictureId picture) { m_state->pictures.remove(picture); }

Result<void> Renderer::drawOverlay(std::span<const OverlayQuad> quads, const DrawTarget& target) {
    return m_state->call("drawOverlay()", [&]() -> Result<void> {
        if (Result<void> checked = check(target); !checked)
            return checked;
        if (Result<void> checked = check(quads); !checked)
            return checked;
        if (quads.empty())
            return {};
        if (Result<void> prepared = m_state->pictures.prepare(quads); !prepared)
            return prepared;
        return m_state->overlay.draw(quads, m_state->pictures, m_state->frame.look(), target);
    });
}

void Renderer::invalidateState() {
    m_state->device.state.invalidate();
    m_state->programs.manager.invalidateState();
}

Result<void> Renderer::acquireState() {
    invalidateState();
    return m_state->call("acquireState()", [&]() -> Result<void> {
        m_state->foreign = SavedState::of(m_state->device.gl);
        m_state->foreign->takeOver(m_state->device.gl);
        return {};
    });
}

Result<void> Renderer::releaseState() {
    return m_state->call("releaseState()", [&]() -> Result<void> {
        if (!m_state->foreign)
            return Error{"renderer.state", "", "there is no state to go back to",
                         "call acquireState() before the renderer draws"};
        m_state->foreign->restore(m_state->device.gl);
        m_state->foreign.reset();
        invalidateState();
        return {};
    });
}

Result<Image> Renderer::readPixels(const DrawTarget& target) {
    return m_state->call("readPixels()", [&]() -> Result<Image> {
        if (Result<void> checked = check(target); !checked)
            return checked.error();
        return franken::readPixels(m_state->device.gl, target);
    });
}

void Renderer::contextLost() { m_state->lost(); }

Result<void> Renderer::restore(const Gl& gl) { return restore(gl, Capabilities::query(gl)); }

Result<void> Renderer::restore(const Gl& gl, const Capabilities& capabilities) {
    Result<void> restored = guarded("restore()", [&] {
        const KeptState kept(gl);
        return m_state->restore(gl, capabilities);
    });
    invalidateState();
    if (!restored && restored.error().code == franken::contextLost().code)
        m_state->lost();
    return restored;
}

GpuMemory& Renderer::memory() { return m_state->device.memory; }

FrameCounters Renderer::frameCounters() const { return m_state->frame.counters(); }

} // namespace franken
