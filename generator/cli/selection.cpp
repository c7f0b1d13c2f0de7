// SPDX-License-Identifier: MIT
#include "selection.h"

#include "franken/generator/covering.h"
#include "franken/generator/space.h"
#include "manifest.h"

#include <set>

namespace franken::cli {
namespace {

using Permutations = std::vector<Permutation>;

// Words separated by '+', '.', ',' or space; '!' before a word forbids it.
Result<void> applyWhere(Space& space, std::string_view text) {
    constexpr std::string_view kSeparators = "+., ";
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(kSeparators), text.size()));
        if (text.empty())
            return {};
        std::string_view word = text.substr(0, text.find_first_of(kSeparators));
        text.remove_prefix(word.size());
        const bool forbidden = word.starts_with('!');
        word.remove_prefix(forbidden ? 1 : 0);
        if (auto narrowed = forbidden ? space.forbid(word) : space.require(word); !narrowed)
            return narrowed;
    }
}

Result<Space> spaceOf(const SelectionOptions& options) {
    Space space;
    for (const std::string& word : options.with)
        if (auto narrowed = space.require(word); !narrowed)
            return narrowed.error();
    for (const std::string& word : options.without)
        if (auto narrowed = space.forbid(word); !narrowed)
            return narrowed.error();
    for (const std::string& text : options.where)
        if (auto narrowed = applyWhere(space, text); !narrowed)
            return narrowed.error();
    return space;
}

std::optional<Permutations> resolveAll(const std::vector<ManifestEntry>& entries, Console& console) {
    Permutations permutations;
    bool refused = false;
    for (const ManifestEntry& entry : entries)
        if (const auto permutation = resolve(entry.name, entry.where, console))
            permutations.push_back(*permutation);
        else
            refused = true;
    if (refused)
        return std::nullopt;
    return permutations;
}

// What names, manifest or covering set list; nothing where one of them was refused.
std::optional<Permutations> listed(const SelectionOptions& options, Console& console) {
    if (options.covering)
        return coveringSet();
    std::vector<ManifestEntry> entries;
    for (const std::string& name : options.names)
        entries.push_back({name, ""});
    if (!options.manifest.empty()) {
        auto manifest = readManifest(options.manifest);
        if (!manifest) {
            console.error(manifest.error());
            return std::nullopt;
        }
        entries = std::move(*manifest);
    }
    return resolveAll(entries, console);
}

class Sieve {
public:
    Sieve(std::size_t limit, Shard shard, const std::function<void(const Permutation&)>& visit)
        : m_limit(limit), m_shard(shard), m_visit(visit) {}

    // False once the limit is reached and one more has come.
    bool offer(const Permutation& permutation) {
        if (m_limit > 0 && m_offered == m_limit)
            return m_selected.complete = false;
        if (m_offered++ % m_shard.count == m_shard.index - 1) {
            m_visit(permutation);
            ++m_selected.count;
        }
        return true;
    }

    Selected finish(std::uint64_t product) {
        m_selected.product = product;
        return m_selected;
    }

private:
    std::size_t m_limit;
    Shard m_shard;
    const std::function<void(const Permutation&)>& m_visit;
    std::size_t m_offered = 0;
    Selected m_selected;
};

} // namespace

std::optional<Permutation> resolve(std::string_view name, std::string_view where, Console& console) {
    const auto refuse = [&](Error error) {
        if (!where.empty())
            error.where = std::string(where) + (error.where.empty() ? "" : ": " + error.where);
        console.error(error);
        return std::nullopt;
    };
    const auto parsed = parseName(name);
    if (!parsed)
        return refuse(parsed.error());
    const auto canonical = canonicalise(*parsed);
    if (!canonical)
        return refuse(canonical.error());
    console.dropped(name, canonical->dropped);
    return canonical->permutation;
}

std::optional<Selected> select(const SelectionOptions& options, Console& console,
                               const std::function<void(const Permutation&)>& visit) {
    const auto space = spaceOf(options);
    if (!space) {
        console.error(space.error());
        return std::nullopt;
    }
    const bool wholeSpace = options.names.empty() && !options.covering && options.manifest.empty();
    Sieve sieve(options.limit.value_or(wholeSpace ? kDefaultLimit : 0), options.shard, visit);
    if (wholeSpace) {
        space->forEachCanonical(
            [&](const Permutation& permutation) { return sieve.offer(permutation); },
            [&](std::uint64_t tried) { console.progress("candidates tried:", tried, 0); });
        console.endProgress();
        return sieve.finish(space->product());
    }
    const auto permutations = listed(options, console);
    if (!permutations)
        return std::nullopt;
    std::set<Key> seen;
    for (const Permutation& permutation : *permutations)
        if (space->contains(permutation) && seen.insert(toKey(permutation)).second &&
            !sieve.offer(permutation))
            break;
    return sieve.finish(space->product());
}

std::optional<Permutations> select(const SelectionOptions& options, Console& console) {
    Permutations permutations;
    const auto selected = select(
        options, console, [&](const Permutation& permutation) { permutations.push_back(permutation); });
    if (!selected)
        return std::nullopt;
    if (!selected->complete)
        console.note("stopped at the limit of " + std::to_string(options.limit.value_or(kDefaultLimit)) +
                     "; see --limit");
    return permutations;
}

} // namespace franken::cli
