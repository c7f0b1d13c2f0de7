// SPDX-License-Identifier: MIT
#pragma once

#include "cost_baseline.h"
#include "finding.h"
#include "options.h"
#include "priced.h"

#include <string>
#include <vector>

namespace franken::cli {

/// What the same permutations cost on one of several GPUs.
struct Bill {
    Gpu gpu;
    std::vector<Priced> priced;
};

/// Where costs are above what was asked for: the limits, and a baseline where there is one.
struct GateFindings {
    std::vector<Finding> findings;
    std::size_t compared = 0; ///< Costs that the baseline has as well.
    std::size_t asked = 0;    ///< All costs.
};
GateFindings findExcess(const std::vector<Bill>& bills, const std::vector<CostLimit>& limits,
                        const CostBaseline& baseline);

} // namespace franken::cli
