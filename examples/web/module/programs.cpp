// SPDX-License-Identifier: MIT
// What the page asks about permutations. Names come from the page as UTF-8 in the input.
#include "dump_c.h"
#include "effects.h"
#include "exchange.h"
#include "explanation.h"
#include "franken/generator/choices.h"
#include "franken/generator/covering.h"
#include "franken/generator/ladder.h"
#include "franken/generator/lint.h"
#include "franken/generator/pack.h"
#include "franken/generator/texture_role.h"

namespace franken {
namespace cli {

// The page has no effects of its own.
const SnippetSet& snippets() { return SnippetSet::builtIn(); }

} // namespace cli

namespace web {
namespace {

void writeChoices(Json& json) {
    json.key("choices").begin('[');
    for (const Choice& choice : choices()) {
        json.begin('{')
            .member("name", choice.name)
            .member("material", choice.material)
            .key("options")
            .begin('[');
        for (const Option& option : choice.options)
            json.begin('{').member("word", option.word).member("meaning", option.meaning).end('}');
        json.end(']').end('}');
    }
    json.end(']');
}

void writeRoles(Json& json) {
    json.key("roles").begin('[');
    for (const TextureRoleRow& role : textureRoles()) {
        json.begin('{').member("name", role.name).member("sampler", role.sampler).member("unit", role.unit);
        json.member("repeats", role.repeats).key("texel").numbers(role.defaultTexel).end('}');
    }
    json.end(']');
}

void writeBlocks(Json& json) {
    const auto floats = [&json](Block block, std::size_t bytes) {
        json.member(toText(block), bytes / sizeof(float));
    };
    json.key("blocks").begin('{');
    floats(Block::Frame, sizeof(FrameBlock));
    floats(Block::Lights, sizeof(LightsBlock));
    floats(Block::Material, sizeof(MaterialBlock));
    floats(Block::Object, sizeof(ObjectBlock));
    floats(Block::Skin, sizeof(SkinBlock));
    json.end('}');
}

void writeInterface(Json& json, const Interface& interface) {
    json.key("attributes").begin('[');
    for (const Attribute& each : interface.attributes)
        json.begin('{').member("name", each.name).member("location", each.location).end('}');
    json.end(']').key("uniforms").begin('[');
    for (const Uniform& each : interface.uniforms) {
        json.begin('{')
            .member("name", each.name)
            .member("type", toGlsl(each.type))
            .member("count", each.count);
        json.member("block", toText(each.block)).member("offset", fieldOffset(each)).end('}');
    }
    json.end(']').key("samplers").begin('[');
    for (const Sampler& each : interface.samplers)
        json.begin('{')
            .member("name", each.name)
            .member("type", toGlsl(each.type))
            .member("unit", each.unit)
            .end('}');
    json.end(']');
}

void writeStage(Json& json, std::string_view name, const ComposedStage& stage,
                const std::vector<cli::ExplainedLine>& lines) {
    json.key(name).begin('{').member("text", stage.text).key("lines").begin('[');
    for (const cli::ExplainedLine& line : lines) {
        json.begin('{').member("origin", toString(line.origin));
        json.member("why", line.reason ? toText(*line.reason) : std::string()).end('}');
    }
    json.end(']').end('}');
}

void writeBudget(Json& json, const cli::ProfileBudget& each) {
    json.begin('{').member("profile", each.profile.name).member("meaning", each.profile.meaning);
    json.member("fits", each.budget.fits()).key("uses").begin('[');
    for (const Use& use : each.budget.uses)
        json.begin('{')
            .member("resource", toText(use.resource))
            .member("used", use.used)
            .member("limit", use.limit)
            .end('}');
    json.end(']').key("advice").begin('[');
    for (const cli::Excess& excess : each.excesses)
        json.value(std::string(toText(excess.use.resource)) + ": " + cli::adviceFor(excess));
    for (const std::string_view role : each.budget.rolesBeyond)
        json.value("the GPU has no texture unit for the role " + std::string(role));
    json.end(']').end('}');
}

void writeDropped(Json& json, const std::vector<Dropped>& dropped) {
    json.key("dropped").begin('[');
    for (const Dropped& each : dropped)
        json.begin('{').member("word", each.word).member("reason", each.reason).end('}');
    json.end(']');
}

void writeLadder(Json& json, const Permutation& permutation) {
    json.key("ladder").begin('[');
    for (std::optional<Permutation> next = simpler(permutation); next; next = simpler(*next))
        json.value(toName(*next));
    json.end(']');
}

void writeValues(Json& json, const Permutation& permutation) {
    json.key("values").begin('[');
    for (const Choice& choice : choices())
        json.value(choice.get(permutation));
    json.end(']');
}

Result<Canonical> canonicalOf(std::string_view name) { return parseName(name).and_then(canonicalise); }

Json program(const Canonical& canonical) {
    const cli::Explanation explained(cli::Program(canonical.permutation), canonical.dropped);
    const Composed& composed = explained.program.composed;
    Json json;
    json.begin('{').member("name", explained.program.name);
    json.member("key", toHex(toKey(canonical.permutation)));
    writeValues(json, canonical.permutation);
    writeDropped(json, explained.dropped);
    writeStage(json, "vertex", composed.vertex, explained.vertex);
    writeStage(json, "fragment", composed.fragment, explained.fragment);
    writeInterface(json, composed.interface);
    json.key("budgets").begin('[');
    for (const cli::ProfileBudget& each : explained.budgets)
        writeBudget(json, each);
    json.end(']').key("lint").begin('[');
    for (const LintFinding& finding : lintProgram(composed))
        json.value(toString(finding));
    json.end(']');
    writeLadder(json, canonical.permutation);
    return json.end('}');
}

} // namespace
} // namespace web
} // namespace franken

