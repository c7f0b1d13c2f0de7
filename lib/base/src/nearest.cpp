// SPDX-License-Identifier: MIT
#include "franken/nearest.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <tuple>
#include <vector>

namespace franken {
namespace {

constexpr std::size_t kMaxWord = 64; // A file may hold megabytes without a space.

/// Optimal string alignment (Damerau 1964), on three rows.
std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::swap(before, last);
        std::swap(last, row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
    }
    return row[b.size()];
}

struct Numbered {
    std::string_view stem;
    long number = -1; ///< -1 for a word without one.
};

Numbered split(std::string_view word) {
    const std::size_t end = word.find_last_not_of("0123456789");
    const std::string_view stem = word.substr(0, end == std::string_view::npos ? 0 : end + 1);
    const std::string_view digits = word.substr(stem.size());
    if (digits.empty() || stem.empty())
        return {word, -1};
    constexpr std::size_t kMaxDigits = 9;
    return {stem, std::strtol(std::string(digits.substr(0, kMaxDigits)).c_str(), nullptr, 10)};
}

/// Words of a series differ by their number, however many digits it has.
std::size_t distance(const Numbered& a, const Numbered& b, std::string_view text, std::string_view word) {
    const bool series = a.number >= 0 && b.number >= 0;
    return series ? editDistance(a.stem, b.stem) + (a.number != b.number ? 1 : 0) : editDistance(text, word);
}

std::string inLowerCase(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z')
            c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

} // namespace

std::string_view nearestWord(std::string_view typed, std::span<const std::string_view> words) {
    const std::string text = inLowerCase(typed.substr(0, kMaxWord));
    const Numbered wrong = split(text);
    std::string_view best;
    std::tuple<std::size_t, long> least{};
    for (const std::string_view word : words) {
        const std::string lower = inLowerCase(word);
        const Numbered right = split(lower);
        // Who leaves the number out means the first of the series, not none.
        const long apart = std::labs((wrong.number < 0 ? 1 : wrong.number) - right.number);
        const std::tuple<std::size_t, long> score{distance(wrong, right, text, lower), apart};
        if (best.empty() || score < least) {
            best = word;
            least = score;
        }
    }
    const std::size_t allowed = std::max<std::size_t>(1, std::max(text.size(), best.size()) * 2 / 5);
    return best.empty() || std::get<0>(least) > allowed ? std::string_view() : best;
}

} // namespace franken
