// SPDX-License-Identifier: MIT
#include "app.h"
#include "effects.h"
#include "franken/nearest.h"

#include <algorithm>

namespace franken::cli {
namespace {

constexpr char kSeeHelp[] = "see 'frankenshader help'";

void demand(const SelectionOptions& selection) {
    if (selection.empty())
        throw CLI::RequiredError("NAME, --where, --covering or --manifest");
}

void demand(const DumpOptions& dump) {
    demand(dump.selection);
    if (dump.chosen() == DumpFormat::Files && dump.output.empty())
        throw CLI::RequiredError("-o DIR, which '--format files' writes to,");
}

std::vector<std::string> commandsOf(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    return names;
}

std::vector<std::string> optionsOf(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
        for (const std::string& name : option->get_snames())
            names.push_back("-" + name);
    }
    return names;
}

std::string nearestOf(const std::string& word, const std::vector<std::string>& words) {
    const std::vector<std::string_view> views(words.begin(), words.end());
    return std::string(nearestWord(word, views));
}

const CLI::App& commandOf(const CLI::App& app) {
    const std::vector<CLI::App*> parsed = const_cast<CLI::App&>(app).get_subcommands();
    return parsed.empty() ? app : *parsed.front();
}

// What the parser could do nothing with: the first such word, and what was probably meant.
Error unexpected(const CLI::App& app, const std::string& word) {
    const CLI::App& command = commandOf(app);
    const bool option = word.starts_with('-');
    const bool isCommand = !option && &command == &app;
    const std::string name = word.substr(0, word.find('='));
    const std::string nearest = nearestOf(name, option ? optionsOf(command) : commandsOf(app));
    Error error{"usage", "", "", kSeeHelp};
    if (isCommand)
        error.what = "'" + word + "' is no command; there are " + CLI::detail::join(commandsOf(app), ", ");
    else if (option)
        error.what =
            "'" + word + "' is no option" + (&command == &app ? "" : " of '" + command.get_name() + "'");
    else
        error.what = "'" + word + "' is one argument too many for '" + command.get_name() + "'";
    if ((option || isCommand) && !nearest.empty())
        error.remedy = "did you mean '" + nearest + "'?";
    return error;
}

// In the order in which they were typed.
std::vector<std::string> leftOver(const CLI::App& app) {
    std::vector<std::string> words = commandOf(app).remaining(true);
    if (words.empty())
        words = app.remaining(true);
    return words;
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

Command commandFrom(App& parsed) {
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
        return commandFrom(parsed);
    } catch (const CLI::ExtrasError& error) {
        const std::vector<std::string> words = leftOver(parsed.app);
        console.error(words.empty() ? Error{"usage", "", error.what(), kSeeHelp}
                                    : unexpected(parsed.app, words.front()));
        return ExitCode::Usage;
    } catch (const CLI::Success& success) {
        parsed.app.exit(success); // Help, or the version.
        return ExitCode::Ok;
    } catch (const CLI::ParseError& error) {
        console.error({"usage", "", error.what(), kSeeHelp});
        return ExitCode::Usage;
    }
}

} // namespace franken::cli
