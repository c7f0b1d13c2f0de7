// SPDX-License-Identifier: MIT
#include "app.h"
#include "effects.h"
#include "franken/command_line/mistake.h"
#include "franken/file.h"

#include <algorithm>

namespace franken::cli {
namespace {

void demand(const SelectionOptions& selection) {
    if (selection.empty())
        throw CLI::RequiredError("NAME, --where, --covering or --manifest");
}

void demand(const DumpOptions& dump) {
    demand(dump.selection);
    if (dump.chosen() == DumpFormat::Files && dump.output.empty())
        throw CLI::RequiredError("-o DIR, which '--format files' writes to,");
}

bool asksForJson(int argc, const char* const* argv) {
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        const std::string_view next = i + 1 < argc ? argv[i + 1] : "";
        if (word == "--json" || word == "--format=json" || (word == "--format" && next == "json"))
            return true;
    }
    return false;
}

ExitCode showHelp(const App& parsed) {
    const std::vector<std::string> commands = commandsOf(parsed.app);
    if (parsed.helpTopic.empty())
        return std::cout << parsed.app.get_formatter()->make_help(&parsed.app, "frankenshader",
                                                                  CLI::AppFormatMode::Normal),
               ExitCode::Ok;
    if (std::find(commands.begin(), commands.end(), parsed.helpTopic) == commands.end()) {
        const std::string nearest = nearestOf(parsed.helpTopic, commands);
        throw CLI::ValidationError("help", "'" + parsed.helpTopic + "' is no command" +
                                               (nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
    }
    std::cout << parsed.app.get_subcommand(parsed.helpTopic)->help("frankenshader");
    return ExitCode::Ok;
}

ExitCode showManual(const App& parsed, Console& console) {
    constexpr std::size_t kLargestPage = std::size_t{1} << 20;
    const Result<std::vector<std::uint8_t>> page = readFile(parsed.page, kLargestPage);
    if (!page)
        return console.error(page.error()), ExitCode::Device;
    return std::cout << filledManPage(parsed.app, {page->begin(), page->end()}), ExitCode::Ok;
}

Command commandFrom(App& parsed, Console& console) {
    const CLI::App& app = parsed.app;
    if (app.got_subcommand("list"))
        return parsed.list;
    if (app.got_subcommand("explain"))
        return parsed.explain;
    if (app.got_subcommand("diff")) {
        if (parsed.diff.names.empty() && parsed.diff.against.empty())
            throw CLI::RequiredError("Two names, or --against DIR,");
        return parsed.diff;
    }
    if (app.got_subcommand("dump"))
        return demand(parsed.dump), parsed.dump;
    if (app.got_subcommand("cost"))
        return demand(parsed.cost.selection), parsed.cost;
    if (app.got_subcommand("check"))
        return demand(parsed.check.selection), parsed.check;
    if (app.got_subcommand("help"))
        return showHelp(parsed);
    if (app.got_subcommand("completions"))
        return std::cout << completionsFor(app, parsed.shell), ExitCode::Ok;
    if (app.got_subcommand("manual"))
        return showManual(parsed, console);
    throw CLI::RequiredError("A command (" + CLI::detail::join(commandsOf(app), ", ") + ")");
}

} // namespace

Command parseCommandLine(int argc, const char* const* argv, Console& console) {
    App parsed;
    if (asksForJson(argc, argv))
        console.answerInJson();
    try {
        parsed.app.parse(argc, argv);
        if (const Result<void> added = addEffects(parsed.effects); !added)
            return console.error(added.error()), ExitCode::Refused;
        return commandFrom(parsed, console);
    } catch (const CLI::Success& success) {
        parsed.app.exit(success); // Help, or the version.
        return ExitCode::Ok;
    } catch (const CLI::ParseError& error) {
        console.error(mistakeIn(parsed.app, error));
        return ExitCode::Usage;
    }
}

} // namespace franken::cli
