// SPDX-License-Identifier: MIT
#include "session.h"

#include "common/progress_bar.h"
#include "franken/exposure.h"
#include "franken/manifest.h"
#include "franken/png.h"
#include "franken/ray_through.h"
#include "franken/snippet_folder.h"
#include "franken/variants.h"
#include "list.h"
#include "loading.h"
#include "measure.h"
#include "picture.h"
#include "pricing.h"
#include "setup.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <numbers>
#include <utility>

using namespace franken;

namespace {

void printStats(const Drawn& drawn) {
    const WarmUpReport& warmUp = drawn.warmUp;
    std::printf("warm-up: %u shaders compiled, %u programs linked, %zu draws, %zu failed, %.1f ms\n",
                drawn.warm.compiles - drawn.before.compiles, drawn.warm.links - drawn.before.links,
                warmUp.draws, warmUp.failed, warmUp.milliseconds);
    std::printf("frame: %u shaders compiled, %u programs linked, %zu primitives drawn, %zu out of view\n",
                drawn.after.compiles - drawn.warm.compiles, drawn.after.links - drawn.warm.links,
                drawn.frame.drawn, drawn.frame.culled);
    std::printf("memory: %.1f MiB of textures and meshes\n", static_cast<double>(drawn.gpuBytes) / (1 << 20));
    std::fflush(stdout);
}

Error nothingToDraw(const Options& options) {
    return {
        "viewer.nothing", options.model.string(), "the model holds nothing that can be drawn",
        "see the warnings, where there are any, or whether its scene has a node with a mesh of triangles"};
}

} // namespace

std::optional<Failure> Session::readSnippets() {
    std::optional<SnippetSet> snippets;
    if (!m_options.snippets.empty()) {
        const Result<SnippetSet> read = franken::readSnippets(m_options.snippets);
        if (!read)
            return Failure{read.error(), ExitCode::Refused};
        snippets = *read;
    }
    if (!m_options.effect.empty()) {
        const Result<Effect> effect = readEffect(m_options.effect);
        if (!effect)
            return Failure{effect.error(), ExitCode::Refused};
        const Result<SnippetSet> with = snippets.value_or(SnippetSet::builtIn()).with(*effect);
        if (!with)
            return Failure{with.error(), ExitCode::Refused};
        snippets = *with;
    }
    m_snippets = std::move(snippets);
    return {};
}

// What someone wrote by hand, or is no manifest at all, is not ours to replace at the end.
std::optional<Failure> Session::readManifest() {
    if (m_listed || m_options.manifest.empty())
        return {};
    Result<std::vector<ProgramUse>> listed = franken::readManifest(m_options.manifest, snippets(), m_log);
    if (!listed && (listed.error().code == "manifest.line" || listed.error().code == "manifest.size"))
        return Failure{listed.error(), ExitCode::Refused};
    if (!listed)
        m_log(LogLevel::Warning, "the manifest is not used for the warm-up: " + toString(listed.error()));
    m_listed = listed ? *std::move(listed) : std::vector<ProgramUse>();
    return {};
}

std::optional<Failure> Session::readSky() {
    FileTimes times = skyTimes(m_options);
    if (m_options.skybox.empty() || (m_sky && times == m_skyTimes))
        return {};
    ProgressBar bar("filtering the sky");
    Result<BakedSky> sky = loadSky(m_options.skybox, {.sun = m_options.skySun,
                                                      .progress = [&bar](float share) { bar.show(share); },
                                                      .limits = skyLimits(m_options)});
    if (!sky)
        return Failure{inShellWords(sky.error()), ExitCode::Refused};
    m_sky = std::make_shared<const BakedSky>(*std::move(sky));
    m_skyTimes = std::move(times);
    if (m_options.skySun && !m_sky->sun)
        m_log(LogLevel::Warning, "the sky has no sun that could be taken out, or was baked without --sun");
    return {};
}

/// The scene and the camera.
std::optional<Failure> Session::readModel(Subject& subject) {
    Result<Scene> scene = loadGltf(m_options.model, modelLimits(m_options), m_log);
    if (!scene)
        return Failure{inShellWords(scene.error()), ExitCode::Refused};
    subject.scene = *std::move(scene);
    if (const Result<void> checked = checkOutputs(m_options, subject.scene.files); !checked)
        return Failure{checked.error(), ExitCode::Usage};
    if (!m_options.variant.empty())
        if (Result<void> chosen = applyVariant(subject.scene, m_options.variant); !chosen)
            return Failure{chosen.error(), ExitCode::Usage};
    if (Result<void> displaced = applyHeights(subject.scene, m_options); !displaced)
        return Failure{displaced.error(), ExitCode::Refused};
    if (Result<void> posed = applyAnimation(subject.scene, m_options); !posed)
        return Failure{posed.error(), ExitCode::Usage};
    if (subject.scene.instances.empty())
        return Failure{nothingToDraw(m_options), ExitCode::Refused};
    const Result<Camera> camera = chooseCamera(subject.scene, m_options);
    if (!camera)
        return Failure{camera.error(), ExitCode::Usage};
    subject.camera = *camera;
    return {};
}

