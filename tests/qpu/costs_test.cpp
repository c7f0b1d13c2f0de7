// SPDX-License-Identifier: MIT
// costs.tsv, goals.tsv, option_prices.tsv and prices.md against the compilers of the Raspberry Pi's GPUs.
#include "costs.h"
#include "option_prices.h"
#include "population.h"
#include "price_list.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace franken::test {
namespace {

const std::filesystem::path kFolder = FRANKEN_SOURCE_DIR "/tests/qpu";
const std::string kHowTo =
    "\nrun 'cmake --build <build tree> --target update-costs' and say in the CHANGELOG why";

class Costs : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        if (!compilers().compiler)
            GTEST_SKIP() << compilers().whyNot;
    }
};

TEST_P(Costs, HaveNotRisen) {
    std::map<std::string, CostRow> before;
    for (const CostRow& row : fromTable(readTable(kFolder / "costs.tsv")))
        if (row.gpu == GetParam())
            before.emplace(row.name, row);
    for (const CostRow& now : measureCosts(GetParam())) {
        const auto found = before.find(now.name);
        if (found == before.end()) {
            ADD_FAILURE() << now.name << " is not in costs.tsv" << kHowTo;
            continue;
        }
        const std::string complaint = worse(found->second, now);
        EXPECT_TRUE(complaint.empty()) << now.name << ": " << complaint << kHowTo;
        before.erase(found);
    }
    for (const auto& [name, row] : before)
        ADD_FAILURE() << name << " is in costs.tsv and not in named.manifest" << kHowTo;
}

INSTANTIATE_TEST_SUITE_P(Gpu, Costs, testing::Values("vc4", "v3d42", "v3d71"),
                         [](const auto& gpu) { return std::string(gpu.param); });

class Goals : public testing::Test {
protected:
    void SetUp() override {
        if (!compilers().compiler)
            GTEST_SKIP() << compilers().whyNot;
    }
};

TEST_F(Goals, MeasuredColumnsAreTrue) {
    const std::vector<Goal> written = goalsFrom(readTable(kFolder / "goals.tsv"));
    ASSERT_EQ(written.size(), 66u);
    const std::vector<Goal> measured = measureGoals(written);
    for (std::size_t i = 0; i < written.size(); ++i) {
        EXPECT_EQ(written[i].instructions, measured[i].instructions) << written[i].id << kHowTo;
        EXPECT_EQ(written[i].threads, measured[i].threads) << written[i].id << kHowTo;
        EXPECT_TRUE(measured[i].reached())
            << written[i].id << " is missed: " << measured[i].instructions << "/" << measured[i].threads
            << " instead of " << written[i].goalInstructions << "/" << written[i].goalThreads;
    }
}

// Needs no compiler: whoever updates the table with a goal missed hears of it everywhere.
TEST(GoalTable, HasNoGoalThatIsMissed) {
    for (const Goal& goal : goalsFrom(readTable(kFolder / "goals.tsv")))
        EXPECT_TRUE(goal.reached())
            << goal.id << " is missed: " << goal.instructions << "/" << goal.threads << " instead of "
            << goal.goalInstructions << "/" << goal.goalThreads
            << ". Make the program cheaper, or write down why the goal is another one";
}

TEST(GoalTable, AMissedGoalIsSeen) {
    EXPECT_TRUE((Goal{"id", "vc4", "sun1", "fragment", 100, 2, 100, 2}.reached()));
    EXPECT_FALSE((Goal{"id", "vc4", "sun1", "fragment", 100, 2, 101, 2}.reached()));
    EXPECT_FALSE((Goal{"id", "vc4", "sun1", "fragment", 100, 2, 90, 1}.reached()));
    EXPECT_FALSE((Goal{"id", "vc4", "sun1", "fragment", 100, 2, 0, 0}.reached()));
}

