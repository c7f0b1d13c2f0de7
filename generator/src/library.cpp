// SPDX-License-Identifier: MIT
#include "library.h"

namespace franken {
namespace {

constexpr std::string_view kSuns[] = {"Sun0", "Sun1", "Sun2", "Sun3"};
constexpr std::string_view kPunctualLights[] = {"Punctual0", "Punctual1", "Punctual2", "Punctual3"};
constexpr std::string_view kLanes[] = {"x", "y", "z", "w"};
static_assert(std::size(kLanes) >= Permutation::kMaxLights &&
              Permutation::kMaxInfluences <= Permutation::kMaxLights);
constexpr std::string_view kUvs[] = {"vUv0", "vUv1"};

std::string_view replacement(Placeholder placeholder, const Step& step) {
    switch (placeholder) {
    case Placeholder::Light:
        return recipe()[step.row].each == Each::Punctual ? kPunctualLights[step.light] : kSuns[step.light];
    case Placeholder::Lane:
        return kLanes[step.light];
    case Placeholder::Uv:
        return kUvs[static_cast<std::size_t>(step.uv)];
    case Placeholder::Call:
        return kCall;
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
    const std::string name = declaredName(declaration, step);
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

Group groupOf(const Declaration& declaration) {
    if (declaration.kind == Declaration::Kind::Attribute)
        return Group::Attributes;
    if (declaration.kind == Declaration::Kind::Varying)
        return Group::Varyings;
    if (componentCount(declaration.type) == 0)
        return Group::Samplers;
    switch (declaration.block) {
    case Block::Frame:
        return Group::FrameUniforms;
    case Block::Lights:
        return Group::LightsUniforms;
    case Block::Material:
        return Group::MaterialUniforms;
    case Block::Skin:
        return Group::SkinUniforms;
    case Block::User:
        return Group::UserUniforms;
    case Block::Object:
        break;
    }
    return Group::ObjectUniforms;
}

// Lines that declare nothing are about precision.
Group groupOfLine(const Snippet& snippet, int line) {
    for (const Declaration& declaration : snippet.interface)
        if (declaration.line == line)
            return groupOf(declaration);
    return Group::Precision;
}

Part::Section filled(const Section& from, const Step& step) { return {fill(from.pieces, step), from.lines}; }

std::array<Part::Section, kGroups> grouped(const Snippet& snippet, const Step& step) {
    std::array<Part::Section, kGroups> groups;
    const Part::Section all = filled(snippet.declarations, step);
    std::string_view text = all.text;
    for (const LineOrigin& origin : all.lines) {
        const std::size_t end = text.find('\n') + 1;
        Part::Section& group = groups[static_cast<std::size_t>(groupOfLine(snippet, origin.line))];
        group.text.append(text.substr(0, end));
        group.lines.push_back(origin);
        text.remove_prefix(end);
    }
    return groups;
}

Part makePart(const Snippet& snippet, const Step& step) {
    Part part{grouped(snippet, step), filled(snippet.functions, step), filled(snippet.main, step), {}};
    for (const Declaration& declaration : snippet.interface)
        addDeclaration(part.interface, declaration, step);
    return part;
}

std::size_t streamCount(const Row& row) { return row.uv ? 2 : 1; }

} // namespace

std::string snippetName(const Row& row) {
    return (row.stage == Stage::Vertex ? "vertex/" : "fragment/") + std::string(row.snippet);
}

std::string_view concernOf(const Row& row) { return row.snippet.substr(0, row.snippet.find('/')); }

std::string declaredName(const Declaration& declaration, const Step& step) {
    return fill(declaration.name, step);
}

std::vector<Part> makeParts(std::uint8_t row, const Snippet& snippet) {
    const Row& r = recipe()[row];
    std::vector<Part> parts;
    for (std::uint8_t light = 0; light < (r.each == Each::Once ? 1 : Permutation::kMaxLights); ++light)
        for (std::size_t uv = 0; uv < streamCount(r); ++uv)
            parts.push_back(makePart(snippet, {row, light, static_cast<UvStream>(uv)}));
    return parts;
}

const Part& partOf(const SnippetSet& snippets, const Step& step) {
    const std::size_t streams = streamCount(recipe()[step.row]);
    return snippets.parts().rows[step.row][step.light * streams + static_cast<std::size_t>(step.uv)];
}

} // namespace franken
