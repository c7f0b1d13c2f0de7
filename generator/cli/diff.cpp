// SPDX-License-Identifier: MIT
#include "commands.h"
#include "diff_folder.h"
#include "json.h"
#include "program.h"
#include "selection.h"
#include "unified_diff.h"

#include <algorithm>

namespace franken::cli {
namespace {

Style styleOf(std::string_view line) {
    if (line.starts_with("---") || line.starts_with("+++"))
        return Style::Bold;
    switch (line.empty() ? ' ' : line.front()) {
    case '-':
        return Style::Red;
    case '+':
        return Style::Green;
    case '@':
        return Style::Cyan;
    default:
        return Style::Plain;
    }
}

void writeDiff(Console& console, const std::string& diff) {
    for (const std::string_view line : linesOf(diff))
        console.write(console.paint(styleOf(line), console.foreign(line)) + "\n");
}

ExitCode diffFolder(const DiffOptions& options, Console& console) {
    const auto programs = compareFolder(options.against);
    if (!programs)
        return console.error(programs.error()), ExitCode::Refused;
    const auto differing =
        std::count_if(programs->begin(), programs->end(), [](const auto& each) { return !each.same(); });
    if (options.json)
        console.write(diffFolderJson(options.against, *programs));
    else
        for (const FolderProgram& program : *programs) {
            if (!program.refused.empty())
                console.write(console.foreign(program.name) + ": there is no such program any more: " +
                              std::string(linesOf(program.refused).front()) + "\n");
            writeDiff(console, program.vertex);
            writeDiff(console, program.fragment);
        }
    console.note(std::to_string(programs->size()) + " programs compared, " + std::to_string(differing) +
                 " differ");
    return differing == 0 ? ExitCode::Ok : ExitCode::Failed;
}

} // namespace

ExitCode run(const DiffOptions& options, Console& console) {
    if (!options.against.empty())
        return diffFolder(options, console);
    const auto first = resolve(options.names[0], "", console);
    const auto second = resolve(options.names[1], "", console);
    if (!first || !second)
        return ExitCode::Refused;
    const Program a(*first), b(*second);
    const std::string vertex =
        unifiedDiff(a.name + ".vert", a.composed.vertex.text, b.name + ".vert", b.composed.vertex.text);
    const std::string fragment =
        unifiedDiff(a.name + ".frag", a.composed.fragment.text, b.name + ".frag", b.composed.fragment.text);
    if (options.json) {
        console.write(diffJson(a, b, vertex, fragment));
    } else {
        writeDiff(console, vertex);
        writeDiff(console, fragment);
    }
    return vertex.empty() && fragment.empty() ? ExitCode::Ok : ExitCode::Failed;
}

} // namespace franken::cli
