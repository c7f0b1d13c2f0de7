// SPDX-License-Identifier: MIT
#include "unified_diff.h"

#include "program.h"

#include <algorithm>

namespace franken::cli {
namespace {

constexpr std::size_t kContext = 3;

using Lines = std::vector<std::string_view>;

/// A line of the diff, with the number of lines of either text that came before it.
struct Edit {
    char mark; ///< ' ', '-' or '+'.
    std::string_view line;
    std::size_t first, second;
};

// common[i * stride + j]: the length of the longest common subsequence of the texts from i and from j on.
std::vector<std::size_t> commonLengths(const Lines& first, const Lines& second) {
    const std::size_t stride = second.size() + 1;
    std::vector<std::size_t> common((first.size() + 1) * stride);
    for (std::size_t i = first.size(); i-- > 0;)
        for (std::size_t j = second.size(); j-- > 0;)
            common[i * stride + j] = first[i] == second[j]
                                         ? common[(i + 1) * stride + j + 1] + 1
                                         : std::max(common[(i + 1) * stride + j], common[i * stride + j + 1]);
    return common;
}

std::vector<Edit> editsOf(const Lines& first, const Lines& second) {
    const std::vector<std::size_t> common = commonLengths(first, second);
    const std::size_t stride = second.size() + 1;
    std::vector<Edit> edits;
    for (std::size_t i = 0, j = 0; i < first.size() || j < second.size();) {
        const bool remains = i < first.size() && j < second.size();
        if (remains && first[i] == second[j]) {
            edits.push_back({' ', first[i], i, j});
            ++i, ++j;
        } else if (j == second.size() ||
                   (remains && common[(i + 1) * stride + j] >= common[i * stride + j + 1])) {
            edits.push_back({'-', first[i], i, j});
            ++i;
        } else {
            edits.push_back({'+', second[j], i, j});
            ++j;
        }
    }
    return edits;
}

// The end of the hunk whose first change is at `change`: changes closer than two contexts share one.
std::size_t endOfHunk(const std::vector<Edit>& edits, std::size_t change) {
    std::size_t last = change;
    for (std::size_t i = change; i < edits.size() && i <= last + 2 * kContext + 1; ++i)
        if (edits[i].mark != ' ')
            last = i;
    return std::min(last + kContext + 1, edits.size());
}

// "12,5", or "12" for one line; an empty range is said to begin at the line before it.
std::string range(std::size_t before, std::size_t count) {
    if (count == 1)
        return std::to_string(before + 1);
    return std::to_string(count == 0 ? before : before + 1) + "," + std::to_string(count);
}

std::string hunk(const std::vector<Edit>& edits, std::size_t begin, std::size_t end) {
    std::size_t firsts = 0, seconds = 0;
    std::string body;
    for (std::size_t i = begin; i < end; ++i) {
        firsts += edits[i].mark != '+' ? 1 : 0;
        seconds += edits[i].mark != '-' ? 1 : 0;
        body.append(1, edits[i].mark).append(edits[i].line).append("\n");
    }
    return "@@ -" + range(edits[begin].first, firsts) + " +" + range(edits[begin].second, seconds) + " @@\n" +
           body;
}

} // namespace

std::string unifiedDiff(std::string_view firstName, std::string_view first, std::string_view secondName,
                        std::string_view second) {
    if (first == second)
        return {};
    const std::vector<Edit> edits = editsOf(linesOf(first), linesOf(second));
    std::string diff = "--- " + std::string(firstName) + "\n+++ " + std::string(secondName) + "\n";
    for (std::size_t i = 0; i < edits.size(); ++i)
        if (edits[i].mark != ' ') {
            const std::size_t end = endOfHunk(edits, i);
            diff += hunk(edits, i - std::min(i, kContext), end);
            i = end;
        }
    return diff;
}

} // namespace franken::cli
