// SPDX-License-Identifier: MIT
// What composing costs: next to a memcpy of the text, which nothing can beat, and next to a composer that
// finds and replaces. One run measures all three, so that the ratios hold on any machine.
#include "ratio_reporter.h"
#include "replace_composer.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

using namespace franken;

// What a textured model under one sun and a sky asks for.
constexpr std::string_view kTypical = "basecolor.metalrough.normal.occlusion.emissive+sh+sun1+aces";

Permutation typical() {
    const auto parsed = parseName(kTypical);
    if (!parsed)
        std::exit(2);
    return canonicalise(*parsed)->permutation;
}

void composeTypical(benchmark::State& state) {
    const Permutation permutation = typical();
    for (auto _ : state)
        benchmark::DoNotOptimize(compose(permutation));
}

void replaceTypical(benchmark::State& state) {
    const Permutation permutation = typical();
    for (auto _ : state)
        benchmark::DoNotOptimize(bench::composeByReplacing(permutation));
}

void copyText(benchmark::State& state) {
    const Composed program = compose(typical());
    const std::string text = program.vertex.text + program.fragment.text;
    std::string copy(text.size(), ' ');
    for (auto _ : state) {
        std::memcpy(copy.data(), text.data(), text.size());
        benchmark::ClobberMemory();
    }
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                            static_cast<std::int64_t>(text.size()));
}

void canonicaliseTypical(benchmark::State& state) {
    const Permutation permutation = typical();
    for (auto _ : state)
        benchmark::DoNotOptimize(canonicalise(permutation));
}

BENCHMARK(composeTypical);
BENCHMARK(replaceTypical);
BENCHMARK(copyText);
BENCHMARK(canonicaliseTypical);

bool sameBytes() {
    const Composed program = compose(typical());
    const auto [vertex, fragment] = bench::composeByReplacing(typical());
    return vertex == program.vertex.text && fragment == program.fragment.text;
}

} // namespace

int main(int argc, char** argv) {
    return bench::runWithRatios(argc, argv, sameBytes(),
                                {{"composeTypical", "replaceTypical"}, {"composeTypical", "copyText"}});
}
