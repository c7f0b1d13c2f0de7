// SPDX-License-Identifier: MIT
#include "franken/generator/manifest.h"

#include "franken/printable.h"

#include <algorithm>

namespace franken {
namespace {

constexpr std::string_view kSpace = " \t\r";

std::string_view trim(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(kSpace), text.size()));
    return text.substr(0, text.find_last_not_of(kSpace) + 1);
}

bool areStates(std::string_view words) {
    while (!words.empty()) {
        const std::string_view word = words.substr(0, words.find_first_of(kSpace));
        if (word.find('=') == std::string_view::npos)
            return false;
        words = trim(words.substr(word.size()));
    }
    return true;
}

} // namespace

std::vector<ManifestLine> manifestLines(std::string_view text) {
    std::vector<ManifestLine> lines;
    text = withoutByteOrderMark(text);
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::string_view whole = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(whole.size() + 1, text.size()));
        const std::string_view line = trim(whole.substr(0, whole.find('#')));
        if (line.empty())
            continue;
        const std::string_view name = line.substr(0, line.find_first_of(kSpace));
        const std::string_view rest = trim(line.substr(name.size()));
        if (areStates(rest))
            lines.push_back({name, rest, number});
        else
            lines.push_back({line, {}, number});
    }
    return lines;
}

} // namespace franken
