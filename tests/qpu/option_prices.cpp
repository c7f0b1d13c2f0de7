// SPDX-License-Identifier: MIT
#include "option_prices.h"

#include "measure.h"
#include "option_programs.h"

#include <algorithm>
#include <stdexcept>

namespace franken::test {
namespace {

constexpr const char* kGpuNames[] = {"vc4", "v3d42", "v3d71"};

void addColumns(Row& row, const cli::Priced& priced) {
    const cli::Cost& cost = priced.cost;
    if (!cost.measured())
        throw std::runtime_error(toName(priced.asked) + ": " + cost.error);
    for (const int figure : {cost.fragment.instructions, cost.fragment.threads, cost.vertexInstructions()})
        row.push_back(std::to_string(figure));
}

} // namespace

Table optionPrices() {
    const Result<std::vector<gallery::ChoiceProgram>> choices = gallery::choicePrograms();
    if (!choices)
        throw std::runtime_error(toString(choices.error()));
    Table table{{"option", "program"}};
    std::vector<Permutation> programs; // Each once.
    std::vector<std::size_t> program;  // Of a row.
    for (const gallery::ChoiceProgram& choice : *choices)
        for (std::size_t i = 0; i < choice.programs.size(); ++i) {
            table.push_back({std::string(choice.choice->options[i].word), toName(choice.programs[i])});
            const auto found = std::find(programs.begin(), programs.end(), choice.programs[i]);
            program.push_back(static_cast<std::size_t>(found - programs.begin()));
            if (found == programs.end())
                programs.push_back(choice.programs[i]);
        }
    for (const char* gpu : kGpuNames) {
        for (const char* column : {" fragment", " threads", " vertex"})
            table[0].push_back(std::string(gpu) + column);
        const std::vector<cli::Priced> prices = priceOn(gpu, programs);
        for (std::size_t row = 0; row < program.size(); ++row)
            addColumns(table[row + 1], prices[program[row]]);
    }
    return table;
}

} // namespace franken::test
