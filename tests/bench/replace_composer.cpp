// SPDX-License-Identifier: MIT
#include "replace_composer.h"

#include "canonical.h"
#include "franken/generator/choices.h"
#include "recipe.h"
#include "snippet.h"

#include <array>
#include <iterator>
#include <map>
#include <sstream>
#include <vector>

namespace franken::bench {
namespace {

constexpr std::string_view kFlags = "FLAGS", kDeclarations = "VARIABLES", kFunctions = "FUNCTIONS",
                           kMain = "SHADER_CODE";

struct Sections {
    std::string declarations, functions, main;
};

// The lines between one section's marker and the next.
std::string sectionOf(std::string_view file, std::string_view marker) {
    const std::size_t at = file.find(marker);
    if (at == std::string_view::npos)
        return {};
    const std::string_view rest = file.substr(at + marker.size());
    return (marker == "//! functions\n" ? "\n" : "") + std::string(rest.substr(0, rest.find("//! ")));
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

void insertBefore(std::string& text, std::string_view marker, const std::string& glsl, const Step& step) {
    if (glsl.empty())
        return;
    std::string piece = glsl;
    if (const Each each = recipe()[step.row].each; each != Each::Once) {
        replaceAll(piece, "${light}",
                   (each == Each::Punctual ? "Punctual" : "Sun") + std::to_string(step.light));
        replaceAll(piece, "${lane}", std::string_view("xyzw").substr(step.light, 1));
    }
    if (recipe()[step.row].uv != nullptr)
        replaceAll(piece, "${uv}", step.uv == UvStream::Uv0 ? "vUv0" : "vUv1");
    replaceAll(text, marker, piece.append(marker));
}

void insertFlag(std::string& text, std::string_view name, std::string_view value) {
    std::string line = "//   ";
    line.append(name).append(": ").append(value).append("\n").append(kFlags);
    replaceAll(text, kFlags, line);
}

void insertVertexFlags(std::string& text, const std::vector<Step>& steps) {
    std::map<std::uint8_t, int> times;
    for (const Step& step : steps)
        ++times[step.row];
    for (const auto& [row, count] : times)
        insertFlag(text, recipe()[row].snippet, std::to_string(count));
}

void insertFragmentFlags(std::string& text, const Permutation& permutation) {
    for (const Choice& choice : choices())
        if (const unsigned value = choice.get(permutation); value != 0)
            insertFlag(text, choice.name, choice.options.size() == 2 ? "1" : choice.options[value].word);
}

// Where a line of declarations stands: precision, attributes, varyings, uniforms by block, samplers.
std::size_t groupOf(const std::string& line) {
    if (line.starts_with("attribute "))
        return 1;
    if (line.starts_with("varying "))
        return 2;
    if (line.starts_with("uniform sampler"))
        return 8;
    constexpr std::string_view kBlocks[] = {
        "// frame:", "// lights:", "// material:", "// object:", "// skin:"};
    for (std::size_t block = 0; block < std::size(kBlocks); ++block)
        if (line.starts_with("uniform ") && line.find(kBlocks[block]) != std::string::npos)
            return 3 + block;
    return 0;
}

std::string grouped(const std::string& declarations) {
    std::array<std::string, 9> groups;
    std::istringstream lines(declarations);
    for (std::string line; std::getline(lines, line);)
        groups[groupOf(line)] += line + "\n";
    groups[3] += groups[4] + groups[5] + groups[6] + groups[7];
    std::string text;
    for (const std::size_t group : {0, 1, 2, 3, 8})
        if (!groups[group].empty())
            text += (text.empty() ? "" : "\n") + groups[group];
    return text;
}

std::string composeStage(const Permutation& permutation, Stage stage) {
    std::string text = "#version 100\n// FrankenShader\nFLAGS//\n// NAME SHADER\n//\n"
                       "VARIABLESFUNCTIONS\nvoid main() {\nSHADER_CODE}\n";
    replaceAll(text, "NAME", stage == Stage::Vertex ? "VERTEX" : "FRAGMENT");
    const std::vector<Step> steps = plan(permutation, stage);
    if (stage == Stage::Vertex) {
        insertVertexFlags(text, steps);
    } else {
        replaceAll(text, "// FrankenShader\n",
                   "// FrankenShader " + toName(fragmentChoices(permutation)) + "\n");
        insertFragmentFlags(text, fragmentChoices(permutation));
    }
    std::string declarations(kDeclarations);
    std::string_view concern;
    for (const Step& step : steps) {
        const Sections& section = sections()[step.row];
        insertBefore(declarations, kDeclarations, section.declarations, step);
        insertBefore(text, kFunctions, section.functions, step);
        const std::string_view snippet = recipe()[step.row].snippet;
        const std::string_view next = snippet.substr(0, snippet.find('/'));
        if (!section.main.empty()) {
            insertBefore(text, kMain, concern.empty() || next == concern ? "" : "\n", step);
            concern = next;
        }
        insertBefore(text, kMain, section.main, step);
    }
    replaceAll(declarations, kDeclarations, "");
    replaceAll(text, kDeclarations, grouped(declarations));
    for (const std::string_view marker : {kFlags, kFunctions, kMain})
        replaceAll(text, marker, "");
    return text;
}

} // namespace

std::pair<std::string, std::string> composeByReplacing(const Permutation& permutation) {
    return {composeStage(permutation, Stage::Vertex), composeStage(permutation, Stage::Fragment)};
}

} // namespace franken::bench
