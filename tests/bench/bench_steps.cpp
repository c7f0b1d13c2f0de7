// SPDX-License-Identifier: MIT
// How long a model keeps a frame waiting that comes to the GPU: all at once, by add() and prepare(), next to
// the longest of the steps of one unit each. Four encoded pictures of 2048 x 2048, 131,000 triangles, two
// programs, on Mesa's softpipe. Times are those of the processor in the thread that draws, so that a busy
// machine measures alike.
#include "franken/png.h"
#include "franken/renderer.h"
#include "ratio_reporter.h"
#include "support/offscreen.h"
#include "support/shapes.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <thread>

namespace {

using namespace franken;

constexpr int kPictureSize = 2048, kRings = 181; // 4 * 181^2 triangles are 131,044.

/// Of the processor, in this thread; seconds.
double now() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Image encodedNoise(unsigned seed) {
    Image image{"", kPictureSize, kPictureSize, {}};
    std::vector<std::uint8_t> rgba(std::size_t{4} * kPictureSize * kPictureSize);
    for (std::uint8_t& byte : rgba)
        byte = static_cast<std::uint8_t>((seed = 1664525 * seed + 1013904223) >> 30);
    image.encoded = encodePng(image.width, image.height, 4, rgba, 1);
    return image;
}

const Scene& model() {
    static const Scene scene = [] {
        test::SceneBuilder builder;
        for (unsigned i = 0; i < 2; ++i) {
            Material material;
            material.textures[TextureRole::BaseColor].texture = builder.addTexture(encodedNoise(2 * i));
            material.textures[TextureRole::MetallicRoughness].texture =
                builder.addTexture(encodedNoise(2 * i + 1));
            material.alphaMode = i == 0 ? AlphaMode::Opaque : AlphaMode::Mask;
            builder.add(test::sphere(i == 0 ? kRings : 8), builder.addMaterial(material));
        }
        return builder.scene;
    }();
    return scene;
}

template<typename T>
T require(Result<T> result) {
    if (result)
        return *std::move(result);
    std::fprintf(stderr, "%s\n", toString(result.error()).c_str());
    std::exit(2);
}

void require(const Result<void>& result) { require(result ? Result<int>(0) : Result<int>(result.error())); }

/// A renderer in a context of its own.
struct Stage {
    Stage() {
        Lighting lighting;
        lighting.suns = {{.direction = {-1, -1, -1}, .illuminance = 3}};
        renderer.setLighting(lighting);
    }
    test::Offscreen offscreen = require(test::openOffscreen(platform::Backend::OsMesa, {64, 64}));
    Renderer renderer{offscreen.gl};
};

void allAtOnce(benchmark::State& state) {
    for (auto _ : state) {
        Stage stage;
        const double begin = now();
        const ModelId id = require(stage.renderer.add(model()));
        require(stage.renderer.show({{id}}));
        require(stage.renderer.prepare());
        state.SetIterationTime(now() - begin);
    }
}

void longestStep(benchmark::State& state) {
    std::size_t steps = 0;
    double longestUpload = 0, longestProgram = 0, sum = 0;
    for (auto _ : state) {
        Stage stage;
        const ModelId id = require(stage.renderer.addInSteps(model()));
        require(stage.renderer.show({{id}}));
        double longest = 0;
        for (bool more = true; more;) {
            const double begin = now();
            const StepReport report = require(stage.renderer.step());
            const double time = now() - begin;
            more = report.more;
            (report.programs > 0 ? longestProgram : longestUpload) =
                std::max(time, report.programs > 0 ? longestProgram : longestUpload);
            longest = std::max(longest, time);
            sum += time;
            ++steps;
            if (report.bytes == 0 && report.programs == 0)
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        state.SetIterationTime(longest);
    }
    const auto perRun = benchmark::Counter::kAvgIterations;
    state.counters["steps"] = benchmark::Counter(static_cast<double>(steps), perRun);
    state.counters["sum_ms"] = benchmark::Counter(1e3 * sum, perRun);
    state.counters["upload_ms"] = 1e3 * longestUpload;
    state.counters["program_ms"] = 1e3 * longestProgram;
}

BENCHMARK(allAtOnce)->UseManualTime()->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(longestStep)->UseManualTime()->Iterations(1)->Unit(benchmark::kMillisecond);

bool sameBytes() {
    Stage whole, steps;
    require(whole.renderer.load(model()));
    require(steps.renderer.addInSteps(model()));
    while (require(steps.renderer.step(std::chrono::seconds(1))).more)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return whole.renderer.memory().used() == steps.renderer.memory().used();
}

} // namespace

int main(int argc, char** argv) {
    return bench::runWithRatios(argc, argv, sameBytes(), {{"allAtOnce", "longestStep"}});
}
