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

class Writer {
public:
    explicit Writer(ComposedStage& stage) : m_stage(stage) {
        m_stage.text.reserve(8192);
        m_stage.lines.reserve(192);
    }

    void own(std::initializer_list<std::string_view> line) {
        for (const std::string_view part : line)
            m_stage.text.append(part);
        m_stage.text.push_back('\n');
        m_stage.lines.push_back({{}, 0});
    }
    void own(std::string_view line) { own({line}); }

    void section(const Part::Section& section) {
        m_stage.text.append(section.text);
        m_stage.lines.insert(m_stage.lines.end(), section.lines.begin(), section.lines.end());
    }

    /// The same, but a line that stands already is left out: two hooks may read what an effect declares once.
    void declarations(const Part::Section& section) {
        std::string_view text = section.text;
        for (const LineOrigin& origin : section.lines) {
            const std::string_view line = text.substr(0, text.find('\n') + 1);
            text.remove_prefix(line.size());
            if (origin.effect && m_stage.text.find(line) != std::string::npos)
                continue;
            m_stage.text.append(line);
            m_stage.lines.push_back(origin);
        }
    }

private:
    ComposedStage& m_stage;
};

void writeFlag(Writer& writer, std::string_view name, std::string_view value) {
    writer.own({"//   ", name, ": ", value});
}

// What a vertex shader does, one snippet a line: "//   normal: 1", "//   sun_tangent: 2". Not the choices
// that brought it: many programs share one vertex shader.
void writeVertexFlags(Writer& writer, const std::vector<Step>& steps) {
    static constexpr std::string_view kTimes[] = {"0", "1", "2", "3", "4"};
    static_assert(std::size(kTimes) == Permutation::kMaxLights + 1);
    for (const Step& step : steps)
        if (isFirst(step))
            writeFlag(writer, recipe()[step.row].snippet,
                      kTimes[std::count_if(steps.begin(), steps.end(),
                                           [&](const Step& other) { return other.row == step.row; })]);
}

// The choices that are not the default, one a line: "//   normal: 1", "//   brdf: seed".
void writeFragmentFlags(Writer& writer, const Permutation& permutation, const SnippetSet& snippets) {
    for (const Choice& choice : choices())
        if (const unsigned value = choice.get(permutation); value != 0)
            writeFlag(writer, choice.name, choice.options.size() == 2 ? "1" : choice.options[value].word);
    if (const Effect* const effect = snippets.effectOf(permutation.effect); effect != nullptr)
        writeFlag(writer, "effect", effect->name());
}

void writeHeader(Writer& writer, const Permutation& permutation, const SnippetSet& snippets, Stage stage,
                 const std::vector<Step>& steps) {
    writer.own("#version 100");
    if (stage == Stage::Vertex) {
        writer.own("// FrankenShader");
        writeVertexFlags(writer, steps);
    } else {
        const Permutation choices = fragmentChoices(permutation);
        writer.own({"// FrankenShader ", toName(choices, snippets)});
        writeFragmentFlags(writer, choices, snippets);
    }
    writer.own("//");
    writer.own(stage == Stage::Vertex ? "// VERTEX SHADER" : "// FRAGMENT SHADER");
    writer.own("//");
}

bool isUniform(Group group) { return group >= Group::FrameUniforms && group <= Group::UserUniforms; }

// Attributes, varyings, uniforms block by block, samplers; a blank line between the kinds.
void writeDeclarations(Writer& writer, const std::vector<const Part*>& parts) {
    std::optional<Group> before;
    for (std::size_t i = 0; i < kGroups; ++i)
        for (const Part* part : parts) {
            if (part->declarations[i].lines.empty())
                continue;
            const auto group = static_cast<Group>(i);
            if (before && *before != group && !(isUniform(*before) && isUniform(group)))
                writer.own("");
            before = group;
            writer.declarations(part->declarations[i]);
        }
}

void writeFunctions(Writer& writer, const std::vector<const Part*>& parts) {
    for (const Part* part : parts)
        if (!part->functions.lines.empty()) {
            writer.own("");
            writer.section(part->functions);
        }
}

// A blank line wherever another concern begins.
void writeMain(Writer& writer, const std::vector<const Part*>& parts, const std::vector<Step>& steps) {
    writer.own("");
    writer.own("void main() {");
    std::string_view concern;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i]->main.lines.empty())
            continue;
        const std::string_view next = concernOf(recipe()[steps[i].row]);
        if (!concern.empty() && next != concern)
            writer.own("");
        concern = next;
        writer.section(parts[i]->main);
    }
    writer.own("}");
}

void addUniform(Interface& interface, const Uniform& uniform) {
    for (Uniform& known : interface.uniforms)
        if (known.name == uniform.name) {
            known.vertex = known.vertex || uniform.vertex;
            known.fragment = known.fragment || uniform.fragment;
            return;
        }
    interface.uniforms.push_back(uniform);
}

void addInterface(Interface& interface, const Interface& part) {
    const auto append = [](auto& all, const auto& more) { all.insert(all.end(), more.begin(), more.end()); };
    append(interface.attributes, part.attributes);
    append(interface.varyings, part.varyings);
    append(interface.samplers, part.samplers);
    for (const Uniform& uniform : part.uniforms)
        addUniform(interface, uniform);
}

void composeStage(const Permutation& permutation, const SnippetSet& snippets, Stage stage, ComposedStage& out,
                  Interface& interface) {
    const std::vector<Step> steps = plan(permutation, stage);
    std::vector<const Part*> parts;
    parts.reserve(steps.size());
    for (const Step& step : steps)
        parts.push_back(&partOf(snippets, step));
    Writer writer(out);
    writeHeader(writer, permutation, snippets, stage, steps);
    writeDeclarations(writer, parts);
    writeFunctions(writer, parts);
    writeMain(writer, parts, steps);
    for (const Part* part : parts)
        addInterface(interface, part->interface);
    if (stage == Stage::Fragment)
        interface.lights = lightsIn(steps);
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

std::string toString(const LineOrigin& origin, std::string_view folder) {
    if (origin.snippet.empty())
        return {};
    if (origin.effect)
        return std::string(origin.snippet) + ":" + std::to_string(origin.line);
    return std::string(folder) + "/" + std::string(origin.snippet) + ".glsl:" + std::to_string(origin.line);
}

Composed compose(const Permutation& wanted, const SnippetSet& snippets) {
    Permutation permutation = wanted;
    if (snippets.effectOf(wanted.effect) == nullptr)
        permutation.effect = {};
    Composed composed;
    composed.interface.attributes.reserve(8);
    composed.interface.varyings.reserve(8);
    composed.interface.uniforms.reserve(32);
    composed.interface.samplers.reserve(8);
    composed.vertex.folder = composed.fragment.folder = snippets.parts().folder;
    composeStage(permutation, snippets, Stage::Vertex, composed.vertex, composed.interface);
    composeStage(permutation, snippets, Stage::Fragment, composed.fragment, composed.interface);
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
        if (line > 0 && line <= stage.lines.size() && !stage.lines[line - 1].snippet.empty())
            annotated += " [" + toString(stage.lines[line - 1], stage.folder) + "]";
        annotated += '\n';
    }
    return annotated;
}

} // namespace franken
