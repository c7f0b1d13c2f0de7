// SPDX-License-Identifier: MIT
#include "columns.h"
#include "commands.h"
#include "explanation.h"
#include "json.h"
#include "selection.h"

#include <algorithm>

namespace franken::cli {
namespace {

std::string shortOrigin(const LineOrigin& origin) {
    if (origin.effect)
        return toString(origin);
    return origin.snippet.empty() ? "" : std::string(origin.snippet) + ".glsl:" + std::to_string(origin.line);
}

std::string wordsOf(const ExplainedLine& line) { return line.reason ? toText(*line.reason) : ""; }

void writeStage(Console& console, std::string_view title, const std::vector<ExplainedLine>& lines) {
    std::size_t originWidth = 0, wordsWidth = 0;
    for (const ExplainedLine& line : lines) {
        originWidth = std::max(originWidth, shortOrigin(line.origin).size());
        wordsWidth = std::max(wordsWidth, wordsOf(line).size());
    }
    console.write("\n" + console.paint(Style::Bold, title) + "\n");
    for (std::size_t i = 0; i < lines.size(); ++i) {
        console.write(right(std::to_string(i + 1), 4) + "  " +
                      console.paint(Style::Dim, left(shortOrigin(lines[i].origin), originWidth)) + "  " +
                      console.paint(Style::Cyan, left(wordsOf(lines[i]), wordsWidth)) + "  | " +
                      std::string(lines[i].text) + "\n");
    }
}

void writeBudgets(Console& console, const std::vector<ProfileBudget>& budgets) {
    constexpr std::size_t kNameWidth = 13, kWidth = 19;
    std::string head = left("budget", kNameWidth);
    for (const Use& use : budgets.front().budget.uses)
        head += left(std::string(toText(use.resource)), kWidth);
    console.write("\n" + console.paint(Style::Bold, head.substr(0, head.find_last_not_of(' ') + 1)) + "\n");
    for (const ProfileBudget& each : budgets) {
        console.write(left(std::string(each.profile.name), kNameWidth));
        for (const Use& use : each.budget.uses) {
            const std::string text = std::to_string(use.used) + " of " + std::to_string(use.limit);
            const bool last = &use == &each.budget.uses.back();
            console.write(console.paint(use.exceeded() ? Style::Red : Style::Plain,
                                        left(text + (use.exceeded() ? " !" : ""), last ? 0 : kWidth)));
        }
        console.write("\n");
        for (const Excess& excess : each.excesses)
            console.write("  ! " + std::string(toText(excess.use.resource)) + ": " + adviceFor(excess) +
                          "\n");
    }
}

} // namespace

ExitCode run(const ExplainOptions& options, Console& console) {
    const Result<Canonical> canonical = readName(options.name);
    if (!canonical)
        return console.error(canonical.error()), ExitCode::Refused;
    const Explanation explanation(Program(canonical->permutation), canonical->dropped);
    if (options.json) {
        console.write(explainJson(explanation));
        return ExitCode::Ok;
    }
    const Program& program = explanation.program;
    console.write(console.paint(Style::Bold, program.name) + "\nkey " + toHex(toKey(program.permutation)) +
                  "\n");
    for (const Dropped& dropped : explanation.dropped)
        console.write("dropped '" + dropped.word + "': " + dropped.reason + "\n");
    writeBudgets(console, explanation.budgets);
    writeStage(console, "vertex shader: line, snippet below generator/glsl, words that brought it",
               explanation.vertex);
    writeStage(console, "fragment shader: line, snippet below generator/glsl, words that brought it",
               explanation.fragment);
    return ExitCode::Ok;
}

} // namespace franken::cli
