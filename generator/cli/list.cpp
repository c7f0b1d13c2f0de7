// SPDX-License-Identifier: MIT
#include "columns.h"
#include "commands.h"
#include "effects.h"
#include "franken/generator/choices.h"
#include "json.h"
#include "selection.h"

namespace franken::cli {
namespace {

constexpr std::size_t kMostCounted = 1'000'000; // Some seconds.

void writeWords(Console& console) {
    for (const Choice& choice : choices()) {
        console.write(console.paint(Style::Bold, choice.name) + "\n");
        for (const Option& option : choice.options)
            console.write("  " + console.paint(Style::Cyan, left(std::string(option.word), 20)) + "  " +
                          std::string(option.meaning) + "\n");
    }
}

} // namespace

ExitCode run(const ListOptions& options, Console& console) {
    if (options.words)
        return options.json ? console.write(wordsJson()) : writeWords(console), ExitCode::Ok;
    std::vector<Permutation> listed;
    SelectionOptions selection = options.selection;
    if (options.count && !selection.limit)
        selection.limit = kMostCounted; // The limit of a list is for people who read it.
    const auto selected = select(selection, console, [&](const Permutation& permutation) {
        if (options.json && !options.count)
            listed.push_back(permutation);
        else if (!options.count)
            console.write(toName(permutation, snippets()) + "\n");
    });
    if (!selected)
        return ExitCode::Refused;
    if (options.json)
        console.write(listJson(listed, *selected));
    else if (options.count)
        console.write((selected->complete ? "" : "more than ") + std::to_string(selected->count) + "\n");
    console.note(std::to_string(selected->count) +
                 (selected->complete ? " listed" : " listed, there are more") +
                 "; the product of the choices is " + std::to_string(selected->product));
    return ExitCode::Ok;
}

} // namespace franken::cli