std::optional<Failure> Session::readSubject(Subject& subject) {
    if (std::optional<Failure> failure = readSky())
        return failure;
    if (std::optional<Failure> failure = readModel(subject))
        return failure;
    subject.sky = m_sky;
    if (subject.sky)
        if (const std::string notice = skyboxNotice(subject.sky->skybox, subject.camera, m_options.size);
            !notice.empty())
            m_log(LogLevel::Warning, notice);
    Result<Lighting> lighting = chooseLighting(subject.scene, subject.sky.get(), m_options, m_log);
    if (!lighting)
        return Failure{lighting.error(), ExitCode::Usage};
    subject.lighting = *std::move(lighting);
    return {};
}

std::optional<Failure> Session::printList() {
    const Result<Scene> scene = loadGltf(m_options.model, modelLimits(m_options), m_log);
    if (!scene)
        return Failure{inShellWords(scene.error()), ExitCode::Refused};
    std::cout << listOf(*scene);
    return {};
}

std::optional<Failure> Session::printPick() {
    Subject subject;
    if (std::optional<Failure> failure = readModel(subject))
        return failure;
    const DrawTarget target{.width = m_options.size.width, .height = m_options.size.height};
    const auto& [x, y] = *m_options.pick;
    const Viewpoint viewpoint = viewpointOf(subject, aspectOf(target));
    const Result<std::optional<Hit>> hit =
        rayThrough(viewpoint, target, x + 0.5, y + 0.5).and_then([&](const Ray& ray) {
            return pick(subject.scene, ray);
        });
    if (!hit)
        return Failure{hit.error(), ExitCode::Refused};
    std::cout << listOf(subject.scene, *hit);
    return {};
}

std::optional<Failure> Session::printPermutations() {
    if (std::optional<Failure> failure = readSnippets())
        return failure;
    Subject subject;
    if (std::optional<Failure> failure = readSubject(subject))
        return failure;
    Look look = m_options.look;
    look.effect = effectOf(m_snippets);
    const Result<std::vector<ProgramUse>> needed = usesOf(subject, look, m_log);
    if (!needed)
        return Failure{needed.error(), ExitCode::Refused};
    std::cout << toManifest(*needed, snippets());
    return {};
}

Result<Drawn> Session::drawSubject(const Subject& subject) {
    if (!m_studio) {
        Result<std::unique_ptr<Studio>> studio = Studio::open(m_options, m_log);
        if (!studio)
            return studio.error();
        m_studio = *std::move(studio);
    }
    return m_studio->draw(subject, m_listed.value_or(std::vector<ProgramUse>()), m_snippets);
}

// A picture from which nothing can be seen is drawn all the same, or better where that is known, and says so.
Result<Drawn> Session::drawVisibly(Subject& subject) {
    Result<Drawn> drawn = drawSubject(subject);
    if (!drawn || subject.sky)
        return drawn;
    const Coverage coverage = coverageOf(drawn->picture, m_options.background);
    if (coverage.shown == 0)
        m_log(
            LogLevel::Warning,
            drawn->frame.drawn == 0
                ? "the picture shows nothing of the model, which lies outside the camera's view"
                : "the picture shows nothing of the model: it faces away, is transparent, has the colour of "
                  "the background, or too little light, which --exposure auto makes up for");
    const float exposure = autoExposure(subject.lighting, subject.scene.bounds());
    if (m_options.exposure || m_options.autoExposure || 2 * coverage.white <= coverage.shown || exposure >= 1)
        return drawn;
    const float given = std::exchange(subject.lighting.exposure, exposure);
    Result<Drawn> exposed = drawSubject(subject);
    if (!exposed || coverageOf(exposed->picture, m_options.background).white >= coverage.white) {
        subject.lighting.exposure = given;
        return drawSubject(subject); // So that further pictures are lit alike.
    }
    m_log(LogLevel::Warning,
          "over half of what the picture shows would be white: it is drawn with --exposure auto, "
          "which is " +
              std::to_string(exposure) +
              " here; --exposure 1 leaves the lights as the "
              "file has them");
    return exposed;
}

