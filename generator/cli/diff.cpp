// SPDX-License-Identifier: MIT
#include "commands.h"
#include "json.h"
#include "program.h"
#include "selection.h"
#include "unified_diff.h"

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

} // namespace

ExitCode run(const DiffOptions& options, Console& console) {
    const auto first = resolve(options.first, "", console);
    const auto second = resolve(options.second, "", console);
    if (!first || !second)
        return ExitCode::Refused;
    const Program a(*first), b(*second);
    const std::string vertex =
        unifiedDiff(a.name + ".vert", a.composed.vertex.text, b.name + ".vert", b.composed.vertex.text);
    const std::string fragment =
        unifiedDiff(a.name + ".frag", a.composed.fragment.text, b.name + ".frag", b.composed.fragment.text);
    if (options.json)
        console.write(diffJson(a, b, vertex, fragment));
    else
        for (const std::string& diff : {vertex, fragment})
            for (const std::string_view line : linesOf(diff))
                console.write(console.paint(styleOf(line), line) + "\n");
    return vertex.empty() && fragment.empty() ? ExitCode::Ok : ExitCode::Failed;
}

} // namespace franken::cli
