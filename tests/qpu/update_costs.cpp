// SPDX-License-Identifier: MIT
// Measures again and writes costs.tsv, option_prices.tsv, the measured columns of goals.tsv, prices.md and
// the README's copy of it.
#include "costs.h"
#include "option_prices.h"
#include "price_list.h"

#include <exception>
#include <iostream>

using namespace franken::test;

namespace {

// Whether all goals are reached.
bool update(const std::filesystem::path& root) {
    const std::filesystem::path folder = root / "tests/qpu";
    std::vector<CostRow> costs;
    for (const char* gpu : {"vc4", "v3d42", "v3d71"})
        for (CostRow& row : measureCosts(gpu))
            costs.push_back(std::move(row));
    writeTable(folder / "costs.tsv", toTable(costs));
    const std::vector<Goal> goals = measureGoals(goalsFrom(readTable(folder / "goals.tsv")));
    writeTable(folder / "goals.tsv", toTable(goals));
    writeTable(folder / "option_prices.tsv", optionPrices());
    const std::string list = priceList();
    writeText(folder / "prices.md", list);
    const std::filesystem::path page = root / kPageOfCosts;
    const std::string before = readText(page);
    if (const std::string updated = withPriceList(before, list); updated != before)
        writeText(page, updated);
    bool reached = true;
    for (const Goal& goal : goals)
        if (!goal.reached()) {
            std::cerr << goal.id << " is missed: " << goal.instructions << "/" << goal.threads
                      << " instead of " << goal.goalInstructions << "/" << goal.goalThreads << '\n';
            reached = false;
        }
    return reached;
}

} // namespace

int main() {
    try {
        if (!compilers().compiler) {
            std::cerr << compilers().whyNot << '\n';
            return 1;
        }
        return update(FRANKEN_SOURCE_DIR) ? 0 : 1;
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
