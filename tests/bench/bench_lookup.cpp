// SPDX-License-Identifier: MIT
// What the look-up of a warm program costs, next to std::unordered_map on the key. One run measures both, so
// that the ratio holds on any machine. Both hand out a handle that counts its holders.
#include "franken/generator/covering.h"
#include "franken/program_cache.h"
#include "ratio_reporter.h"
#include "support/null_gl.h"

#include <algorithm>
#include <unordered_map>

namespace {

using namespace franken;

constexpr std::size_t kPrograms = 200; // What a large kiosk holds.

struct Programs {
    Gl gl = test::nullGl();
    ProgramCache cache{gl};
    std::unordered_map<Key, ProgramHandle> map;
    std::vector<Permutation> permutations = coveringSet();
    std::vector<Key> keys;

    Programs() {
        permutations.resize(std::min(permutations.size(), kPrograms));
        for (const Permutation& permutation : permutations) {
            keys.push_back(toKey(permutation));
            map[keys.back()] = *cache.get(permutation);
        }
    }
};

Programs& programs() {
    static Programs all;
    return all;
}

ProgramHandle find(const std::unordered_map<Key, ProgramHandle>& map, const Key& key) {
    const auto found = map.find(key);
    return found == map.end() ? nullptr : found->second;
}

/// One program after the other, each by look(its number).
template<typename Look>
void measure(benchmark::State& state, Look look) {
    const std::size_t count = programs().keys.size();
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(look(i));
        i = i + 1 == count ? 0 : i + 1;
    }
}

void findInCache(benchmark::State& state) {
    measure(state, [&all = programs()](std::size_t i) { return all.cache.find(all.keys[i]); });
}

void findInMap(benchmark::State& state) {
    measure(state, [&all = programs()](std::size_t i) { return find(all.map, all.keys[i]); });
}

void getFromCache(benchmark::State& state) {
    measure(state, [&all = programs()](std::size_t i) { return all.cache.get(all.permutations[i]); });
}

void getFromMap(benchmark::State& state) {
    measure(state, [&all = programs()](std::size_t i) { return find(all.map, toKey(all.permutations[i])); });
}

BENCHMARK(findInCache);
BENCHMARK(findInMap);
BENCHMARK(getFromCache);
BENCHMARK(getFromMap);

} // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    bench::RatioReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    reporter.printRatio("findInCache", "findInMap");
    reporter.printRatio("getFromCache", "getFromMap");
    return 0;
}
