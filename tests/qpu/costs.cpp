// SPDX-License-Identifier: MIT
#include "costs.h"

#include "dearer.h"
#include "population.h"

#include <cmath>
#include <cstdio>

namespace franken::test {
namespace {

const Row kCostColumns = {"gpu",   "name",   "outcome", "fragment", "threads",    "uniforms",
                          "temps", "spills", "fills",   "vertex",   "coordinate", "break-even"};
const Row kGoalColumns = {"id",
                          "gpu",
                          "permutation",
                          "shader",
                          "goal instructions",
                          "goal threads",
                          "measured instructions",
                          "measured threads"};

std::string breakEvenText(const std::optional<double>& pixels) {
    if (!pixels)
        return "-";
    if (std::isinf(*pixels))
        return "never";
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", *pixels);
    return text;
}

CostRow rowOf(std::string_view gpu, const cli::Priced& priced) {
    CostRow row;
    row.gpu = gpu;
    row.name = toName(priced.asked);
    row.outcome = priced.cost.measured() ? "ok" : priced.cost.error;
    const cli::ShaderCost& fragment = priced.cost.fragment;
    row.fragment = fragment.instructions;
    row.threads = fragment.threads;
    row.uniforms = fragment.uniforms;
    row.temps = fragment.temps;
    row.spills = fragment.spills;
    row.fills = fragment.fills;
    row.vertex = priced.cost.vertex.instructions;
    row.coordinate = priced.cost.coordinate.instructions;
    row.breakEven = breakEvenText(priced.breakEven);
    return row;
}

cli::Cost costOf(const CostRow& row) {
    cli::Cost cost;
    cost.fragment = {row.fragment, row.threads, row.uniforms, row.temps, row.spills, row.fills};
    cost.vertex.instructions = row.vertex;
    cost.coordinate.instructions = row.coordinate;
    return cost;
}

} // namespace

std::vector<CostRow> measureCosts(std::string_view gpu) {
    std::vector<CostRow> rows;
    for (const cli::Priced& priced : priceOn(gpu, namedPermutations()))
        rows.push_back(rowOf(gpu, priced));
    return rows;
}

Table toTable(const std::vector<CostRow>& costs) {
    Table table{kCostColumns};
    for (const CostRow& row : costs) {
        Row& columns = table.emplace_back(Row{row.gpu, row.name, row.outcome});
        for (const int figure : {row.fragment, row.threads, row.uniforms, row.temps, row.spills, row.fills,
                                 row.vertex, row.coordinate})
            columns.push_back(std::to_string(figure));
        columns.push_back(row.breakEven);
    }
    return table;
}

std::vector<CostRow> fromTable(const Table& table) {
    std::vector<CostRow> rows;
    for (std::size_t i = 1; i < table.size(); ++i) {
        const Row& columns = table[i];
        const auto figure = [&](std::size_t column) { return std::stoi(columns.at(column)); };
        rows.push_back({columns.at(0), columns.at(1), columns.at(2), figure(3), figure(4), figure(5),
                        figure(6), figure(7), figure(8), figure(9), figure(10), columns.at(11)});
    }
    return rows;
}

std::string worse(const CostRow& before, const CostRow& after) {
    if (before.outcome != after.outcome)
        return "it was '" + before.outcome + "' and is '" + after.outcome + "'";
    return cli::dearer(costOf(before), costOf(after));
}

std::vector<Goal> goalsFrom(const Table& table) {
    std::vector<Goal> goals;
    for (std::size_t i = 1; i < table.size(); ++i) {
        const Row& columns = table[i];
        const auto figure = [&](std::size_t column) { return std::stoi(columns.at(column)); };
        goals.push_back({columns.at(0), columns.at(1), columns.at(2), columns.at(3), figure(4), figure(5),
                         figure(6), figure(7)});
    }
    return goals;
}

Table toTable(const std::vector<Goal>& goals) {
    Table table{kGoalColumns};
    for (const Goal& goal : goals) {
        Row& columns = table.emplace_back(Row{goal.id, goal.gpu, goal.name, goal.shader});
        for (const int figure : {goal.goalInstructions, goal.goalThreads, goal.instructions, goal.threads})
            columns.push_back(std::to_string(figure));
    }
    return table;
}

std::vector<Goal> measureGoals(std::vector<Goal> goals) {
    for (Goal& goal : goals) {
        const Permutation permutation = named(goal.name);
        const cli::Cost cost = priceOn(goal.gpu, {&permutation, 1}).front().cost;
        const bool ofVertex = goal.shader == "vertex";
        goal.instructions = ofVertex ? cost.vertexInstructions() : cost.fragment.instructions;
        goal.threads = ofVertex ? cost.vertex.threads : cost.fragment.threads;
    }
    return goals;
}

} // namespace franken::test
