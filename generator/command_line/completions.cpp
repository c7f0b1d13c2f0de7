// SPDX-License-Identifier: MIT
#include "franken/command_line/manual.h"

#include "franken/command_line/mistake.h"

#include <sstream>

namespace franken::cli {
namespace {

struct Word {
    std::string option, about; ///< The option without dashes.
    bool takesValue, takesPath;
};

std::vector<Word> wordsOf(const CLI::App& app) {
    std::vector<Word> words;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames()) {
            const bool value = option->get_items_expected_max() > 0;
            const std::string type = option->get_type_name();
            words.push_back({name, option->get_description(), value,
                             value && (type == "FILE" || type == "FOLDER" || type == "PATH")});
        }
    return words;
}

// "-o|--output-file|..." of options whose value no shell can guess.
std::string withoutGuess(const std::vector<Word>& words) {
    std::string pattern;
    for (const Word& word : words)
        if (word.takesValue && !word.takesPath)
            pattern += (pattern.empty() ? "--" : "|--") + word.option;
    return pattern;
}

std::string functionOf(const std::string& name) {
    std::string function = "_" + name;
    for (char& c : function)
        if (c == '-')
            c = '_';
    return function;
}

std::string bash(const std::vector<Word>& words, const std::string& name, const std::string& commandNames) {
    const std::string function = functionOf(name);
    std::ostringstream script;
    script << "# bash completion for " << name << "\n"
           << function << "() {\n"
           << "    local word=${COMP_WORDS[COMP_CWORD]}\n"
              "    case ${COMP_WORDS[COMP_CWORD-1]} in\n        "
           << withoutGuess(words)
           << ") COMPREPLY=(); return ;;\n    esac\n    case $word in\n        -*) COMPREPLY=($(compgen -W '";
    for (const Word& word : words)
        script << "--" << word.option << ' ';
    script << "' -- \"$word\")) ;;\n        *) COMPREPLY=($(compgen -W '" << commandNames
           << "' -- \"$word\") $(compgen -f -- \"$word\")) ;;\n    esac\n}\n"
           << "complete -o filenames -F " << function << " " << name << "\n";
    return script.str();
}

std::string zsh(const std::vector<Word>& words, const std::string& name, const std::string& commandNames) {
    std::ostringstream script;
    script << "#compdef " << name << "\nlocal -a options\noptions=(\n";
    for (const Word& word : words)
        script << "    '--" << word.option << ":'" << quoted(word.about, true) << "\n";
    script << ")\ncase ${words[CURRENT-1]} in\n    " << withoutGuess(words)
           << ") return 1 ;;\nesac\nif [[ $PREFIX == -* ]]; then\n    _describe option options\nelse\n    "
              "compadd -- "
           << commandNames << "\n    _files\nfi\n";
    return script.str();
}

std::string fish(const std::vector<Word>& words, const std::string& name, const std::string& commandNames) {
    std::ostringstream script;
    script << "# fish completion for " << name << "\n";
    for (const Word& word : words)
        script << "complete -c " << name << " -l " << word.option
               << (word.takesPath    ? " -r"
                   : word.takesValue ? " -x"
                                     : "")
               << " -d " << quoted(word.about, false) << "\n";
    if (!commandNames.empty())
        script << "complete -c " << name << " -n __fish_use_subcommand -a '" << commandNames << "'\n";
    return script.str();
}

} // namespace

std::string quoted(std::string_view text, bool colons) {
    std::string result = "'";
    for (const char c : text)
        result += c == '\'' ? "'\\''" : c == ':' && colons ? "\\:" : std::string(1, c);
    return result + "'";
}

std::string completionsOf(const CLI::App& app, const std::string& installedName, std::string_view shell) {
    const std::vector<Word> words = wordsOf(app);
    std::string commands;
    for (const CLI::App* command : shownCommands(app))
        commands += (commands.empty() ? "" : " ") + command->get_name();
    if (shell == "bash")
        return bash(words, installedName, commands);
    return shell == "zsh" ? zsh(words, installedName, commands) : fish(words, installedName, commands);
}

void addManual(CLI::App& app, const std::string& installedName) {
    // As the version of a program, they need nothing else of the command line.
    app.add_flag_callback(
        "--manual", [&app, installedName] { throw CLI::CallForVersion(manPageOf(app, installedName), 0); },
        "Prints the manual page, for man");
    app.add_option_function<std::string>(
           "--completions",
           [&app, installedName](const std::string& shell) {
               throw CLI::CallForVersion(completionsOf(app, installedName, shell), 0);
           },
           "Prints what a shell completes command lines with: " + CLI::detail::join(kShells, ", "))
        ->type_name("SHELL")
        ->check(oneOf(kShells));
}

} // namespace franken::cli
