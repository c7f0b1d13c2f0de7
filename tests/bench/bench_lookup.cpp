// SPDX-License-Identifier: MIT
// What the look-up of a warm program costs, next to std::unordered_map on the key. One run measures both, so
// that the ratio holds on any machine. Both hand out a handle that counts its holders.
#include "franken/generator/covering.h"
#include "franken/program_cache.h"
#include "ratio_reporter.h"

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <unordered_map>

namespace {

using namespace franken;

constexpr std::size_t kPrograms = 200; // What a large kiosk holds.

/// The table of a driver that accepts everything and does nothing.
Gl nullDriver() {
    Gl gl;
    gl.CreateShader = [](GLenum) { return GLuint{1}; };
    gl.CreateProgram = [] { return GLuint{1}; };
    gl.ShaderSource = [](GLuint, GLsizei, const GLchar* const*, const GLint*) {};
    gl.CompileShader = gl.LinkProgram = gl.UseProgram = [](GLuint) {};
    gl.DeleteShader = gl.DeleteProgram = [](GLuint) {};
    gl.AttachShader = [](GLuint, GLuint) {};
    gl.BindAttribLocation = [](GLuint, GLuint, const GLchar*) {};
    gl.GetProgramiv = [](GLuint, GLenum, GLint* value) { *value = GL_TRUE; };
    gl.GetUniformLocation = [](GLuint, const GLchar*) { return GLint{0}; };
    gl.Uniform1i = [](GLint, GLint) {};
    return gl;
}

struct Programs {
    Gl gl = nullDriver();
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

void findInCache(benchmark::State& state) {
    Programs& all = programs();
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(all.cache.find(all.keys[i]));
        i = i + 1 == all.keys.size() ? 0 : i + 1;
    }
}

ProgramHandle find(const std::unordered_map<Key, ProgramHandle>& map, Key key) {
    const auto found = map.find(key);
    return found == map.end() ? nullptr : found->second;
}

void findInMap(benchmark::State& state) {
    Programs& all = programs();
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(find(all.map, all.keys[i]));
        i = i + 1 == all.keys.size() ? 0 : i + 1;
    }
}

void getFromCache(benchmark::State& state) {
    Programs& all = programs();
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(all.cache.get(all.permutations[i]));
        i = i + 1 == all.keys.size() ? 0 : i + 1;
    }
}

void getFromMap(benchmark::State& state) {
    Programs& all = programs();
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(find(all.map, toKey(all.permutations[i])));
        i = i + 1 == all.keys.size() ? 0 : i + 1;
    }
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
