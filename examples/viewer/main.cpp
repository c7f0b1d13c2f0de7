// SPDX-License-Identifier: MIT
#include "common/png.h"
#include "common/progress_bar.h"
#include "franken/gltf.h"
#include "picture.h"
#include "setup.h"

#include <iostream>

using namespace franken;

namespace {

ExitCode fail(const Error& error, ExitCode code) {
    std::cerr << "viewer: error: " << toString(error) << "\n";
    return code;
}

void logToStderr(LogLevel level, std::string_view message) {
    if (level != LogLevel::Info)
        std::cerr << "viewer: warning: " << message << "\n";
}

ExitCode printPermutations(const Subject& subject, const Options& options) {
    Result<std::vector<Permutation>> needed =
        permutationsOf(subject.scene, subject.lighting, options.look, logToStderr);
    if (!needed)
        return fail(needed.error(), ExitCode::Refused);
    if (subject.sky && subject.sky->backdrop.size > 0) {
        const Result<Permutation> backdrop = skyPermutation(options.look);
        if (!backdrop)
            return fail(backdrop.error(), ExitCode::Refused);
        needed->push_back(*backdrop);
    }
    for (const Permutation& permutation : *needed)
        std::cout << toName(permutation) << "\n";
    return ExitCode::Ok;
}

ExitCode run(const Options& options) {
    Result<Scene> scene = loadGltf(options.model, {}, logToStderr);
    if (!scene)
        return fail(scene.error(), ExitCode::Refused);
    Subject subject{.scene = *std::move(scene), .camera = {}, .lighting = {}, .sky = {}};
    if (!options.skybox.empty()) {
        ProgressBar bar("filtering the sky");
        Result<BakedSky> sky = loadSky(
            options.skybox, {.sun = options.skySun, .progress = [&bar](float share) { bar.show(share); }});
        if (!sky)
            return fail(sky.error(), ExitCode::Refused);
        subject.sky = *std::move(sky);
    }
    const Result<Camera> camera = chooseCamera(subject.scene, options);
    if (!camera)
        return fail(camera.error(), ExitCode::Usage);
    subject.camera = *camera;
    Result<Lighting> lighting = chooseLighting(subject.scene, subject.sky, options, logToStderr);
    if (!lighting)
        return fail(lighting.error(), ExitCode::Usage);
    subject.lighting = *std::move(lighting);

    if (options.permutations)
        return printPermutations(subject, options);
    const Result<Image> picture = drawPicture(subject, options, logToStderr);
    if (!picture)
        return fail(picture.error(),
                    picture.error().code == "surface.options" ? ExitCode::Usage : ExitCode::Device);
    if (const Result<void> written = writePng(options.output, *picture); !written)
        return fail(written.error(), ExitCode::Device);
    return ExitCode::Ok;
}

} // namespace

int main(int argc, char** argv) {
    const std::variant<ExitCode, Options> parsed = parseCommandLine(argc, argv);
    if (const ExitCode* code = std::get_if<ExitCode>(&parsed))
        return static_cast<int>(*code);
    return static_cast<int>(run(std::get<Options>(parsed)));
}
