// SPDX-License-Identifier: MIT
#include "explanation.h"

#include "effects.h"

#include <algorithm>

namespace franken::cli {
namespace {

std::vector<ExplainedLine> explainStage(const ComposedStage& stage, const std::vector<Reason>& reasons) {
    const std::vector<std::string_view> texts = linesOf(stage.text);
    std::vector<ExplainedLine> lines;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const LineOrigin& origin = stage.lines[i];
        const auto reason = std::find_if(reasons.begin(), reasons.end(),
                                         [&](const Reason& each) { return each.snippet == origin.snippet; });
        lines.push_back({texts[i], origin, reason == reasons.end() ? nullptr : &*reason});
    }
    return lines;
}

} // namespace

ProfileBudget budgetFor(const Program& program, const Profile& profile) {
    ProfileBudget result{profile, budget(program.composed.interface, profile), {}};
    for (const Use& use : result.budget.uses)
        if (use.exceeded())
            result.excesses.push_back({use, costlyFeatures(program.permutation, use.resource, snippets())});
    return result;
}

std::string adviceFor(const Excess& excess) {
    std::string advice;
    for (const Feature& feature : excess.features)
        advice += advice.empty() ? "without '" + feature.word + "' it takes " + std::to_string(feature.used)
                                 : ", without '" + feature.word + "' " + std::to_string(feature.used);
    return advice;
}

Explanation::Explanation(Program explained, std::vector<Dropped> noOps)
    : program(std::move(explained)),
      dropped(std::move(noOps)),
      reasons(franken::explain(program.permutation, snippets())),
      vertex(explainStage(program.composed.vertex, reasons)),
      fragment(explainStage(program.composed.fragment, reasons)) {
    for (const Profile& profile : profiles())
        budgets.push_back(budgetFor(program, profile));
}

} // namespace franken::cli
