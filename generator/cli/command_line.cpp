// SPDX-License-Identifier: MIT
#include "franken/generator/budget.h"
#include "gpu.h"
#include "options.h"

#include <CLI/CLI.hpp>

#include <charconv>

namespace franken::cli {
namespace {

constexpr char kAbout[] = "Writes, explains and checks the GLSL ES 1.00 programs of FrankenShader.";
constexpr char kExitCodes[] =
    "A NAME is made of words: basecolor.normal+ambient+sun1 (see 'frankenshader list --words').\n"
    "Exit codes: 0 ok, 1 a check failed or programs differ, 2 usage, 3 input refused,\n"
    "4 a file cannot be written or a tool cannot be run.\n"
    "Example: frankenshader dump basecolor.normal+ambient+sun1";

bool parseNumber(std::string_view text, std::size_t& number) {
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), number);
    return failed == std::errc() && end == text.data() + text.size();
}

Shard parseShard(const std::string& text) {
    Shard shard;
    const std::size_t slash = std::min(text.find('/'), text.size());
    const std::string_view index = std::string_view(text).substr(0, slash);
    const std::string_view count = std::string_view(text).substr(std::min(slash + 1, text.size()));
    if (!parseNumber(index, shard.index) || !parseNumber(count, shard.count) || shard.index < 1 ||
        shard.index > shard.count)
        throw CLI::ValidationError("--shard", "'" + text + "' is not I/N with 1 <= I <= N");
    return shard;
}

void addJson(CLI::App& app, bool& json) {
    app.add_flag("--json", json, "One JSON document, with a schema version");
}

void addFilters(CLI::App& app, SelectionOptions& selection) {
    const auto words = [&](const char* name, std::vector<std::string>& into, const char* type,
                           const char* text) {
        app.add_option(name, into, text)->type_name(type)->allow_extra_args(false);
    };
    words("--with", selection.with, "WORD", "Only permutations with that word; may be repeated");
    words("--without", selection.without, "WORD", "Only permutations without that word; may be repeated");
    words("--where", selection.where, "FILTER",
          "Words as in a name; '!' forbids one: 'normal+sun2+!spots'; may be repeated");
    app.add_option("--limit", selection.limit,
                   "At most so many, 0 for no limit [100 of the whole space, else none]")
        ->type_name("N");
    app.add_option_function<std::string>(
           "--shard", [&selection](const std::string& text) { selection.shard = parseShard(text); },
           "Every N-th of them, from the I-th on: 2/8 is the second of eight parts")
        ->type_name("I/N");
}

void addSources(CLI::App& app, SelectionOptions& selection, bool names) {
    auto* covering = app.add_flag("--covering", selection.covering,
                                  "The covering set: every combination of three choices occurs in it");
    auto* manifest =
        app.add_option("--manifest", selection.manifest, "Names from a file, one a line; - is standard input")
            ->type_name("FILE")
            ->excludes(covering);
    if (names)
        app.add_option("NAME", selection.names, "Permutations by name")
            ->excludes(covering)
            ->excludes(manifest);
}

void addList(CLI::App& app, ListOptions& options) {
    auto& list = *app.add_subcommand("list", "Lists permutations, short names first");
    addSources(list, options.selection, false);
    addFilters(list, options.selection);
    list.add_flag("--count", options.count, "Only how many");
    list.add_flag("--words", options.words, "The words that names are made of, and what they mean");
    addJson(list, options.json);
    list.footer("Example: frankenshader list --with normal --without spots --limit 20");
}

void addDump(CLI::App& app, DumpOptions& options) {
    auto& dump = *app.add_subcommand("dump", "Writes programs");
    addSources(dump, options.selection, true);
    addFilters(dump, options.selection);
    auto* directory = dump.add_option("-o,--output", options.directory,
                                      "Where NAME.vert, NAME.frag, NAME.shader_test and manifest.json go; "
                                      "without it, one program goes to standard output")
                          ->type_name("DIR");
    const std::map<std::string, Stage> stages = {{"vertex", Stage::Vertex}, {"fragment", Stage::Fragment}};
    auto* stage = dump.add_option_function<std::string>(
        "--stage", [&options, stages](const std::string& text) { options.stage = stages.at(text); },
        "One stage alone, on standard output: vertex or fragment");
    stage->type_name("STAGE")->check(CLI::IsMember(stages))->excludes(directory);
    dump.add_flag("--json", options.json, "One JSON document with texts and interfaces")
        ->excludes(directory)
        ->excludes(stage);
    dump.footer("Example: frankenshader dump --covering -o shaders");
}

