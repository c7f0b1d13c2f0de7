// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/compose.h"

#include <span>

namespace FRANKEN_API franken {

/// One rule of the lint. The rules are stricter than GLSL ES 1.00 (Khronos, revision 17): they also forbid
/// code that the language allows but that some driver of a Raspberry Pi class GPU refuses, or that is hard to
/// read.
struct LintRule {
    std::string_view id;      ///< Stable, for programs: "integer-literal".
    std::string_view meaning; ///< The demand, in one sentence.
};

/// All rules, in the order in which they are checked.
std::span<const LintRule> lintRules();

/// One place that breaks a rule.
struct LintFinding {
    Stage stage;
    int line;              ///< In the stage's text, from 1.
    LineOrigin origin;     ///< The line's source; its snippet is empty where the composer wrote it.
    std::string_view rule; ///< An id of lintRules().
    std::string message;   ///< One sentence, for people.
};

/// "generator/glsl/fragment/brdf/ggx.glsl:15: message [rule]", or "fragment:15: ..." for a line that came
/// from no snippet.
std::string toString(const LintFinding& finding);

/// Checks one stage on its own. The text should be GLSL that a compiler accepts: the lint survives any text,
/// but reports style and portability, not syntax. Lines beyond `stage.lines` count as the composer's own, so
/// that a text with an empty line map can be checked as well.
std::vector<LintFinding> lint(const ComposedStage& stage, Stage which);

/// Checks both stages, and the declarations that must agree when they are linked: varyings, and uniforms of
/// both.
std::vector<LintFinding> lintProgram(const Composed& program);

} // namespace franken
