// SPDX-License-Identifier: MIT
#include "snippet.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

namespace franken {
namespace {

constexpr std::array<std::pair<std::string_view, Placeholder>, 4> kPlaceholders = {
    {{"light", Placeholder::Light},
     {"lane", Placeholder::Lane},
     {"uv", Placeholder::Uv},
     {"call", Placeholder::Call}}};

Error badLine(std::string_view file, int line, std::string what) {
    return {"snippet.syntax", toString(LineOrigin{file, line}), std::move(what),
            "see generator/README.md for the contract of a snippet"};
}

std::optional<Placeholder> findPlaceholder(std::string_view word) {
    for (const auto& [name, placeholder] : kPlaceholders)
        if (name == word)
            return placeholder;
    return std::nullopt;
}

std::optional<std::vector<Piece>> parsePieces(std::string_view text) {
    std::vector<Piece> pieces;
    while (true) {
        const std::size_t open = text.find("${");
        if (open == std::string_view::npos)
            return pieces.push_back({text, Placeholder::None}), pieces;
        const std::size_t close = text.find('}', open);
        const auto placeholder = findPlaceholder(text.substr(open + 2, close - open - 2));
        if (close == std::string_view::npos || !placeholder)
            return std::nullopt;
        pieces.push_back({text.substr(0, open), *placeholder});
        text.remove_prefix(close + 1);
    }
}

std::string_view takeWord(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    const std::string_view word = text.substr(0, text.find_first_of(" ;[\n"));
    text.remove_prefix(word.size());
    return word;
}

std::optional<Type> findType(std::string_view word) {
    for (int type = 0; type <= static_cast<int>(Type::SamplerCube); ++type)
        if (toGlsl(static_cast<Type>(type)) == word)
            return static_cast<Type>(type);
    return std::nullopt;
}

std::optional<Block> findBlock(std::string_view comment) {
    for (int block = 0; block <= static_cast<int>(Block::Skin); ++block) {
        const std::string_view name = toText(static_cast<Block>(block));
        if (comment.starts_with(name) && comment.substr(name.size()).starts_with(':'))
            return static_cast<Block>(block);
    }
    return std::nullopt;
}

std::optional<Declaration::Kind> findKind(std::string_view line) {
    if (line.starts_with("attribute "))
        return Declaration::Kind::Attribute;
    if (line.starts_with("varying "))
        return Declaration::Kind::Varying;
    if (line.starts_with("uniform "))
        return Declaration::Kind::Uniform;
    return std::nullopt;
}

// Of "[9];": 9. 1 where there is no array, 0 for what is no length.
int takeCount(std::string_view rest) {
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    if (!rest.starts_with('['))
        return 1;
    const std::string_view length = rest.substr(1, rest.find(']') - 1);
    int count = 0;
    const auto [end, failed] = std::from_chars(length.data(), length.data() + length.size(), count);
    const bool whole = rest.find(']') != rest.npos && end == length.data() + length.size();
    return failed == std::errc() && whole && count > 0 ? count : 0;
}

Result<Declaration> parseDeclaration(std::string_view line, Declaration::Kind kind, std::string_view file,
                                     int number) {
    std::string_view rest = line;
    takeWord(rest);
    std::string_view typeWord = takeWord(rest);
    if (typeWord == "mediump")
        typeWord = takeWord(rest);
    const auto type = findType(typeWord);
    const std::string_view name = takeWord(rest);
    const auto pieces = parsePieces(name);
    if (!type || name.empty() || !pieces)
        return badLine(file, number, "a declaration needs a type and a name");
    Declaration declaration{kind, *type, Block::Frame, 1, *pieces, number};
    declaration.count = takeCount(rest);
    if (declaration.count == 0)
        return badLine(file, number, "the length of an array is a number from 1, as in 'uName[9]'");
    if (kind == Declaration::Kind::Uniform) {
        const std::size_t comment = rest.find("// ");
        const auto block =
            comment == std::string_view::npos ? std::nullopt : findBlock(rest.substr(comment + 3));
        if (!block)
            return badLine(file, number, "a uniform needs a comment '// block: meaning'");
        declaration.block = *block;
    }
    return declaration;
}

Section* findSection(Snippet& snippet, std::string_view marker) {
    if (marker == "//! declarations")
        return &snippet.declarations;
    if (marker == "//! functions")
        return &snippet.functions;
    return marker == "//! main" ? &snippet.main : nullptr;
}

// Text without placeholders runs on from line to line: the lines are neighbours in the file.
void addPieces(Section& section, const std::vector<Piece>& line) {
    for (const Piece& piece : line)
        if (!section.pieces.empty() && section.pieces.back().placeholder == Placeholder::None) {
            const std::string_view before = section.pieces.back().text;
            section.pieces.back() = {{before.data(), before.size() + piece.text.size()}, piece.placeholder};
        } else {
            section.pieces.push_back(piece);
        }
}

Result<void> addLine(Snippet& snippet, Section& section, std::string_view line, int number) {
    const auto pieces = parsePieces(line);
    if (!pieces)
        return badLine(snippet.name, number, "the placeholders are ${light}, ${lane}, ${uv} and ${call}");
    addPieces(section, *pieces);
    section.lines.push_back({snippet.name, number});
    const auto kind = &section == &snippet.declarations ? findKind(line) : std::nullopt;
    if (!kind)
        return {};
    return parseDeclaration(line, *kind, snippet.name, number).transform([&](Declaration declaration) {
        snippet.interface.push_back(std::move(declaration));
    });
}

} // namespace

Result<Snippet> parseSnippet(const SnippetFile& file) {
    Snippet snippet{file.name, {}, {}, {}, {}};
    Section* section = nullptr;
    int number = 0;
    for (std::string_view text = file.text; !text.empty();) {
        const std::size_t end = text.find('\n');
        const std::string_view line = text.substr(0, end);
        ++number;
        if (end == std::string_view::npos)
            return badLine(file.name, number, "the last line does not end");
        if (line.starts_with("//!")) {
            section = findSection(snippet, line);
            if (!section)
                return badLine(file.name, number, "the sections are declarations, functions and main");
        } else if (section) {
            if (auto added = addLine(snippet, *section, text.substr(0, end + 1), number); !added)
                return added.error();
        } else if (!line.starts_with("//")) {
            return badLine(file.name, number, "GLSL before the first section");
        }
        text.remove_prefix(end + 1);
    }
    return snippet;
}

} // namespace franken