void addExplain(CLI::App& app, ExplainOptions& options) {
    auto& explain = *app.add_subcommand("explain", "Tells where each line comes from, and the budget");
    explain.add_option("NAME", options.name, "A permutation")->required();
    addJson(explain, options.json);
    explain.footer("Example: frankenshader explain basecolor.normal+sun2");
}

void addDiff(CLI::App& app, DiffOptions& options) {
    auto& diff = *app.add_subcommand("diff", "Compares two programs; exits with 1 where they differ");
    diff.add_option("A", options.first, "A permutation")->required();
    diff.add_option("B", options.second, "Another one")->required();
    addJson(diff, options.json);
    diff.footer("Example: frankenshader diff normal+sun1 normal+sun1+fast");
}

void addCheck(CLI::App& app, CheckOptions& options) {
    auto& check = *app.add_subcommand("check", "Checks budget, lint and, where installed, glslangValidator");
    addSources(check, options.selection, true);
    addFilters(check, options.selection);
    std::vector<std::string> names = {"all"};
    for (const Profile& profile : profiles())
        names.emplace_back(profile.name);
    check
        .add_option("--profile", options.profiles,
                    "The GPU to fit in: " + CLI::detail::join(names, ", ") + "; may be repeated [vc4]")
        ->type_name("P")
        ->check(CLI::IsMember(names))
        ->allow_extra_args(false);
    addJson(check, options.json);
    check.parse_complete_callback([&options] {
        if (options.profiles.empty())
            options.profiles = {"vc4"};
    });
    check.footer("Example: frankenshader check --covering --profile all --shard 1/4");
}

void addCost(CLI::App& app, CostOptions& options) {
    auto& cost = *app.add_subcommand("cost", "Tells what a program costs on the Raspberry Pi's GPUs");
    addSources(cost, options.selection, true);
    addFilters(cost, options.selection);
    std::vector<std::string> names;
    for (const Gpu& gpu : gpus())
        names.emplace_back(gpu.name);
    cost.add_option("--gpu", options.gpus, CLI::detail::join(names, ", ") + "; may be repeated [all]")
        ->type_name("GPU")
        ->check(CLI::IsMember(names))
        ->allow_extra_args(false);
    addJson(cost, options.json);
    cost.footer("Example: frankenshader cost basecolor.normal+ambient+sun1 --gpu vc4");
}

void demand(const SelectionOptions& selection) {
    if (selection.empty())
        throw CLI::RequiredError("NAME, --where, --covering or --manifest");
}

} // namespace

Command parseCommandLine(int argc, const char* const* argv) {
    CLI::App app(kAbout, "frankenshader");
    ListOptions list;
    DumpOptions dump;
    ExplainOptions explain;
    DiffOptions diff;
    CheckOptions check;
    CostOptions cost;
    app.set_version_flag("--version", "frankenshader " FRANKEN_VERSION);
    app.require_subcommand(0, 1);
    app.footer(kExitCodes);
    app.failure_message([](const CLI::App*, const CLI::Error& error) {
        return std::string("frankenshader: error: ") + error.what() + "\nSee 'frankenshader --help'.\n";
    });
    addList(app, list);
    addDump(app, dump);
    addExplain(app, explain);
    addDiff(app, diff);
    addCheck(app, check);
    addCost(app, cost);
    try {
        app.parse(argc, argv);
        if (app.got_subcommand("list"))
            return list;
        if (app.got_subcommand("explain"))
            return explain;
        if (app.got_subcommand("diff"))
            return diff;
        if (app.got_subcommand("dump"))
            return demand(dump.selection), dump;
        if (app.got_subcommand("cost"))
            return demand(cost.selection), cost;
        if (app.got_subcommand("check"))
            return demand(check.selection), check;
        throw CLI::RequiredError("A command: list, dump, explain, diff, check or cost");
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? ExitCode::Ok : ExitCode::Usage;
    }
}

} // namespace franken::cli
