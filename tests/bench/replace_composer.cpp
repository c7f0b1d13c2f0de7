// SPDX-License-Identifier: MIT
#include "replace_composer.h"

#include "recipe.h"
#include "snippet.h"

#include <array>
#include <map>
#include <vector>

namespace franken::bench {
namespace {

constexpr std::string_view kDeclarations = "VARIABLES", kFunctions = "FUNCTIONS", kMain = "SHADER_CODE";

struct Sections {
    std::string declarations, functions, main;
};

// The lines between one section's marker and the next.
std::string sectionOf(std::string_view file, std::string_view marker) {
    const std::size_t at = file.find(marker);
    if (at == std::string_view::npos)
        return {};
    const std::string_view rest = file.substr(at + marker.size());
    return std::string(rest.substr(0, rest.find("//! ")));
}

const std::vector<Sections>& sections() {
    static const std::vector<Sections> all = [] {
        std::map<std::string_view, Sections> files;
        for (const SnippetFile& file : embeddedSnippets())
            files[file.name] = {sectionOf(file.text, "//! declarations\n"),
                                sectionOf(file.text, "//! functions\n"), sectionOf(file.text, "//! main\n")};
        std::vector<Sections> rows;
        for (const Row& row : recipe())
            rows.push_back(
                files[(row.stage == Stage::Vertex ? "vertex/" : "fragment/") + std::string(row.snippet)]);
        return rows;
    }();
    return all;
}

void replaceAll(std::string& text, std::string_view marker, std::string_view with) {
    for (std::size_t at = 0; (at = text.find(marker, at)) != std::string::npos; at += with.size())
        text.replace(at, marker.size(), with);
}

void insertBefore(std::string& text, std::string_view marker, const std::string& glsl) {
    if (!glsl.empty())
        replaceAll(text, marker, glsl + std::string(marker));
}

std::string headOf(const ComposedStage& stage, std::string_view end) {
    return stage.text.substr(0, stage.text.find(end) + end.size());
}

} // namespace

ReplaceComposer::ReplaceComposer(const Permutation& permutation) : m_permutation(permutation) {
    const Composed program = franken::compose(permutation);
    m_vertexHead = headOf(program.vertex, "// VERTEX SHADER\n//\n");
    m_fragmentHead = headOf(program.fragment, "// FRAGMENT SHADER\n//\n");
    sections();
}

std::string ReplaceComposer::composeStage(Stage stage, const std::string& head) const {
    constexpr std::array<std::string_view, 2> kUvs = {"vUv0", "vUv1"};
    std::string text = "HEADVARIABLESFUNCTIONS\nvoid main() {\nSHADER_CODE}\n";
    replaceAll(text, "HEAD", head);
    for (const Step& step : plan(m_permutation, stage)) {
        const Sections& section = sections()[step.row];
        insertBefore(text, kDeclarations, section.declarations);
        insertBefore(text, kFunctions, section.functions.empty() ? "" : "\n" + section.functions);
        insertBefore(text, kMain, section.main);
        const bool lamp = recipe()[step.row].each == Each::Lamp;
        replaceAll(text, "${light}", (lamp ? "Lamp" : "Sun") + std::to_string(step.light));
        replaceAll(text, "${lane}", std::string_view("xyzw").substr(step.light, 1));
        replaceAll(text, "${uv}", kUvs[static_cast<std::size_t>(step.uv)]);
    }
    for (const std::string_view marker : {kDeclarations, kFunctions, kMain})
        replaceAll(text, marker, "");
    return text;
}

std::pair<std::string, std::string> ReplaceComposer::compose() const {
    return {composeStage(Stage::Vertex, m_vertexHead), composeStage(Stage::Fragment, m_fragmentHead)};
}

} // namespace franken::bench
