// SPDX-License-Identifier: MIT
#include "franken/command_line/manual.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace franken::cli {
namespace {

// What roff takes for itself: backslashes, dashes, and a dot or a quote that begins a line.
std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text)
        if (c == '\\')
            result += "\\e";
        else if (c == '-')
            result += "\\-";
        else
            result += c;
    if (result.starts_with('.') || result.starts_with('\''))
        result.insert(0, "\\&");
    return result;
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

// One paragraph: roff breaks its lines anew.
std::string paragraph(const std::string& text) {
    std::string result;
    for (const std::string& line : linesOf(text))
        result += escaped(line) + "\n";
    return result;
}

// "-o, --output FILE", or "MODEL" for what has no dashes.
std::string term(const CLI::Option& option) {
    std::string names;
    const auto add = [&names](const std::string& name) {
        names += (names.empty() ? "\\fB" : ", \\fB") + escaped(name) + "\\fR";
    };
    for (const std::string& name : option.get_snames())
        add("-" + name);
    for (const std::string& name : option.get_lnames())
        add("--" + name);
    if (names.empty())
        return "\\fI" + escaped(option.get_name(true)) + "\\fR";
    const std::string type = option.get_type_name();
    return type.empty() || option.get_items_expected_max() == 0 ? names
                                                                : names + " \\fI" + escaped(type) + "\\fR";
}

std::string optionsOf(const CLI::App& app) {
    std::string text;
    for (const CLI::Option* option : app.get_options())
        text += ".TP\n" + term(*option) + "\n" + paragraph(option->get_description());
    return text;
}

// What stands behind "Example: ", say, in a footer, to the next such word; or what stands before all of them.
std::string partOf(const std::string& footer, const std::string& beginning) {
    std::string part, current;
    for (const std::string& line : linesOf(footer)) {
        for (const char* word : {"Exit codes:", "Example:"})
            if (line.starts_with(word))
                current = word;
        if (current == beginning)
            part += (line.starts_with(current) ? line.substr(current.size()) : line) + "\n";
    }
    part.erase(0, part.find_first_not_of(' '));
    return part;
}

// "0 ok, 2 usage, 3 a file was refused": a paragraph a code.
std::string exitCodes(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    std::string result;
    const auto isCode = [](const std::string& word) {
        return !word.empty() &&
               std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isdigit(c); });
    };
    std::istringstream words(text);
    for (std::string word; words >> word;)
        if (isCode(word))
            result += (result.empty() ? "" : "\n") + (".TP\n.B " + word + "\n");
        else
            result += escaped(word) + " ";
    // A comma or a full stop ends what stands before the next code.
    for (std::size_t end = 0; (end = result.find(" \n", end)) != std::string::npos;)
        result.erase(end - 1, result[end - 1] == ',' ? 2 : 1);
    return result + "\n";
}

// A command line of the build tree, as the installed program is called.
std::string installed(std::string commandLine, const CLI::App& app, const std::string& installedName) {
    if (commandLine.starts_with(app.get_name() + " "))
        commandLine.replace(0, app.get_name().size(), installedName);
    return commandLine;
}

std::string positionalsOf(const CLI::App& app) {
    std::string names;
    for (const CLI::Option* option : app.get_options())
        if (option->get_lnames().empty() && option->get_snames().empty()) {
            const std::string name = "\\fI" + escaped(option->get_name(true)) + "\\fR";
            const std::string more = option->get_items_expected_max() > 1 ? "..." : "";
            names += option->get_required() ? " " + name + more : " [" + name + more + "]";
        }
    return names;
}

std::string synopsisOf(const CLI::App& app) {
    std::string text = ".nf\n";
    const std::string name = escaped(app.get_name());
    for (const CLI::App* command : shownCommands(app))
        text += "\\fB" + name + " " + escaped(command->get_name()) + "\\fR [\\fIoptions\\fR]" +
                positionalsOf(*command) + "\n";
    return text + "\\fB" + name + "\\fR \\fB\\-\\-help\\fR | \\fB\\-\\-version\\fR\n.fi\n";
}

std::string optionsOfCommands(const CLI::App& app) {
    std::string text;
    for (const CLI::App* command : shownCommands(app))
        text += ".SS " + escaped(command->get_name()) + "\n" + paragraph(command->get_description()) +
                optionsOf(*command);
    return text;
}

} // namespace

std::string manPageOf(const CLI::App& app, const std::string& installedName) {
    std::string title = installedName;
    std::transform(title.begin(), title.end(), title.begin(),
                   [](unsigned char c) { return std::toupper(c); });
    const std::string about = app.get_description(), footer = app.get_footer();
    const std::string first = linesOf(about).front();
    std::string page = ".TH " + title + " 1 \"\" FrankenShader \"User Commands\"\n.SH NAME\n" +
                       escaped(installedName) + " \\- " +
                       escaped(first.substr(0, first.find_first_of(".,"))) + "\n.SH SYNOPSIS\n\\fB" +
                       escaped(installedName) + "\\fR [\\fIoptions\\fR]" + positionalsOf(app) +
                       "\n.SH DESCRIPTION\n" + paragraph(about);
    if (const std::string notes = partOf(footer, ""); !notes.empty())
        page += ".PP\n" + paragraph(notes);
    page += ".SH OPTIONS\n" + optionsOf(app);
    if (const std::string commands = optionsOfCommands(app); !commands.empty())
        page += ".SH COMMANDS\n" + commands;
    if (const std::string codes = partOf(footer, "Exit codes:"); !codes.empty())
        page += ".SH EXIT STATUS\n" + exitCodes(codes);
    if (const std::string example = partOf(footer, "Example:"); !example.empty())
        page += ".SH EXAMPLES\n.PP\n.RS\n" + paragraph(installed(example, app, installedName)) + ".RE\n";
    return page + ".SH SEE ALSO\n.BR frankenshader (1)\n";
}

std::string filledManPage(const CLI::App& app, const std::string& page) {
    std::string result;
    for (const std::string& line : linesOf(page))
        result += line == "@SYNOPSIS@"  ? synopsisOf(app)
                  : line == "@OPTIONS@" ? optionsOfCommands(app)
                                        : line + "\n";
    return result;
}

std::vector<const CLI::App*> shownCommands(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

} // namespace franken::cli
