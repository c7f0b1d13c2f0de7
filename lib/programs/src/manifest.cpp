// SPDX-License-Identifier: MIT
#include "franken/manifest.h"

#include "franken/generator/manifest.h"
#include "manifest_text.h"

#include <algorithm>
#include <charconv>
#include <string>

namespace franken {
namespace {

constexpr std::string_view kWraps = "rcm"; // In the order of Wrap.

bool blendsByName(const Permutation& permutation) { return permutation.alpha == Alpha::Blend; }

std::string lineOf(const ProgramUse& use, const SnippetSet& snippets) {
    const DrawState usual;
    std::string line = toName(use.permutation, snippets);
    for (std::size_t unit = 0; unit < kTextureUnits; ++unit)
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
    constexpr std::string_view kWrap = "wrap";
    if (!word.starts_with(kWrap))
        return false;
    std::size_t unit = 0; // "wrap12=rr"
    const auto [end, failed] = std::from_chars(word.data() + kWrap.size(), word.data() + word.size(), unit);
    const std::string_view wraps(end, static_cast<std::size_t>(word.data() + word.size() - end));
    if (failed != std::errc() || unit >= kTextureUnits || wraps.size() != 3 || wraps[0] != '=')
        return false;
    const std::size_t s = kWraps.find(wraps[1]), t = kWraps.find(wraps[2]);
    if (s == std::string_view::npos || t == std::string_view::npos)
        return false;
    state.wraps[unit] = {static_cast<Wrap>(s), static_cast<Wrap>(t)};
    return true;
}

bool isOfEffect(const Error& error) { return error.code.starts_with("effect."); }

Result<ProgramUse> readLine(const ManifestLine& line, const std::string& file, const SnippetSet& snippets) {
    const std::string where = file + ":" + std::to_string(line.number);
    const auto refuse = [&](const Error& error) {
        return Error{isOfEffect(error) ? error.code : "manifest.line",
                     where + (error.where.empty() ? "" : ": " + error.where), error.what, error.remedy};
    };
    const Result<Permutation> parsed = parseName(line.name, snippets);
    if (!parsed)
        return refuse(parsed.error());
    const Result<Canonical> canonical = canonicalise(*parsed);
    if (!canonical)
        return refuse(canonical.error());
    ProgramUse use{canonical->permutation, {.blend = blendsByName(canonical->permutation)}};
    for (std::string_view rest = line.state; !rest.empty();) {
        const std::string_view word = rest.substr(0, rest.find_first_of(" \t"));
        if (!readState(word, use.state))
            return refuse({"", "", "'" + std::string(word) + "' is not a state",
                           "states are written like wrap0=rc or blend=on"});
        rest.remove_prefix(word.size());
        rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
    }
    return use;
}

std::string textOf(const ManifestLine& line) {
    return std::string(line.name) + (line.state.empty() ? "" : " ") + std::string(line.state) + "\n";
}

} // namespace

std::string manifestLinesOf(std::span<const ProgramUse> uses, const SnippetSet& snippets) {
    std::string text;
    for (const ProgramUse& use : uses)
        if (snippets.check(use.permutation.effect))
            text += lineOf(use, snippets);
    return text;
}

std::string manifestOfLines(const std::string& lines) {
    return wholeManifest(lines, static_cast<std::size_t>(std::count(lines.begin(), lines.end(), '\n')));
}

std::string toManifest(std::span<const ProgramUse> uses, const SnippetSet& snippets) {
    return manifestOfLines(manifestLinesOf(uses, snippets));
}

Result<ManifestContents> readContents(std::string_view text, const std::string& name,
                                      const SnippetSet& snippets) {
    if (text.size() > kMaxManifestBytes)
        return Error{"manifest.size", name, "it is larger than 1 MiB", "remove programs that are not needed"};
    const Result<ManifestLines> parsed = parseManifestLines(text, name);
    if (!parsed)
        return parsed.error();
    ManifestContents contents;
    for (const ManifestLine& line : parsed->lines) {
        const Result<ProgramUse> use = readLine(line, name, snippets);
        if (!use && isOfEffect(use.error())) {
            contents.skipped.push_back({textOf(line), use.error()});
            continue;
        }
        // A whole text of ours with a word that we do not know: by a version that had other words.
        if (!use && parsed->byUs)
            return Error{"manifest.schema", use.error().where, use.error().what,
                         "delete it; it will be written again"};
        if (!use)
            return use.error();
        contents.uses.push_back(*use);
    }
    return contents;
}

Result<std::vector<ProgramUse>> parseManifest(std::string_view text, const std::string& name,
                                              const SnippetSet& snippets, const Log& log) {
    Result<ManifestContents> contents = readContents(text, name, snippets);
    if (!contents)
        return contents.error();
    for (const SkippedLine& line : contents->skipped)
        if (log)
            log(LogLevel::Warning, "a program of the manifest is skipped: " + toString(line.error));
    return std::move(contents->uses);
}

} // namespace franken
