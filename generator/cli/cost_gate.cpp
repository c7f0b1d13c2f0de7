// SPDX-License-Identifier: MIT
#include "cost_gate.h"

#include "dearer.h"
#include "effects.h"

namespace franken::cli {
namespace {

void checkLimit(const Gpu& gpu, const Priced& priced, const CostLimit& limit,
                std::vector<Finding>& findings) {
    const int instructions = priced.cost.fragment.instructions;
    if (limit.gpu == gpu.name && priced.cost.measured() && instructions > limit.instructions)
        findings.push_back({toName(priced.asked, snippets()), "max", std::string(gpu.name),
                            "the fragment shader has " + std::to_string(instructions) +
                                " instructions, and " + std::to_string(limit.instructions) + " are allowed",
                            ""});
}

} // namespace

GateFindings findExcess(const std::vector<Bill>& bills, const std::vector<CostLimit>& limits,
                        const CostBaseline& baseline) {
    GateFindings found;
    for (const Bill& bill : bills)
        for (const Priced& priced : bill.priced) {
            for (const CostLimit& limit : limits)
                checkLimit(bill.gpu, priced, limit, found.findings);
            const std::string name = toName(priced.asked, snippets());
            ++found.asked;
            const auto before = baseline.find({name, std::string(bill.gpu.name)});
            if (before == baseline.end())
                continue;
            ++found.compared;
            if (const std::string what = dearer(before->second, priced.cost); !what.empty())
                found.findings.push_back({name, "baseline", std::string(bill.gpu.name), what, ""});
        }
    return found;
}

} // namespace franken::cli
