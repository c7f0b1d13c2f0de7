// SPDX-License-Identifier: MIT
#include "franken/generator/manifest.h"

#include "franken/crc32.h"
#include "franken/generator/permutation.h"
#include "franken/printable.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>

namespace franken {
namespace {

constexpr std::string_view kHeading = "# FrankenShader manifest, schema ";
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

std::string heading() { return std::string(kHeading) + std::to_string(kSchemaVersion) + "\n"; }

std::string endLine(std::size_t count, std::uint32_t crc) {
    char line[64];
    std::snprintf(line, sizeof(line), "# end %zu %08x\n", count, static_cast<unsigned>(crc));
    return line;
}

/// That a text which we wrote is whole and of this version.
Result<void> checkWhole(std::string_view text, std::size_t count, const std::string& file) {
    if (text.find('\n') == std::string_view::npos)
        return Error{"manifest.damaged", file, "it was cut", "delete it; it will be written again"};
    if (!text.starts_with(heading()))
        return Error{"manifest.schema", file, "another version of the library wrote it",
                     "delete it; it will be written again"};
    const std::size_t end = text.rfind("# end ");
    if (end == std::string_view::npos || text.substr(end) != endLine(count, crc32(text.substr(0, end))))
        return Error{"manifest.damaged", file, "it was cut, or changed after it was written",
                     "delete it; it will be written again"};
    return {};
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

std::string wholeManifest(const std::string& lines, std::size_t count) {
    const std::string text = heading() + lines;
    return text + endLine(count, crc32(text));
}

bool isByUs(std::string_view text) {
    if (text.starts_with(kHeading))
        return true;
    // "# end 12 5d0b1a3c", and nothing else on the last line: a comment by hand may begin so as well.
    const std::size_t line = text.find_last_of('\n', text.size() - std::min<std::size_t>(text.size(), 2)) + 1;
    const std::string last(text.substr(line));
    std::size_t count = 0;
    unsigned crc = 0;
    return std::sscanf(last.c_str(), "# end %zu %x", &count, &crc) == 2 &&
           last.size() == endLine(count, crc).size();
}

bool isTorn(std::string_view text) {
    return heading().starts_with(text) ||
           text.find_first_not_of(std::string_view("\0 \t\r\n", 5)) == text.npos;
}

Result<ManifestLines> parseManifestLines(std::string_view text, const std::string& name) {
    text = withoutByteOrderMark(text);
    ManifestLines result{manifestLines(text), isByUs(text)};
    if (result.byUs) {
        if (Result<void> whole = checkWhole(text, result.lines.size(), name); !whole)
            return whole.error();
    } else if (result.lines.empty()) {
        return Error{"manifest.empty", name, "it lists no program", "write one program name per line"};
    }
    return result;
}

} // namespace franken
