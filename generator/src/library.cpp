// SPDX-License-Identifier: MIT
#include "library.h"

#include "recipe.h"

#include <cassert>

namespace franken {
namespace {

Snippet load(const Row& row) {
    const std::string name =
        (row.stage == Stage::Vertex ? "vertex/" : "fragment/") + std::string(row.snippet);
    for (const SnippetFile& file : embeddedSnippets())
        if (file.name == name) {
            auto snippet = parseSnippet(file);
            assert(snippet && "a test parses all embedded snippets");
            return std::move(*snippet);
        }
    assert(false && "a row of the recipe names a snippet that is not embedded");
    return {};
}

std::vector<Snippet> loadAll() {
    std::vector<Snippet> snippets;
    for (const Row& row : recipe())
        snippets.push_back(load(row));
    return snippets;
}

} // namespace

const Snippet& snippetOf(std::size_t row) {
    static const std::vector<Snippet> snippets = loadAll();
    return snippets[row];
}

} // namespace franken
