// SPDX-License-Identifier: MIT
#include "franken/generator/compose.h"

#include "canonical.h"
#include "franken/generator/choices.h"
#include "library.h"
#include "recipe.h"

#include <algorithm>
#include <cctype>
#include <optional>

namespace franken {
namespace {

constexpr std::string_view kLights[] = {"Sun0", "Sun1", "Sun2", "Sun3", "Lamp0", "Lamp1", "Lamp2", "Lamp3"};
constexpr std::string_view kLanes[] = {"x", "y", "z", "w"};
constexpr std::string_view kUvs[] = {"vUv0", "vUv1"};

std::string_view replacement(Placeholder placeholder, const Step& step) {
    switch (placeholder) {
    case Placeholder::Light:
        return kLights[step.light + (recipe()[step.row].each == Each::Lamp ? Permutation::kMaxLights : 0)];
    case Placeholder::Lane:
        return kLanes[step.light];
    case Placeholder::Uv:
        return kUvs[static_cast<std::size_t>(step.uv)];
    case Placeholder::None:
        break;
    }
    return {};
}

void append(std::string& text, const std::vector<Piece>& pieces, const Step& step) {
    for (const Piece& piece : pieces)
        text.append(piece.text).append(replacement(piece.placeholder, step));
}

class Writer {
public:
    explicit Writer(ComposedStage& stage) : m_stage(stage) {
        m_stage.text.reserve(8192);
        m_stage.lines.reserve(192);
    }

    void own(std::string_view line) {
        m_stage.text.append(line).push_back('\n');
        m_stage.lines.push_back({{}, 0});
    }

    void section(const std::vector<Step>& steps, Section Snippet::*which,
                 std::optional<std::string_view> before = std::nullopt) {
        for (const Step& step : steps) {
            const Snippet& snippet = snippetOf(step.row);
            const Section& section = snippet.*which;
            if (section.lineCount == 0)
                continue;
            if (before)
                own(*before);
            append(m_stage.text, section.pieces, step);
            for (int line = 0; line < section.lineCount; ++line)
                m_stage.lines.push_back({snippet.name, section.firstLine + line});
        }
    }

private:
    ComposedStage& m_stage;
};

// The flags that are on, one a line: "//   normal: 1", "//   brdf: seed".
void writeHeader(Writer& writer, const Permutation& permutation, Stage stage) {
    writer.own("#version 100");
    writer.own("// FrankenShader");
    for (const Choice& choice : choices())
        if (const unsigned value = choice.get(permutation); value != 0) {
            const bool flag = choice.options.size() == 2;
            writer.own("//   " + std::string(choice.name) + ": " +
                       (flag ? std::string("1") : std::string(choice.options[value].word)));
        }
    writer.own("//");
    writer.own(stage == Stage::Vertex ? "// VERTEX SHADER" : "// FRAGMENT SHADER");
    writer.own("//");
}

void addUniform(Interface& interface, const Declaration& declaration, std::string name, Stage stage) {
    const auto known = std::find_if(interface.uniforms.begin(), interface.uniforms.end(),
                                    [&](const Uniform& uniform) { return uniform.name == name; });
    if (known != interface.uniforms.end()) {
        known->fragment = true;
        return;
    }
    const bool vertex = stage == Stage::Vertex;
    interface.uniforms.push_back(
        {std::move(name), declaration.type, declaration.count, declaration.block, vertex, !vertex});
}

void addDeclaration(Interface& interface, const Declaration& declaration, const Step& step, Stage stage) {
    std::string name;
    append(name, declaration.name, step);
    if (declaration.kind == Declaration::Kind::Attribute) {
        const int location = attributeLocation(name);
        interface.attributes.push_back({std::move(name), declaration.type, location});
    } else if (declaration.kind == Declaration::Kind::Varying) {
        if (stage == Stage::Vertex)
            interface.varyings.push_back({std::move(name), declaration.type});
    } else if (componentCount(declaration.type) == 0) {
        const int unit = samplerUnit(name);
        interface.samplers.push_back({std::move(name), declaration.type, unit, declaration.block});
    } else {
        addUniform(interface, declaration, std::move(name), stage);
    }
}

void composeStage(const Permutation& permutation, Stage stage, ComposedStage& out, Interface& interface) {
    const std::vector<Step> steps = plan(permutation, stage);
    Writer writer(out);
    writeHeader(writer, withoutNoOps(permutation, stage), stage);
    writer.section(steps, &Snippet::declarations);
    writer.section(steps, &Snippet::functions, "");
    writer.own("");
    writer.own("void main() {");
    writer.section(steps, &Snippet::main);
    writer.own("}");
    for (const Step& step : steps)
        for (const Declaration& declaration : snippetOf(step.row).interface)
            addDeclaration(interface, declaration, step, stage);
}

// The line number in "0:12(5): ..." or "ERROR: 0:12: ...", 0 where there is none.
int reportedLine(std::string_view message) {
    const std::size_t colon = message.find("0:");
    if (colon == std::string_view::npos)
        return 0;
    int line = 0;
    for (const char c : message.substr(colon + 2)) {
        if (!std::isdigit(static_cast<unsigned char>(c)) || line > 100000)
            break;
        line = line * 10 + (c - '0');
    }
    return line;
}

} // namespace

Composed compose(const Permutation& permutation) {
    Composed composed;
    composeStage(permutation, Stage::Vertex, composed.vertex, composed.interface);
    composeStage(permutation, Stage::Fragment, composed.fragment, composed.interface);
    return composed;
}

std::string annotateLog(std::string_view log, const ComposedStage& stage) {
    std::string annotated;
    while (!log.empty()) {
        const std::size_t end = std::min(log.find('\n'), log.size());
        const std::string_view message = log.substr(0, end);
        log.remove_prefix(std::min(end + 1, log.size()));
        annotated += message;
        const auto line = static_cast<std::size_t>(reportedLine(message));
        if (line > 0 && line <= stage.lines.size() && !stage.lines[line - 1].snippet.empty()) {
            const LineOrigin& origin = stage.lines[line - 1];
            annotated += " [generator/glsl/" + std::string(origin.snippet) +
                         ".glsl:" + std::to_string(origin.line) + "]";
        }
        annotated += '\n';
    }
    return annotated;
}

} // namespace franken
