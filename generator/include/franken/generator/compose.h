// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/interface.h"
#include "franken/generator/permutation.h"
#include "franken/generator/snippet_set.h"

#include <string>
#include <string_view>
#include <vector>

namespace FRANKEN_API franken {

/// Where a line of a program came from.
struct LineOrigin {
    std::string_view snippet; ///< "fragment/brdf/ggx"; empty for lines that the composer wrote itself.
    int line;                 ///< In generator/glsl/<snippet>.glsl, from 1.
    bool effect = false;      ///< `snippet` is an effect's file, as Effect::parse() was told.
};

/// The folder of the built-in snippets in FrankenShader's sources.
inline constexpr std::string_view kSnippetFolder = "generator/glsl";

/// "generator/glsl/fragment/brdf/ggx.glsl:12"; empty for a line that the composer wrote itself. `folder` is
/// where the snippets of the SnippetSet came from; an effect's file stands by itself: "fog.glsl:7".
std::string toString(const LineOrigin& origin, std::string_view folder = kSnippetFolder);

/// One shader, ready for glShaderSource, and the origin of each of its lines. Drivers misreport #line, so
/// the text holds none: look an error's line up here.
struct ComposedStage {
    std::string text;                   ///< GLSL ES 1.00, for glShaderSource().
    std::vector<LineOrigin> lines;      ///< lines[0] is line 1.
    std::string folder{kSnippetFolder}; ///< Of the snippets; errors name it.
};

/// A program: the texts of both stages, and what goes into them.
struct Composed {
    /// The two stages.
    ComposedStage vertex;
    ComposedStage fragment;
    Interface interface;
};

/// Writes the program of a canonical permutation (canonicalise first). Pure and deterministic: the same
/// bytes on every machine, from any thread. An effect that the set has not got is left out: see
/// SnippetSet::check().
Composed compose(const Permutation& permutation, const SnippetSet& snippets = SnippetSet::builtIn());

/// Adds snippets' files and lines to a driver's log: appends "<file>:<line>" to each line number that the
/// driver names. Knows the forms "0:12(5): ..." (Mesa) and "ERROR: 0:12: ..." (ANGLE, glslang).
std::string annotateLog(std::string_view log, const ComposedStage& stage);

} // namespace franken
