// SPDX-License-Identifier: MIT
#pragma once

#include "program_cost.h"

#include <map>

namespace price {

/// The committed figures of tests/qpu, as text.
extern const std::string_view kCostsTable; ///< costs.tsv
extern const std::string_view kPriceList;  ///< prices.md

/// What programs cost, without a compiler.
class PriceTables {
public:
    /// Of the texts above or others like them. Rows that say nothing are left out.
    PriceTables(std::string_view costs, std::string_view prices);

    /// The program's row, or the nearest row plus and minus what the features between the two cost. Features
    /// that the list has no price for cost nothing. `program`: canonical, and as it is for any GPU.
    ProgramCost of(std::string_view gpu, const franken::Permutation& program) const;

private:
    struct Row {
        std::string gpu;
        franken::Permutation program;
        ProgramCost cost;
    };
    struct Price {
        int fragment = 0, vertex = 0; ///< The vertex shader's two runs together.
    };
    std::vector<Row> m_rows;
    std::map<std::string, std::map<std::string, Price>, std::less<>> m_prices; ///< By GPU and feature.
};

} // namespace price
