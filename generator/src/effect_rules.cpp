// SPDX-License-Identifier: MIT
#include "effect_rules.h"

#include "franken/generator/choices.h"
#include "snippet.h"

#include <algorithm>
#include <array>
#include <set>

namespace franken {
namespace {

constexpr std::size_t kMaxNameSize = 32;
constexpr unsigned kAnyHook = kVertexHook | kBaseColorHook | kSurfaceHook | kLightHook;

/// A parameter that a hook's function can take, and what is handed to it.
struct Input {
    EffectTrait hook;
    std::string_view parameter; ///< As it must be written.
    std::string_view argument;  ///< In main.
    unsigned trait = 0;         ///< That it asks for.
};

constexpr std::array<Input, 9> kInputs = {{
    {kVertexHook, "vec3 position", "position"},
    {kBaseColorHook, "vec4 base", "base"},
    {kSurfaceHook, "inout vec3 normal", "normal"},
    {kSurfaceHook, "inout float metallic", "metallic", kSurfaceChangesMetallic},
    {kSurfaceHook, "inout float roughness", "roughness", kSurfaceChangesRoughness},
    {kSurfaceHook, "vec3 toEye", "toEye", kSurfaceReadsToEye},
    {kLightHook, "vec3 color", "color"},
    {kLightHook, "vec3 normal", "normal", kLightReadsNormal},
    {kLightHook, "vec3 toEye", "toEye", kLightReadsToEye},
}};

constexpr EffectHook kHooks[] = {
    {"vertex", kVertexHook, "vertex/transform/effect", "vec3", "onVertex", "vec3 position"},
    {"base-color", kBaseColorHook, "fragment/effect/base_color", "vec4", "onBaseColor", "vec4 base"},
    {"surface", kSurfaceHook, "fragment/effect/surface", "void", "onSurface", ""},
    {"light", kLightHook, "fragment/effect/light", "vec3", "onLight", "vec3 color"},
};

// All words of the snippets: names of functions, uniforms and locals, and whatever of GLSL they use.
const std::set<std::string_view>& takenNames() {
    static const std::set<std::string_view> names = [] {
        std::set<std::string_view> all = {"main"};
        for (const SnippetFile& file : embeddedSnippets())
            for (const Token& token : parseGlsl(file.text).tokens)
                if (token.kind == Token::Kind::Word)
                    all.insert(token.text);
        return all;
    }();
    return names;
}

bool hasForm(std::string_view name) {
    return !name.empty() && name.size() <= kMaxNameSize && name.front() >= 'a' && name.front() <= 'z' &&
           name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == name.npos;
}

std::string inputsOf(EffectTrait hook) {
    std::string list;
    for (const Input& input : kInputs)
        if (input.hook == hook)
            list.append(list.empty() ? "" : ", ").append(input.parameter);
    return list;
}

std::string headOf(const EffectHook& hook) {
    return std::string(hook.type) + " " + std::string(hook.function) + "(" + inputsOf(hook.trait) + ")";
}

Error badSignature(const Effect::Text& effect, const EffectHook& hook, int line, std::string what) {
    return badEffect("effect.signature", effect.file, line, std::move(what),
                     "its inputs, any but the first of which may be left out: " + headOf(hook));
}

std::string spelt(const Variable& parameter) {
    std::string text = parameter.qualifier.empty() || parameter.qualifier == "in"
                           ? ""
                           : std::string(parameter.qualifier) + " ";
    return text.append(parameter.type).append(" ").append(parameter.name) + (parameter.array ? "[]" : "");
}

Result<void> readHead(Effect::Text& effect, Effect::Text::Hook& section, const Syntax& syntax,
                      const Function& function) {
    const EffectHook& hook = *section.hook;
    const int line = section.line + syntax.lineOf(function.first) - 1;
    if (syntax.at(function.first) != hook.type)
        return badSignature(effect, hook, line,
                            std::string(hook.function) + " must return " + std::string(hook.type));
    std::vector<std::string> seen;
    for (const Variable& parameter : function.parameters) {
        const std::string text = spelt(parameter);
        const auto input = std::find_if(kInputs.begin(), kInputs.end(), [&](const Input& each) {
            return each.hook == hook.trait && each.parameter == text;
        });
        if (input == kInputs.end() || std::find(seen.begin(), seen.end(), text) != seen.end())
            return badSignature(effect, hook, line,
                                "'" + text + "' is no input of " + std::string(hook.function));
        section.call.append(seen.empty() ? "" : ", ").append(input->argument);
        effect.traits |= static_cast<std::uint16_t>(input->trait);
        seen.push_back(text);
    }
    if (!hook.first.empty() && (seen.empty() || seen.front() != hook.first))
        return badSignature(effect, hook, line,
                            std::string(hook.function) + " must take '" + std::string(hook.first) +
                                "' first");
    const bool changes =
        std::any_of(seen.begin(), seen.end(), [](const auto& text) { return text.starts_with("inout"); });
    if (hook.first.empty() && !changes)
        return badSignature(effect, hook, line, std::string(hook.function) + " changes nothing");
    section.call = std::string(hook.function) + "(" + section.call + ")";
    return {};
}

} // namespace

std::span<const EffectHook> effectHooks() { return kHooks; }

bool isEffect(const EffectChoice& choice) {
    if (choice.slot == 0)
        return choice.traits == 0;
    return choice.slot <= EffectChoice::kMaxSlot && choice.traits < 2 * kSurfaceChangesRoughness &&
           (choice.traits & kAnyHook) != 0;
}

Error noEffect(std::string where) {
    return {"permutation.range", std::move(where), "this is no effect",
            "choose one with SnippetSet::chooseEffect()"};
}

Error missingEffect(const std::string& which) {
    return {"effect.missing", "", "this run has no effect " + which,
            "add it with SnippetSet::with(), or --effects; or drop the word"};
}

Error badEffect(const char* code, std::string_view file, int line, std::string what, std::string remedy) {
    return {code, std::string(file) + (line > 0 ? ":" + std::to_string(line) : ""), std::move(what),
            std::move(remedy)};
}

bool isEffectWord(std::string_view word) {
    const std::size_t at = std::min(word.find('@'), word.size());
    return hasForm(word.substr(0, at)) && word.size() == at + 9 &&
           word.find_first_not_of("0123456789abcdef", at + 1) == word.npos;
}

Result<void> checkEffectName(std::string_view name) {
    const Error wrong{"effect.name", std::string(name.substr(0, kMaxNameSize)),
                      "an effect cannot be called so",
                      "a name is a letter a-z, then a-z, 0-9 and '-', at most 32 in all"};
    if (!hasForm(name))
        return wrong;
    for (const Choice& choice : choices())
        for (const Option& option : choice.options)
            if (option.word == name)
                return Error{"effect.name", std::string(name),
                             "the word is one of " + std::string(choice.name) + " already",
                             "call the effect something else"};
    return {};
}

Result<void> checkFree(const Effect::Text& effect, std::string_view declared, int line) {
    const bool own = std::any_of(kHooks, std::end(kHooks),
                                 [&](const EffectHook& hook) { return hook.function == declared; });
    if (declared.starts_with("gl_") || declared.find("__") != declared.npos ||
        (!own && takenNames().count(declared) > 0))
        return badEffect("effect.clash", effect.file, line,
                         "'" + std::string(declared) + "' is a name of FrankenShader's or of GLSL",
                         "begin names with the effect's: " + effect.name + "..., u" + effect.name + "...");
    return {};
}

Result<void> readHook(Effect::Text& effect, Effect::Text::Hook& hook) {
    const Syntax syntax = parseGlsl(hook.text);
    const auto lineOf = [&](std::size_t token) { return hook.line + syntax.lineOf(token) - 1; };
    const Function* called = nullptr;
    for (const Function& function : syntax.functions) {
        if (auto free = checkFree(effect, function.name, lineOf(function.token)); !free)
            return free;
        called = function.name == hook.hook->function ? &function : called;
    }
    for (const Variable& global : syntax.globals) {
        if (!global.qualifier.empty() && global.qualifier != "const")
            return badEffect("effect.syntax", effect.file, lineOf(global.token),
                             "'" + std::string(global.qualifier) + " " + std::string(global.name) +
                                 "' stands in a section of functions",
                             "declare it under '//! declarations'");
        if (auto free = checkFree(effect, global.name, lineOf(global.token)); !free)
            return free;
    }
    for (const Struct& each : syntax.structs)
        if (auto free = checkFree(effect, each.name, lineOf(each.token)); !free)
            return free;
    if (called == nullptr)
        return badEffect("effect.function", effect.file, hook.line > 1 ? hook.line - 1 : 1,
                         "the section '" + std::string(hook.hook->name) + "' has no function " +
                             std::string(hook.hook->function),
                         "write " + headOf(*hook.hook));
    return readHead(effect, hook, syntax, *called);
}

} // namespace franken
