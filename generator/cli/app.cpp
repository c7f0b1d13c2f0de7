// SPDX-License-Identifier: MIT
#include "app.h"

#include "franken/command_line/mistake.h"
#include "franken/generator/budget.h"
#include "franken/generator/version.h"
#include "gpu.h"

#include <algorithm>
#include <charconv>

namespace franken::cli {
namespace {

constexpr long long kMostPermutations = 1'000'000'000; // More than anyone can wait for.
constexpr std::size_t kMostInstructions = 1'000'000;
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

CostLimit parseLimit(const std::string& text, const CostOptions& options) {
    const std::size_t sign = std::min(text.find('='), text.size());
    const std::string gpu = text.substr(0, sign);
    const std::string_view number = std::string_view(text).substr(std::min(sign + 1, text.size()));
    std::size_t most = 0;
    if (!parseNumber(number, most) || most < 1 || most > kMostInstructions)
        throw CLI::ValidationError("--max", "'" + text + "' is not GPU=N with N from 1 to " +
                                                std::to_string(kMostInstructions));
    if (const Result<Gpu> known = findGpu(gpu); !known)
        throw CLI::ValidationError("--max", known.error().what + " (" + known.error().remedy + ")");
    const auto same = [&](const CostLimit& limit) { return limit.gpu == gpu; };
    if (std::any_of(options.limits.begin(), options.limits.end(), same))
        throw CLI::ValidationError("--max", "'" + gpu + "' has two limits");
    return {gpu, static_cast<int>(most)};
}

// A limit of what is not measured would hold nothing.
void checkLimits(const CostOptions& options) {
    for (const CostLimit& limit : options.limits)
        if (!options.gpus.empty() &&
            std::find(options.gpus.begin(), options.gpus.end(), limit.gpu) == options.gpus.end())
            throw CLI::ValidationError("--max", "'" + limit.gpu + "' is not among the GPUs of --gpu");
}

void addJson(CLI::App& app, bool& json) {
    app.add_flag("--json", json, "One JSON document, with a schema version; errors are one too");
}

void addWords(CLI::App& app, const char* name, std::vector<std::string>& into, const char* type,
              const std::string& text) {
    app.add_option(name, into, text)->type_name(type)->allow_extra_args(false);
}

void addFilters(CLI::App& app, SelectionOptions& selection) {
    addWords(app, "--with", selection.with, "WORD", "Only permutations with that word; may be repeated");
    addWords(app, "--without", selection.without, "WORD",
             "Only permutations without that word; may be repeated");
    addWords(app, "--where", selection.where, "FILTER",
             "Words as in a name; '!' forbids one: 'normal+sun2+!spots'; may be repeated");
    app.add_option("--limit", selection.limit,
                   "At most so many, 0 for no limit [100 of the whole space, else none]")
        ->type_name("N")
        ->check(wholeNumber(0, kMostPermutations));
    app.add_option_function<std::string>(
           "--shard", [&selection](const std::string& text) { selection.shard = parseShard(text); },
           "Every N-th of them, from the I-th on: 2/8 is the second of eight parts")
        ->type_name("I/N");
}

// `check` holds programs to profiles without --fits as well.
void addProfiles(CLI::App& app, SelectionOptions& selection, bool needsFits) {
    std::vector<std::string> names = {"all"};
    for (const Profile& profile : profiles())
        names.emplace_back(profile.name);
    auto* fits = app.add_flag("--fits", selection.fits,
                              "Only what fits in the profile; a covering set covers that alone");
    auto* profile =
        app.add_option("--profile", selection.profiles,
                       "The GPU to fit in: " + CLI::detail::join(names, ", ") + "; may be repeated [vc4]")
            ->type_name("P")
            ->check(oneOf(names))
            ->allow_extra_args(false);
    if (needsFits)
        profile->needs(fits);
    app.parse_complete_callback([&selection] {
        if (selection.profiles.empty())
            selection.profiles = {"vc4"};
    });
}

void addSources(CLI::App& app, SelectionOptions& selection, bool names) {
    auto* covering = app.add_flag("--covering", selection.covering,
                                  "The covering set: every combination of three choices occurs in it");
    auto* manifest =
        app.add_option("--manifest", selection.manifest, "Names from a file, one a line; - is standard input")
            ->type_name("FILE")
            ->check(notEmpty())
            ->excludes(covering);
    if (names)
        app.add_option("NAME", selection.names, "Permutations by name, or by key (0x...)")
            ->excludes(covering)
            ->excludes(manifest);
}

void addList(CLI::App& app, ListOptions& options) {
    auto& list = *app.add_subcommand("list", "Lists permutations, short names first");
    addSources(list, options.selection, false);
    addFilters(list, options.selection);
    addProfiles(list, options.selection, true);
    list.add_flag("--count", options.count, "Only how many; counting stops at a million without --limit");
    list.add_flag("--words", options.words, "The words that names are made of, and what they mean");
    addJson(list, options.json);
    list.footer("Example: frankenshader list --with normal --without spots --limit 20");
}

void addDump(CLI::App& app, DumpOptions& options) {
    auto& dump = *app.add_subcommand("dump", "Writes programs");
    addSources(dump, options.selection, true);
    addFilters(dump, options.selection);
    addProfiles(dump, options.selection, true);
    auto* output = dump.add_option("-o,--output", options.output,
                                   "The folder for NAME.vert, NAME.frag, NAME.shader_test and manifest.json, "
                                   "or the file for json and c; without it, it goes to standard output")
                       ->type_name("PATH")
                       ->check(notEmpty());
    const std::map<std::string, Stage> stages = {{"vertex", Stage::Vertex}, {"fragment", Stage::Fragment}};
    auto* stage = dump.add_option_function<std::string>(
        "--stage", [&options, stages](const std::string& text) { options.stage = stages.at(text); },
        "One stage alone, on standard output: vertex or fragment");
    stage->type_name("STAGE")->check(oneOf({"vertex", "fragment"}))->excludes(output);
    const std::map<std::string, DumpFormat> formats = {
        {"files", DumpFormat::Files}, {"json", DumpFormat::Json}, {"c", DumpFormat::C}};
    auto* format = dump.add_option_function<std::string>(
        "--format", [&options, formats](const std::string& text) { options.format = formats.at(text); },
        "files in a folder, one document with texts and interfaces (json), or one C header (c) [files]");
    format->type_name("FORMAT")->check(oneOf({"files", "json", "c"}))->excludes(stage);
    dump.add_flag_callback(
            "--json", [&options] { options.format = DumpFormat::Json; }, "The same as --format json")
        ->excludes(format)
        ->excludes(stage);
    dump.add_option("--depfile", options.depfile,
                    "A file for make and ninja that says what the output was made from")
        ->type_name("FILE")
        ->check(notEmpty())
        ->needs(output);
    dump.footer("Example: frankenshader dump --covering -o shaders");
}

void addExplain(CLI::App& app, ExplainOptions& options) {
    auto& explain = *app.add_subcommand("explain", "Tells where each line comes from, and the budget");
    explain.add_option("NAME", options.name, "A permutation, by name or by key")->required();
    addJson(explain, options.json);
    explain.footer("Example: frankenshader explain basecolor.normal+sun2");
}

void addDiff(CLI::App& app, DiffOptions& options) {
    auto& diff = *app.add_subcommand("diff", "Compares two programs, or a folder of them with what would be "
                                             "written today; exits with 1 where they differ");
    auto* names = diff.add_option("NAME", options.names, "Two permutations, by name or by key")->expected(2);
    diff.add_option("--against", options.against,
                    "A folder that 'dump -o' wrote, by this version or another: all its programs")
        ->type_name("DIR")
        ->check(notEmpty())
        ->excludes(names);
    addJson(diff, options.json);
    diff.footer("Example: frankenshader diff normal+sun1 normal+sun1+fast");
}

void addCheck(CLI::App& app, CheckOptions& options) {
    auto& check = *app.add_subcommand("check", "Checks budget, lint and, where installed, glslangValidator");
    addSources(check, options.selection, true);
    addFilters(check, options.selection);
    addProfiles(check, options.selection, false);
    addJson(check, options.json);
    check.footer("Example: frankenshader check --covering --fits --profile vc4 --shard 1/4");
}

void addCost(CLI::App& app, CostOptions& options) {
    auto& cost = *app.add_subcommand("cost", "Tells what a program costs on the Raspberry Pi's GPUs");
    addSources(cost, options.selection, true);
    addFilters(cost, options.selection);
    addProfiles(cost, options.selection, true);
    std::vector<std::string> names;
    for (const Gpu& gpu : gpus())
        names.emplace_back(gpu.name);
    cost.add_option("--gpu", options.gpus, CLI::detail::join(names, ", ") + "; may be repeated [all]")
        ->type_name("GPU")
        ->check(oneOf(names))
        ->allow_extra_args(false);
    cost.add_option_function<std::vector<std::string>>(
            "--max",
            [&options](const std::vector<std::string>& texts) {
                for (const std::string& text : texts)
                    options.limits.push_back(parseLimit(text, options));
            },
            "Exit with 1 where a fragment shader has more instructions on that GPU: vc4=150; may be repeated")
        ->type_name("GPU=N")
        ->allow_extra_args(false);
    cost.add_option("--baseline", options.baseline,
                    "Exit with 1 where a program is dearer than in this file, which --json wrote")
        ->type_name("FILE")
        ->check(notEmpty());
    addJson(cost, options.json);
    cost.final_callback([&options] { checkLimits(options); });
    cost.footer("Example: frankenshader cost basecolor.normal+ambient+sun1 --gpu vc4 --max vc4=150");
}

void addMeta(CLI::App& app, std::string& helpTopic, std::string& shell, std::string& page) {
    auto& help = *app.add_subcommand("help", "Shows the help of a command");
    help.add_option("COMMAND", helpTopic, "One of the commands; without it, the help of all");
    help.footer("Example: frankenshader help dump");
    auto& completions =
        *app.add_subcommand("completions", "Prints what a shell completes command lines with");
    completions.add_option("SHELL", shell, CLI::detail::join(kShells, ", "))
        ->required()
        ->check(oneOf(kShells));
    completions.footer("Example: frankenshader completions bash >~/.local/share/bash-completion/completions/"
                       "frankenshader");
    auto& manual =
        *app.add_subcommand("manual", "Fills synopsis and options into a manual page, for the build");
    manual.group(""); // Not for those who use the program.
    manual.add_option("PAGE", page, "A file in roff with lines @SYNOPSIS@ and @OPTIONS@")->required();
}

// The interface is compatible within a minor version while the major one is 0.
std::string versionText() {
    const std::string version = FRANKEN_VERSION;
    return "frankenshader " + version + "\ninterface " + version.substr(0, version.rfind('.')) + ", keys " +
           std::to_string(kSchemaVersion) + ", texts " + std::to_string(kTextVersion);
}

} // namespace

App::App() : app(kAbout, "frankenshader") {
    app.set_version_flag("-V,--version", versionText());
    app.require_subcommand(0, 1);
    app.footer(kExitCodes);
    addList(app, list);
    addDump(app, dump);
    addExplain(app, explain);
    addDiff(app, diff);
    addCheck(app, check);
    addCost(app, cost);
    for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        addWords(*command, "--effects", effects, "PATH",
                 "An effect of an application's, or a folder of them (*.glsl); named by their files, as in "
                 "sun1+fog; may be repeated");
    addMeta(app, helpTopic, shell, page);
}

} // namespace franken::cli
