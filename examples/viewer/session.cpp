// SPDX-License-Identifier: MIT
#include "session.h"

#include "common/png.h"
#include "common/progress_bar.h"
#include "franken/gltf.h"
#include "setup.h"

#include <iostream>

using namespace franken;

std::optional<Failure> Session::readSky() {
    if (m_sky || m_options.skybox.empty())
        return {};
    ProgressBar bar("filtering the sky");
    Result<BakedSky> sky = loadSky(
        m_options.skybox, {.sun = m_options.skySun, .progress = [&bar](float share) { bar.show(share); }});
    if (!sky)
        return Failure{sky.error(), ExitCode::Refused};
    m_sky = *std::move(sky);
    if (m_options.skySun && !m_sky->sun)
        m_log(LogLevel::Warning, "the sky has no sun that could be taken out, or was baked with it");
    return {};
}

std::optional<Failure> Session::readSubject(Subject& subject) {
    if (std::optional<Failure> failure = readSky())
        return failure;
    Result<Scene> scene = loadGltf(m_options.model, {}, m_log);
    if (!scene)
        return Failure{scene.error(), ExitCode::Refused};
    subject.scene = *std::move(scene);
    if (Result<void> displaced = applyHeights(subject.scene, m_options); !displaced)
        return Failure{displaced.error(), ExitCode::Refused};
    subject.sky = m_sky;
    const Result<Camera> camera = chooseCamera(subject.scene, m_options);
    if (!camera)
        return Failure{camera.error(), ExitCode::Usage};
    subject.camera = *camera;
    Result<Lighting> lighting = chooseLighting(subject.scene, subject.sky, m_options, m_log);
    if (!lighting)
        return Failure{lighting.error(), ExitCode::Usage};
    subject.lighting = *std::move(lighting);
    return {};
}

std::optional<Failure> Session::printPermutations() {
    Subject subject;
    if (std::optional<Failure> failure = readSubject(subject))
        return failure;
    const Result<std::vector<Permutation>> needed = permutationsFor(subject, m_options.look, m_log);
    if (!needed)
        return Failure{needed.error(), ExitCode::Refused};
    for (const Permutation& permutation : *needed)
        std::cout << toName(permutation) << "\n";
    return {};
}

std::optional<Failure> Session::draw() {
    std::optional<SnippetSet> snippets;
    if (!m_options.snippets.empty()) {
        const Result<SnippetSet> read = SnippetSet::read(m_options.snippets);
        if (!read)
            return Failure{read.error(), ExitCode::Refused};
        snippets = *read;
    }
    Subject subject;
    if (std::optional<Failure> failure = readSubject(subject))
        return failure;
    const Result<Image> picture = drawPicture(subject, m_options, snippets, m_log);
    if (!picture)
        return Failure{picture.error(),
                       picture.error().code == "surface.options" ? ExitCode::Usage : ExitCode::Device};
    if (const Result<void> written = replacePng(m_options.output, *picture); !written)
        return Failure{written.error(), ExitCode::Device};
    return {};
}
