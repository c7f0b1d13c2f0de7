// SPDX-License-Identifier: MIT
#include "franken/command_line/mistake.h"

#include "franken/command_line/manual.h"
#include "franken/nearest.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace franken::cli {
namespace {

const CLI::App& commandOf(const CLI::App& app) {
    const std::vector<CLI::App*> parsed = const_cast<CLI::App&>(app).get_subcommands();
    return parsed.empty() ? app : *parsed.front();
}

std::string letter(char name) { return {'-', name}; }

// One letter is near to any other: it is offered where only its case is wrong.
std::string nearestLetter(const CLI::App& command, char typed) {
    for (const int other : {std::tolower(typed), std::toupper(typed)})
        if (const char name = static_cast<char>(other);
            name != typed && command.get_option_no_throw(letter(name)) != nullptr)
            return letter(name);
    return {};
}

std::string nearestOption(const CLI::App& command, const std::string& word) {
    constexpr std::size_t kLetter = 2; // "-o"
    if (word.size() == kLetter)
        return nearestLetter(command, word[1]);
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
    return nearestOf(word, names);
}

// What the parser could do nothing with, in the order in which it was typed.
std::vector<std::string> leftOver(const CLI::App& app) {
    std::vector<std::string> words = commandOf(app).remaining(true);
    return words.empty() ? app.remaining(true) : words;
}

std::string helpOf(const CLI::App& app) {
    const CLI::App& command = commandOf(app);
    return "see '" + app.get_name() + (&command == &app ? "" : " " + command.get_name()) + " --help'";
}

Error unexpected(const CLI::App& app, const std::string& word) {
    const CLI::App& command = commandOf(app);
    const std::vector<std::string> commands = commandsOf(app);
    std::string nearest, what;
    if (word.starts_with('-')) {
        nearest = nearestOption(command, word.substr(0, word.find('=')));
        what = "'" + word + "' is no option" + (&command == &app ? "" : " of '" + command.get_name() + "'");
    } else if (&command == &app && !commands.empty()) {
        nearest = nearestOf(word, commands);
        what = "'" + word + "' is no command; there are " + CLI::detail::join(commands, ", ");
    } else {
        what = "'" + word + "' is one argument too many for '" + command.get_name() + "'";
    }
    return {"usage", "", what, nearest.empty() ? helpOf(app) : "did you mean '" + nearest + "'?"};
}

} // namespace

Error mistakeIn(const CLI::App& app, const CLI::ParseError& refusal) {
    const bool tooMuch = dynamic_cast<const CLI::ExtrasError*>(&refusal) != nullptr;
    const std::vector<std::string> words = leftOver(app);
    const auto word = std::find_if(words.begin(), words.end(), [tooMuch](const std::string& left) {
        return tooMuch || left.starts_with('-');
    });
    return word == words.end() ? Error{"usage", "", refusal.what(), helpOf(app)} : unexpected(app, *word);
}

std::vector<std::string> commandsOf(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : shownCommands(app))
        names.push_back(command->get_name());
    return names;
}

std::string nearestOf(const std::string& word, const std::vector<std::string>& words) {
    const std::vector<std::string_view> views(words.begin(), words.end());
    return std::string(nearestWord(word, views));
}

CLI::Validator oneOf(const std::vector<std::string>& words) {
    return CLI::Validator(
        [words](const std::string& text) -> std::string {
            if (std::find(words.begin(), words.end(), text) != words.end())
                return {};
            const std::string nearest = nearestOf(text, words);
            return "'" + text + "' is none of " + CLI::detail::join(words, ", ") +
                   (nearest.empty() ? "" : "; did you mean '" + nearest + "'?");
        },
        "");
}

CLI::Validator notEmpty() {
    return CLI::Validator(
        [](const std::string& text) { return std::string(text.empty() ? "the name is empty" : ""); }, "");
}

CLI::Validator wholeNumber(long long least, long long most) {
    return CLI::Validator(
        [least, most](const std::string& text) -> std::string {
            long long number = 0;
            const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), number);
            const bool whole = failed == std::errc() && end == text.data() + text.size();
            if (whole && number >= least && number <= most)
                return {};
            return "'" + text + "' is not a whole number from " + std::to_string(least) + " to " +
                   std::to_string(most);
        },
        "");
}

} // namespace franken::cli