std::optional<Failure> Session::draw() {
    if (std::optional<Failure> failure = readSnippets())
        return failure;
    if (std::optional<Failure> failure = readManifest())
        return failure;
    Subject subject;
    if (std::optional<Failure> failure = readSubject(subject))
        return failure;
    OrbitCamera orbit(subject.camera, subject.scene.bounds());
    if (m_options.turntable > 0)
        subject.camera = orbit.camera();
    const Result<Drawn> drawn = drawVisibly(subject);
    if (!drawn)
        return Failure{drawn.error(),
                       drawn.error().code == "surface.options" ? ExitCode::Usage : ExitCode::Device};
    for (const ProgramUse& use : drawn->needed)
        if (std::find(m_needed.begin(), m_needed.end(), use) == m_needed.end())
            m_needed.push_back(use);
    if (std::optional<Failure> failure = keep(drawn->picture, 0))
        return failure;
    if (std::optional<Failure> failure = drawTurned(subject, orbit))
        return failure;
    if (std::optional<Failure> failure = drawFrames(subject))
        return failure;
    if (m_options.stats)
        printStats(*drawn);
    return m_options.price.empty() ? std::nullopt : printPrice(subject);
}

std::optional<Failure> Session::printPrice(const Subject& subject) {
    const Result<price::FramePrice> price =
        priceOf(subject, m_options, m_studio->look(m_snippets), snippets(), m_studio->target());
    if (!price)
        return Failure{price.error(), ExitCode::Device};
    std::cout << (m_options.json ? toJson(*price, snippets()) : toText(*price, snippets())) << std::flush;
    if (!m_options.measure)
        return {};
    const Result<Measured> measured = m_studio->measure(subject);
    if (!measured)
        return Failure{measured.error(), ExitCode::Device};
    std::cout << comparisonOf(*measured, price->bills[price->asked]) << std::flush;
    return {};
}

std::optional<Failure> Session::keep(const Image& picture, int number) {
    const int count = std::max(m_options.frames, m_options.turntable);
    if (m_options.strip && number == 0) {
        m_strip = {.name = "", .width = count * picture.width, .height = picture.height, .rgba = {}};
        m_strip.rgba.resize(picture.rgba.size() * static_cast<std::size_t>(count));
    }
    if (m_options.strip)
        paste(picture, number * picture.width, m_strip);
    if (m_options.strip && number + 1 < count)
        return {};
    const Result<void> written = writePng(outputOf(m_options, number), m_options.strip ? m_strip : picture);
    return written ? std::nullopt : std::optional(Failure{written.error(), ExitCode::Device});
}

// The pictures of an animation after the first one, in the same exposure.
std::optional<Failure> Session::drawFrames(Subject& subject) {
    for (int number = 1; number < m_options.frames; ++number) {
        if (const Result<void> posed = applyFrame(subject.scene, subject.camera, m_options, number); !posed)
            return Failure{posed.error(), ExitCode::Refused};
        Result<Lighting> lighting = chooseLighting(subject.scene, subject.sky.get(), m_options, {});
        if (!lighting)
            return Failure{lighting.error(), ExitCode::Usage};
        lighting->exposure = subject.lighting.exposure;
        subject.lighting = *std::move(lighting);
        const Result<Drawn> drawn = drawSubject(subject);
        if (!drawn)
            return Failure{drawn.error(), ExitCode::Device};
        if (std::optional<Failure> failure = keep(drawn->picture, number))
            return failure;
    }
    return {};
}

// The pictures all around after the first one.
std::optional<Failure> Session::drawTurned(Subject& subject, OrbitCamera& orbit) {
    const double step = 2 * std::numbers::pi / std::max(m_options.turntable, 1);
    for (int number = 1; number < m_options.turntable; ++number) {
        Orbit next = orbit.goal();
        next.yaw += step;
        const Result<bool> turned = orbit.moveTo(next).and_then([&] { return orbit.advance(0); });
        if (!turned)
            return Failure{turned.error(), ExitCode::Refused};
        subject.camera = orbit.camera();
        const Result<Image> picture = m_studio->drawAgain(subject);
        if (!picture)
            return Failure{picture.error(), ExitCode::Device};
        if (std::optional<Failure> failure = keep(*picture, number))
            return failure;
    }
    return {};
}

std::optional<Failure> Session::keepManifest() {
    if (m_options.manifest.empty())
        return {};
    if (const Result<void> kept = appendToManifest(m_options.manifest, m_needed, snippets()); !kept)
        return Failure{kept.error(), ExitCode::Device};
    return {};
}
