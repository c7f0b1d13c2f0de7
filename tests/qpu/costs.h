// SPDX-License-Identifier: MIT
#pragma once

#include "measure.h"
#include "table.h"

namespace franken::test {

/// What costs.tsv says of one program on one GPU.
struct CostRow {
    std::string gpu, name;
    std::string outcome; ///< "ok", or why there are no figures.
    int fragment = 0, threads = 0, uniforms = 0, temps = 0, spills = 0, fills = 0;
    int vertex = 0, coordinate = 0;
    /// Pixels a vertex from which on light vectors per vertex pay: "1.8", "never", or "-" where there is one
    /// way only.
    std::string breakEven = "-";
};

/// Of all named permutations, GPU by GPU.
std::vector<CostRow> measureCosts(std::string_view gpu);

Table toTable(const std::vector<CostRow>& costs);
std::vector<CostRow> fromTable(const Table& table);

/// What got worse from one row to the other, or nothing: see cli::dearer(); or another outcome.
std::string worse(const CostRow& before, const CostRow& after);

/// A row of goals.tsv.
struct Goal {
    std::string id, gpu, name;
    std::string shader; ///< "fragment", or "vertex": with the coordinate shader, which a vertex pays for too.
    int goalInstructions, goalThreads;
    int instructions, threads; ///< As measured; 0 where it does not compile.

    bool reached() const {
        return instructions > 0 && instructions <= goalInstructions && threads >= goalThreads;
    }
};

std::vector<Goal> goalsFrom(const Table& table);
Table toTable(const std::vector<Goal>& goals);

/// The same goals, measured again.
std::vector<Goal> measureGoals(std::vector<Goal> goals);

} // namespace franken::test
