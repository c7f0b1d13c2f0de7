// SPDX-License-Identifier: MIT
#include "franken/generator/snippet_set.h"

#include "effect_rules.h"
#include "library.h"

#include <algorithm>
#include <cassert>
#include <map>

namespace franken {
namespace {

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

/// By name; arrays of several lengths may have one.
const std::multimap<std::string, Declaration>& builtInDeclarations() {
    static const std::multimap<std::string, Declaration> all = [] {
        std::multimap<std::string, Declaration> declarations;
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
        const auto [begin, end] = builtInDeclarations().equal_range(name);
        const bool isKnown = std::any_of(begin, end, [&](const auto& known) {
            return known.second.kind == declaration.kind && known.second.type == declaration.type &&
                   known.second.count == declaration.count && known.second.block == declaration.block;
        });
        if (!isKnown)
            return Error{"snippet.interface", toString(LineOrigin{snippet.name, declaration.line}),
                         "'" + name + "' is not declared so in any snippet of this build",
                         "add it to pack.h or texture_role.h, and build again"};
    }
    return {};
}

// Whoever gave the folder finds the file by the name that he gave.
Error inFolder(Error error, const std::string& folder) {
    if (error.where.starts_with(kSnippetFolder))
        error.where = folder + error.where.substr(kSnippetFolder.size());
    return error;
}

} // namespace

const SnippetSet& SnippetSet::builtIn() {
    static const SnippetSet set = [] {
        auto parts = std::make_shared<Parts>();
        parts->folder = kSnippetFolder;
        parts->builtIn = true;
        for (std::uint8_t row = 0; row < recipe().size(); ++row)
            parts->rows.push_back(makeParts(row, builtInSnippets()[row]));
        return SnippetSet(std::move(parts));
    }();
    return set;
}

std::vector<std::string> SnippetSet::names() {
    std::vector<std::string> names;
    for (const SnippetFile& file : embeddedSnippets())
        names.emplace_back(file.name);
    return names;
}

Result<SnippetSet> SnippetSet::make(const Source& source, std::string folder) {
    auto parts = std::make_shared<Parts>();
    parts->folder = std::move(folder);
    for (std::uint8_t row = 0; row < recipe().size(); ++row) {
        // Lines of programs go on naming their snippet when this text is gone: by the built-in file's name.
        const std::string_view name = builtInFile(recipe()[row]).name;
        const Result<std::string> text = source(name);
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

bool SnippetSet::isBuiltIn() const { return m_parts->builtIn; }

std::span<const Effect> SnippetSet::effects() const { return m_parts->effects; }

Result<EffectChoice> SnippetSet::chooseEffect(std::string_view name) const {
    for (std::size_t i = 0; i < effects().size(); ++i)
        if (effects()[i].name() == name)
            return effects()[i].choice(static_cast<std::uint8_t>(i + 1));
    return missingEffect("'" + std::string(name) + "'");
}

const Effect* SnippetSet::effectOf(const EffectChoice& choice) const {
    if (choice.slot == 0 || choice.slot > effects().size())
        return nullptr;
    const Effect& effect = effects()[choice.slot - 1u];
    return effect.choice(choice.slot) == choice ? &effect : nullptr;
}

Result<void> SnippetSet::check(const EffectChoice& choice) const {
    if (choice.slot != 0 && effectOf(choice) == nullptr)
        return missingEffect("in slot " + std::to_string(choice.slot));
    return {};
}

Result<SnippetSet> SnippetSet::with(const Effect& effect) const {
    const std::span<const Effect> known = effects();
    const auto same = std::find_if(known.begin(), known.end(),
                                   [&](const Effect& each) { return each.name() == effect.name(); });
    const auto slot = static_cast<std::uint8_t>(same - known.begin() + 1);
    if (slot > EffectChoice::kMaxSlot)
        return Error{"effect.many", effect.name(),
                     "there are " + std::to_string(known.size()) + " effects already",
                     "make another set for the others"};
    auto parts = std::make_shared<Parts>(*m_parts);
    if (same == known.end())
        parts->effects.push_back(effect);
    else
        parts->effects[slot - 1u] = effect;
    for (std::uint8_t row = 0; row < recipe().size(); ++row)
        if (recipe()[row].each == Each::Effect) {
            parts->rows[row].resize(parts->effects.size() + 1);
            parts->rows[row][slot] = effectPart(parts->rows[row][0], effect, snippetName(recipe()[row]));
        }
    SnippetSet set(std::move(parts));
    if (Result<void> strict = checkEffectText(set, effect.choice(slot)); !strict)
        return strict.error();
    return set;
}

} // namespace franken
