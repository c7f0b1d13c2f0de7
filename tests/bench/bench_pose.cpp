// SPDX-License-Identifier: MIT
// What ten figures of 19 joints and 3,273 vertices cost on the CPU in each frame: sampled and with their
// joints placed, as is done where programs move the vertices; and with the vertices moved too, next to a
// plain loop over plain arrays that does the same. One run measures all, so that the ratios hold on any
// machine.
#include "franken/deform.h"
#include "franken/pose.h"
#include "plain_figure.h"
#include "ratio_reporter.h"

#include <algorithm>
#include <cmath>

namespace {

using namespace franken;

constexpr int kFigures = 10;

double secondsOf(int figure, std::size_t frame) {
    return std::fmod(0.016 * static_cast<double>(frame) + 0.17 * figure, bench::kDuration);
}

struct Figure {
    Scene scene = bench::figureScene();
    std::shared_ptr<const Deformation> deformation = bench::figureDeformation();
    Pose pose = restPose(scene);
    std::vector<NodeWorld> worlds;
    Palette palette;
    Vertices vertices;

    void place(double seconds) {
        static_cast<void>(sample(scene, 0, seconds, pose));
        worldsOf(scene, pose, worlds);
        paletteOf(scene.skins[0], worlds, palette);
    }
    void move(double seconds) {
        place(seconds);
        deform(*deformation, {.joints = palette.joints}, vertices);
    }
};

void placingJoints(benchmark::State& state) {
    std::vector<Figure> figures(kFigures);
    for (std::size_t frame = 0; auto _ : state) {
        for (int i = 0; i < kFigures; ++i)
            figures[static_cast<std::size_t>(i)].place(secondsOf(i, frame));
        ++frame;
    }
}

void movingVertices(benchmark::State& state) {
    std::vector<Figure> figures(kFigures);
    for (std::size_t frame = 0; auto _ : state) {
        for (int i = 0; i < kFigures; ++i)
            figures[static_cast<std::size_t>(i)].move(secondsOf(i, frame));
        ++frame;
    }
}

void plainLoop(benchmark::State& state) {
    std::vector<bench::PlainFigure> figures(kFigures);
    for (std::size_t frame = 0; auto _ : state) {
        for (int i = 0; i < kFigures; ++i)
            figures[static_cast<std::size_t>(i)].move(secondsOf(i, frame));
        ++frame;
    }
}

BENCHMARK(placingJoints);
BENCHMARK(movingVertices);
BENCHMARK(plainLoop);

/// The palette is as seen from the first joint.
bool sameVertices() {
    Figure figure;
    bench::PlainFigure plain;
    double worst = 0;
    for (std::size_t frame = 0; frame < 90; frame += 7) {
        figure.move(secondsOf(3, frame));
        plain.move(secondsOf(3, frame));
        for (std::size_t v = 0; v < plain.positions.size(); ++v) {
            const glm::vec3 position = figure.vertices.positions[v] + glm::vec3(figure.palette.origin);
            worst = std::max<double>({worst, glm::length(position - plain.positions[v]),
                                      glm::length(figure.vertices.normals[v] - plain.normals[v])});
        }
    }
    std::printf("positions and normals differ by %.1e at most\n", worst);
    return worst < 1e-4;
}

} // namespace

int main(int argc, char** argv) {
    std::printf("%d figures of %zu vertices\n", kFigures, Figure().deformation->bind.positions.size());
    return bench::runWithRatios(argc, argv, sameVertices(),
                                {{"movingVertices", "plainLoop"}, {"placingJoints", "plainLoop"}});
}
