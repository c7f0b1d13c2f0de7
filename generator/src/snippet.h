// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/compose.h"
#include "franken/result.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace franken {

/// A file of GLSL as it was embedded or read.
struct SnippetFile {
    std::string_view name; ///< "fragment/brdf/ggx"
    std::string_view text;
};

/// The files below generator/glsl, embedded by the build.
std::span<const SnippetFile> embeddedSnippets();

/// What ${...} in a line stands for.
enum class Placeholder : std::uint8_t { None, Light, Lane, Uv, Call };

/// Literal text, then a placeholder.
struct Piece {
    std::string_view text;
    Placeholder placeholder;
};

/// A section's text, line ends included, and where its lines stand.
struct Section {
    std::vector<Piece> pieces;
    std::vector<LineOrigin> lines;
};

/// "uniform vec3 uAmbient; // lights: linear radiance", taken apart. The name may hold placeholders.
struct Declaration {
    enum class Kind : std::uint8_t { Attribute, Varying, Uniform } kind;
    Type type;
    Block block;
    int count; ///< Array length, 1 for what is none.
    std::vector<Piece> name;
    int line; ///< In its file, from 1.
};

/// One parsed file: see generator/README.md for the contract.
struct Snippet {
    std::string_view name;
    Section declarations, functions, main;
    std::vector<Declaration> interface;
};

/// Parses a file; an error says file and line. The text must outlive the snippet.
Result<Snippet> parseSnippet(const SnippetFile& file);

} // namespace franken
