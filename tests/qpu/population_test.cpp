// SPDX-License-Identifier: MIT
// The covering set and 200 random permutations (with FRANKEN_LONG=1 in the environment: 800) through the
// compilers of the Raspberry Pi's GPUs.
#include "franken/generator/budget.h"
#include "franken/generator/compose.h"
#include "franken/generator/covering.h"
#include "measure.h"
#include "population.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>

namespace franken::test {
namespace {

// With 1 thread a QPU waits for each texture fetch. A program that fetches nothing has nothing to wait for,
// and Mesa gives it no second thread on vc4. So those are listed that do fetch, and those that spill.

// Each program that is measured on that GPU, once. These GPUs compute in 32 bits.
std::vector<Permutation> programsFor(const cli::Gpu& gpu) {
    std::vector<Permutation> all = coveringSet();
    for (const Permutation& permutation : randomPermutations(std::getenv("FRANKEN_LONG") ? 800 : 200, 2))
        all.push_back(canonical(permutation));
    std::vector<Permutation> programs;
    std::set<Key> seen;
    for (const Permutation& permutation : all) {
        Permutation generic = permutation;
        generic.target = Target::Generic;
        generic.precision = Precision::Fp32;
        const Permutation program = cli::forGpu(canonical(generic), gpu);
        if (seen.insert(toKey(program)).second)
            programs.push_back(program);
    }
    return programs;
}

class QpuPopulation : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        if (!compilers().compiler)
            GTEST_SKIP() << compilers().whyNot;
    }
};

TEST_P(QpuPopulation, CompilesWhereTheBudgetLetsItThrough) {
    const std::string name = GetParam();
    const auto gpu = cli::findGpu(name);
    const auto profile = findProfile(name == "vc4" ? "vc4" : "v3d");
    ASSERT_TRUE(gpu && profile);
    const std::vector<Permutation> programs = programsFor(*gpu);
    const auto costs = compilers().compiler->measure(*gpu, programs);
    ASSERT_TRUE(costs) << toString(costs.error());
    const std::string path = FRANKEN_BINARY_DIR "/qpu_" + name + "_slow.tsv";
    std::ofstream list(path);
    list << "instructions\tthreads\tspills\tname\n";
    std::size_t slow = 0, exceeding = 0, refused = 0, manyLights = 0;
    for (std::size_t i = 0; i < programs.size(); ++i) {
        const cli::Cost& cost = (*costs)[i];
        const Composed program = compose(programs[i]);
        if (programs[i].suns + programs[i].punctualLights > 4 && cost.measured()) {
            ++manyLights;
            refused += budget(program.interface, *profile).fits() ? 0 : 1;
        }
        if (!cost.measured()) {
            ++exceeding;
            EXPECT_FALSE(budget(program.interface, *profile).fits())
                << toName(programs[i]) << ": " << cost.error;
            continue;
        }
        if ((cost.fragment.threads > 1 || program.interface.samplers.empty()) && cost.fragment.spills == 0)
            continue;
        ++slow;
        list << cost.fragment.instructions << '\t' << cost.fragment.threads << '\t' << cost.fragment.spills
             << '\t' << toName(programs[i]) << '\n';
    }
    EXPECT_LE(refused, manyLights / 2)
        << "of " << manyLights << " that would draw, the budget refuses too many";
    std::cout << name << ": the budget refuses " << refused << " of " << manyLights
              << " programs with more than four lights that compile\n";
    std::cout << name << ": of " << programs.size() << " programs " << slow << " run with 1 thread or spill ("
              << path << "), and " << exceeding << " exceed the budget\n";
}

INSTANTIATE_TEST_SUITE_P(Gpu, QpuPopulation, testing::Values("vc4", "v3d42"),
                         [](const auto& gpu) { return std::string(gpu.param); });

} // namespace
} // namespace franken::test
