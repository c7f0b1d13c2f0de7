// SPDX-License-Identifier: MIT
#include "franken/generator/lint.h"

#include "lint_rules.h"

#include <algorithm>

namespace franken {
namespace {

std::string_view nameOf(Stage stage) { return stage == Stage::Vertex ? "vertex" : "fragment"; }

LintFinding finding(const ComposedStage& text, Stage stage, std::string_view rule, Broken broken) {
    const auto index = static_cast<std::size_t>(broken.line) - 1;
    const LineOrigin origin = index < text.lines.size() ? text.lines[index] : LineOrigin{{}, 0};
    return {stage, broken.line, origin, rule, std::move(broken.message)};
}

void lintLink(const Composed& program, std::vector<LintFinding>& findings) {
    const Syntax vertex = parseGlsl(program.vertex.text);
    const Syntax fragment = parseGlsl(program.fragment.text);
    for (const LinkRuleCheck& rule : linkRules())
        for (Broken& broken : rule.check(vertex, fragment)) {
            const Stage stage = rule.reports;
            const ComposedStage& text = stage == Stage::Vertex ? program.vertex : program.fragment;
            LintFinding found = finding(text, stage, rule.rule.id, std::move(broken));
            // A view of the material may leave out the hook that reads what an effect hands on: at no cost.
            if (!(found.origin.effect && found.rule == kVaryingRead))
                findings.push_back(std::move(found));
        }
}

} // namespace

std::span<const LintRule> lintRules() {
    static const std::vector<LintRule> rules = [] {
        std::vector<LintRule> all;
        for (const StageRuleCheck& rule : stageRules())
            all.push_back(rule.rule);
        for (const LinkRuleCheck& rule : linkRules())
            all.push_back(rule.rule);
        return all;
    }();
    return rules;
}

std::string toString(const LintFinding& finding) {
    const std::string ofStage = std::string(nameOf(finding.stage)) + ":" + std::to_string(finding.line);
    const std::string place = finding.origin.snippet.empty() ? ofStage : toString(finding.origin);
    return place + ": " + finding.message + " [" + std::string(finding.rule) + "]";
}

std::vector<LintFinding> lint(const ComposedStage& text, Stage stage) {
    const ShaderText shader{stage, text.text, parseGlsl(text.text)};
    std::vector<LintFinding> findings;
    for (const StageRuleCheck& rule : stageRules())
        for (Broken& broken : rule.check(shader))
            findings.push_back(finding(text, stage, rule.rule.id, std::move(broken)));
    return findings;
}

std::vector<LintFinding> lintProgram(const Composed& program) {
    std::vector<LintFinding> findings = lint(program.vertex, Stage::Vertex);
    std::vector<LintFinding> fragment = lint(program.fragment, Stage::Fragment);
    std::move(fragment.begin(), fragment.end(), std::back_inserter(findings));
    lintLink(program, findings);
    return findings;
}

} // namespace franken
