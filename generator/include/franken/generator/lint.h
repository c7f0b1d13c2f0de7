// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/compose.h"

#include <span>

namespace FRANKEN_API franken {

/// One rule of the lint. The rules are stricter than GLSL ES 1.00 (Khronos, revision 17): they also forbid
/// what the language allows but some driver on a Raspberry Pi class GPU refuses, or what a person who reads
/// the text would stumble over.
struct LintRule {
    std::string_view id;      ///< Stable, for programs: "integer-literal".
    std::string_view meaning; ///< One sentence: what is demanded.
};

/// All rules, in the order in which they are checked.
std::span<const LintRule> lintRules();

/// One place that breaks a rule.
struct LintFinding {
    Stage stage;
    int line;              ///< In the stage's text, from 1.
    LineOrigin origin;     ///< Whence that line came; an empty snippet where the composer wrote it.
    std::string_view rule; ///< An id of lintRules().
    std::string message;   ///< One sentence, for people.
};

/// "generator/glsl/fragment/brdf/ggx.glsl:15: message [rule]", or "fragment:15: ..." for a line that came from
/// no snippet.
std::string toString(const LintFinding& finding);

/// Checks one stage on its own. The text is taken as GLSL that a compiler accepts: the lint finds its way
/// through any text without failing, but it reports style and portability, not syntax. Lines beyond
/// `stage.lines` count as the composer's own, so a bare text with an empty line map may be checked too.
std::vector<LintFinding> lint(const ComposedStage& stage, Stage which);

/// Checks both stages, and what they must agree on to be linked: varyings, and uniforms that both declare.
std::vector<LintFinding> lintProgram(const Composed& program);

} // namespace franken
