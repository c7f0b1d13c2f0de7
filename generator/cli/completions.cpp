// SPDX-License-Identifier: MIT
#include "app.h"

#include "franken/generator/choices.h"

#include <sstream>

namespace franken::cli {
namespace {

struct CommandWords {
    std::string name, about;
    std::vector<std::string> options;
    std::vector<std::pair<std::string, std::string>> described; ///< An option without dashes, and its help.
};

std::vector<CommandWords> wordsOf(const CLI::App& app) {
    std::vector<CommandWords> all;
    for (const CLI::App* command : shownCommands(app)) {
        CommandWords words{command->get_name(), command->get_description(), {}, {}};
        for (const CLI::Option* option : command->get_options())
            for (const std::string& name : option->get_lnames()) {
                words.options.push_back("--" + name);
                words.described.emplace_back(name, option->get_description());
            }
        all.push_back(std::move(words));
    }
    return all;
}

std::string permutationWords() {
    std::string words;
    for (const Choice& choice : choices())
        for (const Option& option : choice.options)
            words.append(words.empty() ? "" : " ").append(option.word);
    return words;
}

std::string commandNames(const std::vector<CommandWords>& commands) {
    std::string names;
    for (const CommandWords& command : commands)
        names += (names.empty() ? "" : " ") + command.name;
    return names;
}

// The last word of a name is completed: what stands before the last '.' or '+' stays.
std::string bash(const std::vector<CommandWords>& commands) {
    std::ostringstream script;
    script << "# bash completion for frankenshader\n"
              "_frankenshader() {\n"
              "    local word=${COMP_WORDS[COMP_CWORD]} options= head=\n"
              "    if [ \"$COMP_CWORD\" = 1 ]; then\n"
              "        COMPREPLY=($(compgen -W '"
           << commandNames(commands)
           << " --help --version' -- \"$word\"))\n"
              "        return\n"
              "    fi\n"
              "    case ${COMP_WORDS[1]} in\n";
    for (const CommandWords& command : commands)
        script << "        " << command.name << ") options='" << CLI::detail::join(command.options, " ")
               << "' ;;\n";
    script << "    esac\n"
              "    case $word in\n"
              "        -*) COMPREPLY=($(compgen -W \"$options\" -- \"$word\")); return ;;\n"
              "        */*) COMPREPLY=($(compgen -f -- \"$word\")); return ;;\n"
              "        *[.+]*) head=${word%\"${word##*[.+]}\"} ;;\n"
              "    esac\n"
              "    case ${COMP_WORDS[1]} in\n"
              "        help) COMPREPLY=($(compgen -W '"
           << commandNames(commands)
           << "' -- \"$word\")) ;;\n"
              "        completions) COMPREPLY=($(compgen -W '"
           << CLI::detail::join(kShells, " ")
           << "' -- \"$word\")) ;;\n"
              "        *) COMPREPLY=($(compgen -P \"$head\" -W '"
           << permutationWords()
           << "' -- \"${word#\"$head\"}\") $(compgen -f -- \"$word\")) ;;\n"
              "    esac\n"
              "}\n"
              "complete -o nospace -F _frankenshader frankenshader\n";
    return script.str();
}

std::string zsh(const std::vector<CommandWords>& commands) {
    std::ostringstream script;
    script << "#compdef frankenshader\n"
              "local -a commands options\n"
              "commands=(\n";
    for (const CommandWords& command : commands)
        script << "    " << quoted(command.name + ":", false).substr(0, command.name.size() + 2)
               << quoted(command.about, true).substr(1) << "\n";
    script << ")\n"
              "if (( CURRENT == 2 )); then\n"
              "    _describe command commands\n"
              "    return\n"
              "fi\n"
              "case $words[2] in\n";
    for (const CommandWords& command : commands) {
        script << "    " << command.name << ") options=(";
        for (const auto& [name, about] : command.described)
            script << " '--" << name << ":'" << quoted(about, true);
        script << " ) ;;\n";
    }
    script << "esac\n"
              "if [[ $PREFIX == -* ]]; then\n"
              "    _describe option options\n"
              "else\n"
              "    [[ $PREFIX == *[.+]* ]] && compset -P '*[.+]'\n"
              "    compadd -S '' "
           << permutationWords()
           << "\n"
              "    _files\n"
              "fi\n";
    return script.str();
}

std::string fish(const std::vector<CommandWords>& commands) {
    std::ostringstream script;
    script << "# fish completion for frankenshader\n";
    for (const CommandWords& command : commands) {
        script << "complete -c frankenshader -n __fish_use_subcommand -f -a " << command.name << " -d "
               << quoted(command.about, false) << "\n";
        for (const auto& [name, about] : command.described)
            script << "complete -c frankenshader -n '__fish_seen_subcommand_from " << command.name << "' -l "
                   << name << " -d " << quoted(about, false) << "\n";
    }
    script << "complete -c frankenshader -n 'not __fish_use_subcommand' -a '" << permutationWords() << "'\n";
    return script.str();
}

} // namespace

std::string completionsFor(const CLI::App& app, std::string_view shell) {
    const std::vector<CommandWords> commands = wordsOf(app);
    if (shell == "bash")
        return bash(commands);
    return shell == "zsh" ? zsh(commands) : fish(commands);
}

} // namespace franken::cli
