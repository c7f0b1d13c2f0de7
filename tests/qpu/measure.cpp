// SPDX-License-Identifier: MIT
#include "measure.h"

#include "population.h"

#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace franken::test {
namespace {

const std::string kResult = FRANKEN_BINARY_DIR "/Testing/qpu.txt"; // The test Qpu.Compilers writes it.

template<typename T>
T valueOf(Result<T> result) {
    if (!result)
        throw std::runtime_error(toString(result.error()));
    return *std::move(result);
}

Compilers provided() {
    constexpr std::string_view kFolder = "folder ", kSkipped = "skipped: ";
    std::string result;
    if (!std::getline(std::ifstream(kResult), result)) {
        // A test that is run by hand.
        std::system(("'" FRANKEN_SOURCE_DIR "/tests/qpu/provide.sh' '" + kResult + "' >&2").c_str());
        std::getline(std::ifstream(kResult), result);
    }
    if (result.starts_with(kSkipped))
        return {std::nullopt,
                "the compilers of the Pi's GPUs cannot be had here: " + result.substr(kSkipped.size()) +
                    "; mend that and run the test Qpu.Compilers again"};
    if (!result.starts_with(kFolder))
        throw std::runtime_error("toolchain.sh failed: see " + kResult + ".log");
    setenv("FRANKEN_QPU", result.substr(kFolder.size()).c_str(), 1);
    return {valueOf(cli::QpuCompiler::open()), ""};
}

} // namespace

const Compilers& compilers() {
    static const Compilers all = provided();
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
