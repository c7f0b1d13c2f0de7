// SPDX-License-Identifier: MIT
#include "measure.h"

#include "population.h"

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace franken::test {
namespace {

constexpr int kSkipped = 77; // toolchain.sh: the machine cannot have them.

template<typename T>
T valueOf(Result<T> result) {
    if (!result)
        throw std::runtime_error(toString(result.error()));
    return *std::move(result);
}

Compilers install() {
    std::FILE* script = popen("exec " FRANKEN_SOURCE_DIR "/tests/qpu/toolchain.sh", "r");
    if (!script)
        throw std::runtime_error("toolchain.sh cannot be started");
    std::array<char, 4096> line{};
    std::string folder = std::fgets(line.data(), line.size(), script) ? line.data() : "";
    const int status = pclose(script);
    if (WIFEXITED(status) && WEXITSTATUS(status) == kSkipped)
        return {std::nullopt,
                "the compilers of the Pi's GPUs cannot be had here; see what toolchain.sh said"};
    if (status != 0 || folder.empty())
        throw std::runtime_error("toolchain.sh failed");
    folder.pop_back();
    setenv("FRANKEN_QPU", folder.c_str(), 1);
    return {valueOf(cli::QpuCompiler::open()), ""};
}

} // namespace

const Compilers& compilers() {
    static const Compilers all = install();
    return all;
}

std::vector<cli::Priced> priceOn(std::string_view gpu, std::span<const Permutation> permutations) {
    return valueOf(cli::price(compilers().compiler.value(), valueOf(cli::findGpu(gpu)), permutations));
}

std::vector<Permutation> namedPermutations() {
    std::vector<Permutation> permutations;
    std::ifstream manifest(FRANKEN_SOURCE_DIR "/tests/golden/named.manifest");
    for (std::string line; std::getline(manifest, line);)
        if (const std::string name = line.substr(0, line.find_first_of(" #")); !name.empty())
            permutations.push_back(named(name));
    if (permutations.empty())
        throw std::runtime_error("named.manifest cannot be read");
    return permutations;
}

} // namespace franken::test
