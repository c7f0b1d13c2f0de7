// SPDX-License-Identifier: MIT
#include "franken/manifest.h"

#include "franken/generator/manifest.h"
#include "franken/printable.h"
#include "manifest_text.h"

#include <algorithm>
#include <cstdio>
#include <string>

namespace franken {
namespace {

constexpr std::string_view kHeading = "# FrankenShader manifest, schema ";
constexpr std::string_view kWraps = "rcm"; // In the order of Wrap.

/// CRC-32 as in ISO 3309 (zlib's, PNG's): reflected, polynomial 0x04C11DB7.
std::uint32_t crc32(std::string_view text) {
    std::uint32_t crc = ~0u;
    for (const char c : text) {
        crc ^= static_cast<std::uint8_t>(c);
        for (int bit = 0; bit < 8; ++bit)
            crc = crc >> 1 ^ ((crc & 1u) != 0 ? 0xEDB88320u : 0u);
    }
    return ~crc;
}

std::string heading() { return std::string(kHeading) + std::to_string(kSchemaVersion) + "\n"; }

std::string endLine(std::size_t count, std::uint32_t crc) {
    char line[64];
    std::snprintf(line, sizeof(line), "# end %zu %08x\n", count, static_cast<unsigned>(crc));
    return line;
}

bool blendsByName(const Permutation& permutation) { return permutation.alpha == Alpha::Blend; }

std::string lineOf(const ProgramUse& use) {
    const DrawState usual;
    std::string line = toName(use.permutation);
    for (std::size_t unit = 0; unit < DrawState::kUnits; ++unit)
        if (const auto [s, t] = use.state.wraps[unit]; !(use.state.wraps[unit] == usual.wraps[unit]))
            line += " wrap" + std::to_string(unit) + "=" + kWraps[static_cast<std::size_t>(s)] +
                    kWraps[static_cast<std::size_t>(t)];
    if (use.state.blend != blendsByName(use.permutation))
        line += use.state.blend ? " blend=on" : " blend=off";
    return line + "\n";
}

bool readState(std::string_view word, DrawState& state) {
    if (word == "blend=on" || word == "blend=off") {
        state.blend = word == "blend=on";
        return true;
    }
    constexpr std::string_view kForm = "wrap0=rr";
    if (word.size() != kForm.size() || !word.starts_with("wrap") || word[5] != '=')
        return false;
    const auto unit = static_cast<std::size_t>(word[4] - '0');
    const std::size_t s = kWraps.find(word[6]), t = kWraps.find(word[7]);
    if (unit >= DrawState::kUnits || s == std::string_view::npos || t == std::string_view::npos)
        return false;
    state.wraps[unit] = {static_cast<Wrap>(s), static_cast<Wrap>(t)};
    return true;
}

Result<ProgramUse> readLine(const ManifestLine& line, const std::string& file) {
    const std::string where = file + ":" + std::to_string(line.number);
    const auto refuse = [&](const Error& error) {
        return Error{"manifest.line", where + (error.where.empty() ? "" : ": " + error.where), error.what,
                     error.remedy};
    };
    const Result<Permutation> parsed = parseName(line.name);
    if (!parsed)
        return refuse(parsed.error());
    const Result<Canonical> canonical = canonicalise(*parsed);
    if (!canonical)
        return refuse(canonical.error());
    ProgramUse use{canonical->permutation, {.blend = blendsByName(canonical->permutation)}};
    for (std::string_view rest = line.state; !rest.empty();) {
        const std::string_view word = rest.substr(0, rest.find_first_of(" \t"));
        if (!readState(word, use.state))
            return refuse({"", "", "'" + std::string(word) + "' is no state", "write wrap0=rc, blend=on"});
        rest.remove_prefix(word.size());
        rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
    }
    return use;
}

/// That a text which we wrote is whole and of this version.
Result<void> checkWhole(std::string_view text, std::size_t count, const std::string& file) {
    if (text.find('\n') == std::string_view::npos)
        return Error{"manifest.damaged", file, "it was cut", "delete it: it is written anew"};
    if (!text.starts_with(heading()))
        return Error{"manifest.schema", file, "another version of the library wrote it",
                     "delete it: it is written anew"};
    const std::size_t end = text.rfind("# end ");
    if (end == std::string_view::npos || text.substr(end) != endLine(count, crc32(text.substr(0, end))))
        return Error{"manifest.damaged", file, "it was cut, or changed after it was written",
                     "delete it: it is written anew"};
    return {};
}

} // namespace

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

std::string manifestLinesOf(std::span<const ProgramUse> uses) {
    std::string text;
    for (const ProgramUse& use : uses)
        text += lineOf(use);
    return text;
}

std::string toManifest(std::span<const ProgramUse> uses) {
    const std::string text = heading() + manifestLinesOf(uses);
    return text + endLine(uses.size(), crc32(text));
}

Result<std::vector<ProgramUse>> parseManifest(std::string_view text, const std::string& name) {
    if (text.size() > kMaxManifestBytes)
        return Error{"manifest.size", name, "it is larger than 1 MiB", "keep what is needed"};
    text = withoutByteOrderMark(text);
    const std::vector<ManifestLine> lines = manifestLines(text);
    const bool byUs = isByUs(text);
    if (byUs) {
        if (Result<void> whole = checkWhole(text, lines.size(), name); !whole)
            return whole.error();
    } else if (lines.empty()) {
        return Error{"manifest.empty", name, "it lists no program", "list names, one a line"};
    }
    std::vector<ProgramUse> uses;
    for (const ManifestLine& line : lines) {
        const Result<ProgramUse> use = readLine(line, name);
        // A whole text of ours with a word that we do not know: by a version that had other words.
        if (!use && byUs)
            return Error{"manifest.schema", use.error().where, use.error().what,
                         "delete it: it is written anew"};
        if (!use)
            return use.error();
        uses.push_back(*use);
    }
    return uses;
}

} // namespace franken