using namespace franken;

/// {"choices", "roles", "blocks"}: what does not depend on a permutation.
FRANKEN_EXPORT(describe) void describe() {
    web::Json json;
    json.begin('{');
    web::writeChoices(json);
    web::writeRoles(json);
    web::writeBlocks(json);
    web::answer(json.end('}'));
}

/// The name after one choice has got another option: {"name", "dropped"}, or why not: {"error"}.
FRANKEN_EXPORT(choose) void choose(std::size_t nameSize, unsigned choice, unsigned option) {
    Result<Permutation> permutation = parseName(web::inputText(nameSize));
    if (!permutation)
        return web::answer(permutation.error());
    if (choice >= choices().size() || option >= choices()[choice].options.size())
        return web::answer(Error{"web.choice", "", "there is no such choice", ""});
    choices()[choice].set(*permutation, option);
    const Result<Canonical> canonical = canonicalise(*permutation);
    if (!canonical)
        return web::answer(canonical.error());
    web::Json json;
    json.begin('{').member("name", toName(canonical->permutation));
    web::writeDropped(json, canonical->dropped);
    web::answer(json.end('}'));
}

/// All about the program of a name, or {"error"}.
FRANKEN_EXPORT(program) void describeProgram(std::size_t nameSize) {
    const Result<Canonical> canonical = web::canonicalOf(web::inputText(nameSize));
    canonical ? web::answer(web::program(*canonical)) : web::answer(canonical.error());
}

/// The program as a header of C, as `frankenshader dump --format c` writes it, or {"error"}.
FRANKEN_EXPORT(header) void header(std::size_t nameSize) {
    const Result<Canonical> canonical = web::canonicalOf(web::inputText(nameSize));
    if (!canonical)
        return web::answer(canonical.error());
    cli::DumpC dump;
    std::string text = dump.begin();
    text += dump.program(cli::Program(canonical->permutation));
    web::answer(text + dump.end());
}

/// The light and the look of one name with the material of another, canonical: {"name"}, or {"error"}.
FRANKEN_EXPORT(withMaterial) void withMaterial(std::size_t lightSize, std::size_t materialSize) {
    const std::string_view names = web::inputText(lightSize + materialSize);
    Result<Permutation> light = parseName(names.substr(0, lightSize));
    const Result<Permutation> material = parseName(names.substr(lightSize));
    if (!light || !material)
        return web::answer(light ? material.error() : light.error());
    for (const Choice& choice : choices())
        if (choice.material)
            choice.set(*light, choice.get(*material));
    const Result<Canonical> canonical = canonicalise(*light);
    if (!canonical)
        return web::answer(canonical.error());
    web::Json json;
    web::answer(json.begin('{').member("name", toName(canonical->permutation)).end('}'));
}

/// [names]: the covering set.
FRANKEN_EXPORT(covering) void covering() {
    web::Json json;
    json.begin('[');
    for (const Permutation& permutation : coveringSet())
        json.value(toName(permutation));
    web::answer(json.end(']'));
}
