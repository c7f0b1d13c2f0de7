// SPDX-License-Identifier: MIT
#include "studio.h"

#include "common/progress_bar.h"
#include "picture.h"

using namespace franken;

namespace {

const SkyboxMap* skyboxOf(const Subject& subject) {
    return subject.sky && subject.sky->skybox.size > 0 ? &subject.sky->skybox : nullptr;
}

} // namespace

Result<std::vector<ProgramUse>> usesOf(const Subject& subject, const Look& look, const Log& log) {
    Result<std::vector<ProgramUse>> uses = franken::usesOf(subject.scene, subject.lighting, look, log);
    if (!uses || !skyboxOf(subject))
        return uses;
    const Result<ProgramUse> skybox = skyboxUse(look);
    if (!skybox)
        return skybox.error();
    uses->push_back(*skybox);
    return uses;
}

Viewpoint viewpointOf(const Subject& subject, double aspect) {
    return franken::viewpointOf(tightened(subject.camera, subject.scene.bounds()), aspect);
}

Result<std::unique_ptr<Studio>> Studio::open(const Options& options, const Log& log) {
    const int scale = options.supersample ? 2 : 1;
    Result<std::unique_ptr<platform::Surface>> surface = platform::create(
        options.backend, {.size = {options.size.width * scale, options.size.height * scale}, .log = log});
    if (!surface)
        return surface.error();
    const Result<Gl> gl = Gl::load((*surface)->getProcAddress());
    if (!gl)
        return gl.error();
    return std::unique_ptr<Studio>(new Studio(options, *std::move(surface), *gl, log));
}

EffectChoice effectOf(const std::optional<SnippetSet>& snippets) {
    return snippets && !snippets->effects().empty() ? snippets->effects().front().choice(1) : EffectChoice();
}

Result<void> Studio::useSnippets(const SnippetSet& snippets, std::span<const ProgramUse> needed) {
    ProgramCache trial(m_gl);
    trial.setSnippets(snippets);
    for (const ProgramUse& use : needed)
        if (const Result<ProgramHandle> program = trial.get(use.permutation); !program)
            return program.error();
    m_renderer.setSnippets(snippets);
    m_renderer.invalidateState();
    return {};
}

Result<void> Studio::show(const Subject& subject) {
    if (Result<void> loaded = m_renderer.load(subject.scene); !loaded)
        return loaded;
    if (subject.sky != m_sky) {
        if (Result<void> shown = m_renderer.setSkybox(skyboxOf(subject)); !shown)
            return shown;
        if (Result<void> reflected =
                m_renderer.setReflection(subject.sky ? &subject.sky->reflection : nullptr);
            !reflected)
            return reflected;
        m_sky = subject.sky;
    }
    m_renderer.setLighting(subject.lighting);
    return {};
}

Result<WarmUpReport> Studio::warmUp(const DrawTarget& target, std::span<const ProgramUse> needed,
                                    std::span<const ProgramUse> listed) {
    std::vector<ProgramUse> uses(needed.begin(), needed.end());
    uses.insert(uses.end(), listed.begin(), listed.end());
    ProgressBar bar("making programs");
    return m_renderer.warmUp(target, uses, [&bar](std::size_t done, std::size_t total) {
        bar.show(static_cast<float>(done) / static_cast<float>(total));
    });
}

DrawTarget Studio::target() const {
    return {.framebuffer = m_surface->framebuffer(),
            .width = m_surface->size().width,
            .height = m_surface->size().height,
            .background = m_options.background};
}

Look Studio::look(const std::optional<SnippetSet>& snippets) const {
    Look look = m_options.look;
    look.srgbTarget = m_surface->srgbTarget();
    look.effect = effectOf(snippets);
    return look;
}

Result<Measured> Studio::measure(const Subject& subject) {
    const Viewpoint viewpoint = viewpointOf(subject, aspectOf(target()));
    return timeFrames(m_gl, [&] { return m_renderer.draw(viewpoint, target()); });
}

Result<Image> Studio::drawAgain(const Subject& subject) {
    if (Result<void> drawn = m_renderer.draw(viewpointOf(subject, aspectOf(target())), target()); !drawn)
        return drawn.error();
    Result<Image> picture = m_renderer.readPixels(target());
    return m_options.supersample ? std::move(picture).transform(halved) : picture;
}

Result<Drawn> Studio::draw(const Subject& subject, std::span<const ProgramUse> listed,
                           const std::optional<SnippetSet>& snippets) {
    const Look look = this->look(snippets);
    Result<std::vector<ProgramUse>> needed = usesOf(subject, look, {});
    if (!needed)
        return needed.error();
    Drawn drawn;
    drawn.needed = *std::move(needed);
    drawn.before = m_renderer.programCounters();
    if (snippets)
        if (Result<void> used = useSnippets(*snippets, drawn.needed); !used)
            return used.error();
    if (Result<void> shown = show(subject); !shown)
        return shown.error();
    m_renderer.setLook(look);
    if (Result<void> set = m_renderer.setEffectValues(m_options.effectValues); !set)
        return set.error();
    const Result<WarmUpReport> warm = warmUp(target(), drawn.needed, listed);
    if (!warm)
        return warm.error();
    drawn.warmUp = *warm;
    drawn.warm = m_renderer.programCounters();
    Result<Image> picture = drawAgain(subject);
    if (!picture)
        return picture.error();
    drawn.picture = *std::move(picture);
    drawn.after = m_renderer.programCounters();
    drawn.frame = m_renderer.frameCounters();
    drawn.gpuBytes = m_renderer.memory().used();
    const std::vector<ProgramUse> misses = m_renderer.takeMisses();
    drawn.needed.insert(drawn.needed.end(), misses.begin(), misses.end());
    return drawn;
}
