// SPDX-License-Identifier: MIT
#include "json.h"

#include "effects.h"
#include "franken/generator/choices.h"
#include "franken/generator/pack.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace franken::cli {
namespace {

using Json = nlohmann::ordered_json;

Json document(const char* command) { return {{"schema", kJsonSchema}, {"command", command}}; }

std::string print(const Json& json) {
    return json.dump(2, ' ', true, Json::error_handler_t::replace) + "\n"; // In ASCII: for terminals, too.
}

Json identity(const Permutation& permutation) {
    return {{"name", toName(permutation, snippets())}, {"key", toHex(toKey(permutation))}};
}

Json stagesOf(const Uniform& uniform) {
    Json stages = Json::array();
    if (uniform.vertex)
        stages.push_back("vertex");
    if (uniform.fragment)
        stages.push_back("fragment");
    return stages;
}

Json toJson(const Interface& interface) {
    Json json = {{"attributes", Json::array()},
                 {"varyings", Json::array()},
                 {"uniforms", Json::array()},
                 {"samplers", Json::array()}};
    for (const Attribute& each : interface.attributes)
        json["attributes"].push_back(
            {{"name", each.name}, {"type", toGlsl(each.type)}, {"location", each.location}});
    for (const Varying& each : interface.varyings)
        json["varyings"].push_back({{"name", each.name}, {"type", toGlsl(each.type)}});
    for (const Uniform& each : interface.uniforms)
        json["uniforms"].push_back({{"name", each.name},
                                    {"type", toGlsl(each.type)},
                                    {"count", each.count},
                                    {"block", toText(each.block)},
                                    {"offset", fieldOffset(each)},
                                    {"stages", stagesOf(each)}});
    for (const Sampler& each : interface.samplers)
        json["samplers"].push_back({{"name", each.name},
                                    {"type", toGlsl(each.type)},
                                    {"unit", each.unit},
                                    {"block", toText(each.block)}});
    return json;
}

Json toJson(const Program& program, Texts texts) {
    Json json = identity(program.permutation);
    json["vertexKey"] = toHex(stageKey(program.permutation, Stage::Vertex));
    json["fragmentKey"] = toHex(stageKey(program.permutation, Stage::Fragment));
    const bool files = texts == Texts::InFiles;
    json["vertex"] = files ? program.file + ".vert" : program.composed.vertex.text;
    json["fragment"] = files ? program.file + ".frag" : program.composed.fragment.text;
    json["interface"] = toJson(program.composed.interface);
    return json;
}

Json toJson(const std::vector<ExplainedLine>& lines) {
    Json json = Json::array();
    for (const ExplainedLine& line : lines) {
        Json each = {{"text", line.text}, {"origin", toString(line.origin)}};
        if (line.reason) {
            each["words"] = line.reason->words;
            each["needed"] = line.reason->kind == Reason::Kind::All;
        }
        json.push_back(std::move(each));
    }
    return json;
}

Json toJson(const ProfileBudget& each) {
    Json json = {{"profile", each.profile.name}, {"fits", each.budget.fits()}};
    for (const Use& use : each.budget.uses)
        json[std::string(toText(use.resource))] = {{"used", use.used}, {"limit", use.limit}};
    for (const Excess& excess : each.excesses)
        for (const Feature& feature : excess.features)
            json[std::string(toText(excess.use.resource))]["without"][feature.word] = feature.used;
    return json;
}

Json toJson(const ShaderCost& shader) {
    return {{"instructions", shader.instructions},
            {"threads", shader.threads},
            {"uniforms", shader.uniforms},
            {"temps", shader.temps},
            {"spills", shader.spills},
            {"fills", shader.fills}};
}

Json modelsOf(const Gpu& gpu, int instructions) {
    Json models = Json::array();
    for (const PiModel& model : gpu.models)
        models.push_back({{"model", model.name},
                          {"megahertz", model.megahertz},
                          {"megapixelsPerSecond", megapixelsPerSecond(gpu, model, instructions)}});
    return models;
}

Json toJson(const std::vector<Finding>& findings) {
    Json json = Json::array();
    for (const Finding& each : findings)
        json.push_back({{"program", each.program},
                        {"check", each.check},
                        {"where", each.where},
                        {"what", each.what},
                        {"remedy", each.remedy}});
    return json;
}

Json toJson(const Gpu& gpu, const Priced& priced) {
    Json json = {{"name", toName(priced.asked, snippets())},
                 {"gpu", gpu.name},
                 {"measured", toName(priced.measured, snippets())}};
    if (!priced.cost.measured()) {
        json["error"] = priced.cost.error;
        return json;
    }
    json["fragment"] = toJson(priced.cost.fragment);
    json["vertex"] = toJson(priced.cost.vertex);
    json["coordinate"] = toJson(priced.cost.coordinate);
    json["atMost"] = modelsOf(gpu, priced.cost.fragment.instructions);
    // Null: they never pay. Without the member, there is one way only.
    if (priced.breakEven)
        json["vertexLightPaysFromPixels"] = std::isinf(*priced.breakEven) ? Json() : Json(*priced.breakEven);
    return json;
}

} // namespace