// What `frankenshader dump` writes for the name is what is measured.
TEST_F(Goals, AreNamedAsTheyAreMeasured) {
    for (const Goal& goal : goalsFrom(readTable(kFolder / "goals.tsv"))) {
        const auto gpu = cli::findGpu(goal.gpu);
        ASSERT_TRUE(gpu) << goal.gpu;
        EXPECT_EQ(toName(cli::forGpu(named(goal.name), *gpu)), goal.name);
    }
}

TEST_F(Goals, ThePriceListIsTrue) {
    const std::string list = priceList();
    EXPECT_EQ(readText(kFolder / "prices.md"), list) << kHowTo;
    const std::string page = readText(std::filesystem::path(FRANKEN_SOURCE_DIR) / kPageOfCosts);
    EXPECT_NE(page.find(list), std::string::npos) << kPageOfCosts << " has another one" << kHowTo;
}

TEST_F(Goals, ThePricesOfAllOptionsAreTrue) {
    const Table written = readTable(kFolder / "option_prices.tsv"), measured = optionPrices();
    ASSERT_EQ(written.size(), measured.size()) << kHowTo;
    for (std::size_t i = 0; i < written.size(); ++i)
        EXPECT_EQ(written[i], measured[i]) << kHowTo;
}

CostRow row() { return {"vc4", "sun1", "ok", 100, 2, 40, 20, 0, 0, 120, 40, "1.8"}; }

TEST(CostRule, ThreePercentAreScheduling) {
    CostRow after = row();
    after.fragment = 103;
    EXPECT_EQ(worse(row(), after), "");
    after.fragment = 104;
    EXPECT_NE(worse(row(), after), "");
    after.fragment = 50;
    EXPECT_EQ(worse(row(), after), "");
}

TEST(CostRule, ThreadsSpillsAndOutcomesAreHeld) {
    CostRow after = row();
    after.threads = 1;
    EXPECT_NE(worse(row(), after), "");
    after = row();
    after.spills = 1;
    EXPECT_NE(worse(row(), after), "");
    after = row();
    after.outcome = "out of registers";
    EXPECT_NE(worse(row(), after), "");
    after = row();
    after.vertex = 200;
    EXPECT_NE(worse(row(), after), "");
}

TEST(CostRule, TablesAreReadAsTheyAreWritten) {
    const std::vector<CostRow> costs = fromTable(toTable(std::vector<CostRow>{row()}));
    ASSERT_EQ(costs.size(), 1u);
    EXPECT_EQ(toTable(costs), toTable(std::vector<CostRow>{row()}));
}

TEST(BreakEven, WeighsVertexAgainstPixel) {
    cli::Cost perVertex, perPixel;
    perVertex.vertex.instructions = 150;
    perPixel.vertex.instructions = 110;
    perVertex.fragment.instructions = 90;
    perPixel.fragment.instructions = 110;
    EXPECT_DOUBLE_EQ(cli::breakEvenPixels(perVertex, perPixel), 2);
    perVertex.fragment.instructions = 110;
    EXPECT_TRUE(std::isinf(cli::breakEvenPixels(perVertex, perPixel)));
    perVertex.fragment.instructions = 90;
    perVertex.vertex.instructions = 100;
    EXPECT_DOUBLE_EQ(cli::breakEvenPixels(perVertex, perPixel), 0);
}

TEST(Gpu, APi3ShadesFullHdAt60HzWith115Instructions) {
    const auto gpu = cli::findGpu("vc4");
    ASSERT_TRUE(gpu);
    const double fullHd = 1920 * 1080 * 60 / 1e6;
    EXPECT_GE(cli::megapixelsPerSecond(*gpu, gpu->models.back(), 115), fullHd);
    EXPECT_LT(cli::megapixelsPerSecond(*gpu, gpu->models.back(), 116), fullHd);
    EXPECT_FALSE(cli::findGpu("pi9"));
}

} // namespace
} // namespace franken::test
