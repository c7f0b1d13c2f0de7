// SPDX-License-Identifier: MIT
#include "franken/generator/snippet_set.h"

#include "franken/printable.h"
#include "library.h"

#include <algorithm>
#include <cassert>
#include <fstream>
#include <map>

namespace franken {
namespace {

constexpr std::size_t kMaxFileBytes = std::size_t{64} * 1024;

const SnippetFile& builtInFile(const Row& row) {
    const std::span<const SnippetFile> files = embeddedSnippets();
    const auto file = std::find_if(files.begin(), files.end(),
                                   [name = snippetName(row)](const auto& f) { return f.name == name; });
    assert(file != files.end() && "a row of the recipe names a snippet that is not embedded");
    return *file;
}

// By row.
const std::vector<Snippet>& builtInSnippets() {
    static const std::vector<Snippet> all = [] {
        std::vector<Snippet> snippets;
        for (const Row& row : recipe()) {
            Result<Snippet> snippet = parseSnippet(builtInFile(row));
            assert(snippet && "a test parses all embedded snippets");
            snippets.push_back(*std::move(snippet));
        }
        return snippets;
    }();
    return all;
}

std::string firstName(const Declaration& declaration, std::uint8_t row) {
    return declaredName(declaration, {row, 0, UvStream::Uv0});
}

const std::map<std::string, Declaration>& builtInDeclarations() {
    static const std::map<std::string, Declaration> all = [] {
        std::map<std::string, Declaration> declarations;
        for (std::uint8_t row = 0; row < recipe().size(); ++row)
            for (const Declaration& declaration : builtInSnippets()[row].interface)
                declarations.emplace(firstName(declaration, row), declaration);
        return declarations;
    }();
    return all;
}

Result<void> checkInterface(const Snippet& snippet, std::uint8_t row) {
    for (const Declaration& declaration : snippet.interface) {
        if (declaration.kind == Declaration::Kind::Varying)
            continue;
        const std::string name = firstName(declaration, row);
        const auto known = builtInDeclarations().find(name);
        if (known == builtInDeclarations().end() || known->second.kind != declaration.kind ||
            known->second.type != declaration.type || known->second.count != declaration.count ||
            known->second.block != declaration.block)
            return Error{"snippet.interface", toString(LineOrigin{snippet.name, declaration.line}),
                         "'" + name + "' is not declared so in any snippet of this build",
                         "give it a place in pack.h or interface.h, and build"};
    }
    return {};
}

Result<std::string> readText(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string text(kMaxFileBytes + 1, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
    if (!file.eof() || text.empty())
        return Error{"snippet.file", path.string(), "cannot be read, is empty or is larger than 64 KiB",
                     "give a folder that is laid out as generator/glsl is"};
    return std::string(withoutByteOrderMark(text));
}

// Whoever gave the folder finds the file by the name that he gave.
Error inFolder(Error error, const std::filesystem::path& folder) {
    if (error.where.starts_with(kSnippetFolder))
        error.where = folder.string() + error.where.substr(kSnippetFolder.size());
    return error;
}

} // namespace

const SnippetSet& SnippetSet::builtIn() {
    static const SnippetSet set = [] {
        auto parts = std::make_shared<Parts>();
        parts->folder = kSnippetFolder;
        for (std::uint8_t row = 0; row < recipe().size(); ++row)
            parts->rows.push_back(makeParts(row, builtInSnippets()[row]));
        return SnippetSet(std::move(parts));
    }();
    return set;
}

Result<SnippetSet> SnippetSet::read(const std::filesystem::path& folder) {
    auto parts = std::make_shared<Parts>();
    parts->folder = folder.string();
    while (parts->folder.size() > 1 && parts->folder.ends_with('/'))
        parts->folder.pop_back();
    for (std::uint8_t row = 0; row < recipe().size(); ++row) {
        // Lines of programs go on naming their snippet when this text is gone: by the built-in file's name.
        const std::string_view name = builtInFile(recipe()[row]).name;
        const Result<std::string> text = readText(folder / (std::string(name) + ".glsl"));
        if (!text)
            return text.error();
        const Result<Snippet> snippet = parseSnippet({name, *text});
        if (!snippet)
            return inFolder(snippet.error(), parts->folder);
        if (const Result<void> checked = checkInterface(*snippet, row); !checked)
            return inFolder(checked.error(), parts->folder);
        parts->rows.push_back(makeParts(row, *snippet));
    }
    return SnippetSet(std::move(parts));
}

} // namespace franken