std::string listJson(const std::vector<Permutation>& listed, const Selected& selected) {
    Json json = document("list");
    json["count"] = selected.count;
    json["complete"] = selected.complete;
    json["product"] = selected.product;
    json["permutations"] = Json::array();
    for (const Permutation& permutation : listed)
        json["permutations"].push_back(identity(permutation));
    return print(json);
}

std::string wordsJson() {
    Json json = document("list");
    json["choices"] = Json::array();
    for (const Choice& choice : choices()) {
        Json options = Json::array();
        for (const Option& option : choice.options)
            options.push_back({{"word", option.word}, {"meaning", option.meaning}});
        json["choices"].push_back({{"name", choice.name}, {"options", std::move(options)}});
    }
    return print(json);
}

std::string DumpJson::begin() const {
    const std::string empty = print(document("dump"));
    return empty.substr(0, empty.rfind('\n', empty.size() - 2)) + ",\n  \"programs\": [";
}

std::string DumpJson::program(const Program& program) {
    std::string text = (m_first ? "\n    " : ",\n    ");
    m_first = false;
    const std::string json = print(toJson(program, m_texts));
    for (const char c : std::string_view(json).substr(0, json.size() - 1))
        text += c == '\n' ? "\n    " : std::string(1, c);
    return text;
}

std::string DumpJson::end() const { return m_first ? "]\n}\n" : "\n  ]\n}\n"; }

std::string explainJson(const Explanation& explanation) {
    Json json = document("explain");
    json.update(identity(explanation.program.permutation));
    json["dropped"] = Json::array();
    for (const Dropped& dropped : explanation.dropped)
        json["dropped"].push_back({{"word", dropped.word}, {"reason", dropped.reason}});
    json["budgets"] = Json::array();
    for (const ProfileBudget& each : explanation.budgets)
        json["budgets"].push_back(toJson(each));
    json["vertex"] = toJson(explanation.vertex);
    json["fragment"] = toJson(explanation.fragment);
    return print(json);
}

std::string diffJson(const Program& first, const Program& second, const std::string& vertex,
                     const std::string& fragment) {
    Json json = document("diff");
    json["first"] = identity(first.permutation);
    json["second"] = identity(second.permutation);
    json["same"] = vertex.empty() && fragment.empty();
    json["vertex"] = vertex;
    json["fragment"] = fragment;
    return print(json);
}

std::string diffFolderJson(const std::string& folder, const std::vector<FolderProgram>& programs) {
    Json json = document("diff");
    json["against"] = folder;
    json["same"] =
        std::all_of(programs.begin(), programs.end(), [](const auto& each) { return each.same(); });
    json["programs"] = Json::array();
    for (const FolderProgram& each : programs) {
        Json program = {{"name", each.name}, {"vertex", each.vertex}, {"fragment", each.fragment}};
        if (!each.refused.empty())
            program["refused"] = each.refused;
        json["programs"].push_back(std::move(program));
    }
    return print(json);
}

std::string checkJson(std::size_t programs, const std::vector<std::string>& profiles, bool glslangAsked,
                      const std::vector<Finding>& findings) {
    Json json = document("check");
    json["programs"] = programs;
    json["profiles"] = profiles;
    json["glslangAsked"] = glslangAsked;
    json["findings"] = toJson(findings);
    return print(json);
}

std::string costJson(const std::vector<Bill>& bills, const std::optional<GateFindings>& gate) {
    Json json = document("cost");
    json["costs"] = Json::array();
    for (const Bill& bill : bills)
        for (const Priced& priced : bill.priced)
            json["costs"].push_back(toJson(bill.gpu, priced));
    if (gate)
        json["findings"] = toJson(gate->findings);
    return print(json);
}

std::string errorsJson(const std::vector<Error>& errors) {
    Json json = {{"schema", kJsonSchema}, {"errors", Json::array()}};
    for (const Error& each : errors)
        json["errors"].push_back(
            {{"code", each.code}, {"where", each.where}, {"what", each.what}, {"remedy", each.remedy}});
    return print(json);
}

} // namespace franken::cli
