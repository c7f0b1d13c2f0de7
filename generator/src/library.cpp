// SPDX-License-Identifier: MIT
#include "library.h"

#include <cassert>

namespace franken {
namespace {

constexpr std::string_view kSuns[] = {"Sun0", "Sun1", "Sun2", "Sun3"};
constexpr std::string_view kLamps[] = {"Lamp0", "Lamp1", "Lamp2", "Lamp3"};
constexpr std::string_view kLanes[] = {"x", "y", "z", "w"};
constexpr std::string_view kUvs[] = {"vUv0", "vUv1"};

std::string_view replacement(Placeholder placeholder, const Step& step) {
    switch (placeholder) {
    case Placeholder::Light:
        return recipe()[step.row].each == Each::Lamp ? kLamps[step.light] : kSuns[step.light];
    case Placeholder::Lane:
        return kLanes[step.light];
    case Placeholder::Uv:
        return kUvs[static_cast<std::size_t>(step.uv)];
    case Placeholder::None:
        break;
    }
    return {};
}

std::string fill(const std::vector<Piece>& pieces, const Step& step) {
    std::string text;
    for (const Piece& piece : pieces)
        text.append(piece.text).append(replacement(piece.placeholder, step));
    return text;
}

void addDeclaration(Interface& interface, const Declaration& declaration, const Step& step) {
    const std::string name = fill(declaration.name, step);
    const bool vertex = recipe()[step.row].stage == Stage::Vertex;
    if (declaration.kind == Declaration::Kind::Attribute)
        interface.attributes.push_back({name, declaration.type, attributeLocation(name)});
    else if (declaration.kind == Declaration::Kind::Varying && vertex)
        interface.varyings.push_back({name, declaration.type});
    else if (declaration.kind == Declaration::Kind::Uniform && componentCount(declaration.type) == 0)
        interface.samplers.push_back({name, declaration.type, samplerUnit(name), declaration.block});
    else if (declaration.kind == Declaration::Kind::Uniform)
        interface.uniforms.push_back(
            {name, declaration.type, declaration.count, declaration.block, vertex, !vertex});
}

Part makePart(const Snippet& snippet, const Step& step) {
    const auto section = [&](const Section& from) {
        return Part::Section{fill(from.pieces, step), from.lines};
    };
    Part part{
        snippet.name, section(snippet.declarations), section(snippet.functions), section(snippet.main), {}};
    for (const Declaration& declaration : snippet.interface)
        addDeclaration(part.interface, declaration, step);
    return part;
}

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

std::size_t streamCount(const Row& row) { return row.uv ? 2 : 1; }

// By row, then by light, then by stream.
std::vector<std::vector<Part>> makeAll() {
    std::vector<std::vector<Part>> all;
    for (std::uint8_t row = 0; row < recipe().size(); ++row) {
        const Row& r = recipe()[row];
        const Snippet snippet = load(r);
        std::vector<Part>& parts = all.emplace_back();
        for (std::uint8_t light = 0; light < (r.each == Each::Once ? 1 : Permutation::kMaxLights); ++light)
            for (std::size_t uv = 0; uv < streamCount(r); ++uv)
                parts.push_back(makePart(snippet, {row, light, static_cast<UvStream>(uv)}));
    }
    return all;
}

} // namespace

const Part& partOf(const Step& step) {
    static const std::vector<std::vector<Part>> all = makeAll();
    const std::size_t streams = streamCount(recipe()[step.row]);
    return all[step.row][step.light * streams + static_cast<std::size_t>(step.uv)];
}

} // namespace franken
