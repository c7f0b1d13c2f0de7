// SPDX-License-Identifier: MIT
#include "session.h"

#include "common/png.h"
#include "common/progress_bar.h"
#include "franken/manifest.h"
#include "loading.h"
#include "setup.h"

#include <algorithm>
#include <cstdio>
#include <iostream>

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

} // namespace

// What someone wrote by hand, or is no manifest at all, is not ours to replace at the end.
std::optional<Failure> Session::readManifest() {
    if (m_listed || m_options.manifest.empty())
        return {};
    Result<std::vector<ProgramUse>> listed = franken::readManifest(m_options.manifest);
    if (!listed && (listed.error().code == "manifest.line" || listed.error().code == "manifest.size"))
        return Failure{listed.error(), ExitCode::Refused};
    if (!listed)
        m_log(LogLevel::Warning, "nothing is warmed up from the manifest: " + toString(listed.error()));
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
        m_log(LogLevel::Warning, "the sky has no sun that could be taken out, or was baked with it");
    return {};
}

std::optional<Failure> Session::readSubject(Subject& subject) {
    if (std::optional<Failure> failure = readSky())
        return failure;
    Result<Scene> scene = loadGltf(m_options.model, modelLimits(m_options), m_log);
    if (!scene)
        return Failure{inShellWords(scene.error()), ExitCode::Refused};
    subject.scene = *std::move(scene);
    if (Result<void> displaced = applyHeights(subject.scene, m_options); !displaced)
        return Failure{displaced.error(), ExitCode::Refused};
    subject.sky = m_sky;
    const Result<Camera> camera = chooseCamera(subject.scene, m_options);
    if (!camera)
        return Failure{camera.error(), ExitCode::Usage};
    subject.camera = *camera;
    Result<Lighting> lighting = chooseLighting(subject.scene, subject.sky.get(), m_options, m_log);
    if (!lighting)
        return Failure{lighting.error(), ExitCode::Usage};
    subject.lighting = *std::move(lighting);
    return {};
}

std::optional<Failure> Session::printPermutations() {
    Subject subject;
    if (std::optional<Failure> failure = readSubject(subject))
        return failure;
    const Result<std::vector<ProgramUse>> needed = usesOf(subject, m_options.look, m_log);
    if (!needed)
        return Failure{needed.error(), ExitCode::Refused};
    std::cout << toManifest(*needed);
    return {};
}

Result<Drawn> Session::drawSubject(const Subject& subject, const std::optional<SnippetSet>& snippets) {
    if (!m_studio) {
        Result<std::unique_ptr<Studio>> studio = Studio::open(m_options, m_log);
        if (!studio)
            return studio.error();
        m_studio = *std::move(studio);
    }
    return m_studio->draw(subject, m_listed.value_or(std::vector<ProgramUse>()), snippets);
}

std::optional<Failure> Session::draw() {
    std::optional<SnippetSet> snippets;
    if (!m_options.snippets.empty()) {
        const Result<SnippetSet> read = SnippetSet::read(m_options.snippets);
        if (!read)
            return Failure{read.error(), ExitCode::Refused};
        snippets = *read;
    }
    if (std::optional<Failure> failure = readManifest())
        return failure;
    Subject subject;
    if (std::optional<Failure> failure = readSubject(subject))
        return failure;
    const Result<Drawn> drawn = drawSubject(subject, snippets);
    if (!drawn)
        return Failure{drawn.error(),
                       drawn.error().code == "surface.options" ? ExitCode::Usage : ExitCode::Device};
    for (const ProgramUse& use : drawn->needed)
        if (std::find(m_needed.begin(), m_needed.end(), use) == m_needed.end())
            m_needed.push_back(use);
    if (const Result<void> written = writePng(m_options.output, drawn->picture); !written)
        return Failure{written.error(), ExitCode::Device};
    if (m_options.stats)
        printStats(*drawn);
    return {};
}

std::optional<Failure> Session::keepManifest() {
    if (m_options.manifest.empty())
        return {};
    if (const Result<void> kept = appendToManifest(m_options.manifest, m_needed); !kept)
        return Failure{kept.error(), ExitCode::Device};
    return {};
}
