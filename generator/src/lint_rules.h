// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/lint.h"
#include "glsl_syntax.h"

namespace franken {

/// One stage, as text and taken apart.
struct ShaderText {
    Stage stage;
    std::string_view text;
    Syntax syntax;
};

/// A line that breaks the rule at hand.
struct Broken {
    int line;
    std::string message;
};

/// A rule for one stage on its own.
struct StageRuleCheck {
    LintRule rule;
    std::vector<Broken> (*check)(const ShaderText&);
};

/// A rule for both stages together; its lines are those of the stage that it reports.
struct LinkRuleCheck {
    LintRule rule;
    Stage reports;
    std::vector<Broken> (*check)(const Syntax& vertex, const Syntax& fragment);
};

std::span<const StageRuleCheck> stageRules();
std::span<const LinkRuleCheck> linkRules();

inline constexpr std::string_view kVaryingRead = "varying-read";

/// "'text'"
std::string quoted(std::string_view text);

/// The rule "unused" fills a file of its own.
std::vector<Broken> findUnused(const ShaderText& shader);

} // namespace franken
