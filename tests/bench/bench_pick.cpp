// SPDX-License-Identifier: MIT
// What a ray costs in 100,000 triangles: with a tree, next to testing all of them. One run measures both, so
// that the ratio holds on any machine.
#include "franken/pick.h"
#include "ratio_reporter.h"
#include "support/brute_pick.h"
#include "support/shapes.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace {

using namespace franken;

constexpr int kRings = 158; // 4 * 158^2 triangles are 99,856.

const Scene& ball() {
    static const Scene scene = [] {
        test::SceneBuilder builder;
        builder.add(test::sphere(kRings), builder.addMaterial({}));
        return builder.scene;
    }();
    return scene;
}

const PickTree& tree() {
    static const PickTree tree = *PickTree::of(ball());
    return tree;
}

/// From all around; two of three meet the ball.
Ray rayOf(std::size_t number) {
    const double angle = 0.1 * static_cast<double>(number);
    const glm::dvec3 origin(3 * std::cos(angle), std::sin(7 * angle), 3 * std::sin(angle));
    const glm::dvec3 aim(0, number % 3 == 0 ? 2 : 0.3, 0.2);
    return {.origin = origin, .direction = glm::normalize(aim - origin)};
}

void withTree(benchmark::State& state) {
    std::size_t number = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(tree().pick(rayOf(number++)));
}

void testingAll(benchmark::State& state) {
    std::size_t number = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(test::pickByTestingAll(ball(), rayOf(number++)));
}

void makingATree(benchmark::State& state) {
    for (auto _ : state)
        benchmark::DoNotOptimize(PickTree::of(ball()));
}

BENCHMARK(withTree);
BENCHMARK(testingAll);
BENCHMARK(makingATree);

bool sameHits() {
    for (std::size_t i = 0; i < 30; ++i) {
        const Result<std::optional<Hit>> hit = tree().pick(rayOf(i));
        const std::optional<Hit> expected = test::pickByTestingAll(ball(), rayOf(i));
        if (!hit || hit->has_value() != expected.has_value() ||
            (expected && std::abs((*hit)->distance - expected->distance) > 1e-9))
            return false;
    }
    return true;
}

} // namespace

int main(int argc, char** argv) {
    std::printf("%zu triangles\n", tree().counts().triangles);
    return bench::runWithRatios(argc, argv, sameHits(),
                                {{"withTree", "testingAll"}, {"makingATree", "testingAll"}});
}
