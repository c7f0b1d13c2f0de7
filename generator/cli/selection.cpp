// SPDX-License-Identifier: MIT
#include "selection.h"

#include "effects.h"
#include "franken/generator/compose.h"
#include "franken/generator/covering.h"
#include "franken/generator/space.h"
#include "franken/printable.h"
#include "manifest.h"

#include <algorithm>
#include <memory>
#include <set>

namespace franken::cli {
namespace {

constexpr std::size_t kMostMisfits = 100'000; // About a second.

Result<Permutation> permutationOfKey(std::string_view hex) {
    return parseHex(hex).and_then([](const Key& key) { return fromKey(key, snippets()); });
}

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
        if (auto narrowed = space.require(printable(word)); !narrowed)
            return narrowed.error();
    for (const std::string& word : options.without)
        if (auto narrowed = space.forbid(printable(word)); !narrowed)
            return narrowed.error();
    for (const std::string& text : options.where)
        if (auto narrowed = applyWhere(space, printable(text)); !narrowed)
            return narrowed.error();
    return space;
}

class Fits {
public:
    explicit Fits(const SelectionOptions& options) {
        if (options.fits)
            m_profiles = profilesOf(options.profiles);
    }

    bool operator()(const Permutation& permutation) const {
        if (m_profiles.empty())
            return true;
        const Composed program = compose(permutation, snippets());
        return std::all_of(m_profiles.begin(), m_profiles.end(),
                           [&](const Profile& profile) { return budget(program.interface, profile).fits(); });
    }

private:
    std::vector<Profile> m_profiles;
};

std::optional<Permutations> readNames(const std::string& file, Console& console) {
    const auto manifest = readManifest(file);
    if (!manifest)
        return console.error(manifest.error()), std::nullopt;
    Permutations permutations;
    std::set<Key> seen;
    bool refused = false;
    for (const ManifestLine& line : (*manifest)->lines) {
        const auto permutation =
            resolve(line.name, (*manifest)->file + ":" + std::to_string(line.number), console);
        if (!permutation)
            refused = true;
        else if (seen.insert(toKey(*permutation)).second)
            permutations.push_back(*permutation);
    }
    if (refused)
        return std::nullopt;
    return permutations;
}

// What names, manifest or covering set list; nothing where one of them was refused.
std::optional<Permutations> listed(const SelectionOptions& options, const Fits& fits, Console& console) {
    if (options.covering)
        return options.fits ? coveringSet(fits) : coveringSet();
    if (!options.manifest.empty())
        return readNames(options.manifest, console);
    Permutations permutations;
    for (const std::string& name : options.names)
        if (const auto permutation = resolve(name, "", console))
            permutations.push_back(*permutation);
    if (permutations.size() < options.names.size())
        return std::nullopt;
    return permutations;
}

class Sieve {
public:
    Sieve(std::size_t limit, Shard shard, const std::function<void(const Permutation&)>& visit)
        : m_limit(limit), m_shard(shard), m_visit(visit) {}

    // There may be more. False, as for what ends a search.
    bool stop() { return m_selected.complete = false; }

    // False once the limit is reached and one more has come.
    bool offer(const Permutation& permutation) {
        if (m_limit > 0 && m_offered == m_limit)
            return stop();
        if (m_offered++ % m_shard.count == m_shard.index - 1) {
            m_visit(permutation);
            ++m_selected.count;
        }
        return true;
    }

    Selected finish(std::uint64_t product) {
        m_selected.product = product;
        m_selected.offered = m_offered;
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

Result<Canonical> readName(std::string_view name) {
    // Escaped first: the error quotes it above a row of carets.
    const Result<Permutation> named =
        name.starts_with("0x") ? permutationOfKey(name) : parseName(printable(name), snippets());
    return named ? canonicalise(*named) : Result<Canonical>(named.error());
}

std::optional<Permutation> resolve(std::string_view name, std::string_view where, Console& console) {
    const Result<Canonical> canonical = readName(name);
    if (!canonical) {
        Error error = canonical.error();
        if (!where.empty())
            error.where = std::string(where) + (error.where.empty() ? "" : ": " + error.where);
        console.error(error);
        return std::nullopt;
    }
    console.dropped(name, canonical->dropped);
    return canonical->permutation;
}

std::vector<Profile> profilesOf(const std::vector<std::string>& names) {
    std::vector<Profile> wanted;
    for (const Profile& profile : profiles())
        if (std::any_of(names.begin(), names.end(),
                        [&](const std::string& name) { return name == profile.name || name == "all"; }))
            wanted.push_back(profile);
    return wanted;
}

std::optional<Selected> select(const SelectionOptions& options, Console& console,
                               const std::function<void(const Permutation&)>& visit) {
    const auto space = spaceOf(options);
    if (!space) {
        console.error(space.error());
        return std::nullopt;
    }
    const bool wholeSpace = options.names.empty() && !options.covering && options.manifest.empty();
    const Fits fits(options);
    Sieve sieve(options.limit.value_or(wholeSpace ? kDefaultLimit : 0), options.shard, visit);
    if (wholeSpace) {
        std::size_t misfits = 0; // In a row: the space has more permutations than anyone can wait for.
        space->forEachCanonical(
            [&](const Permutation& permutation) {
                if (fits(permutation))
                    return misfits = 0, sieve.offer(permutation);
                return ++misfits < kMostMisfits || sieve.stop();
            },
            [&](std::uint64_t tried) { console.progress("candidates tried:", tried, 0); });
        console.endProgress();
        if (misfits == kMostMisfits)
            console.note("stopped after " + std::to_string(kMostMisfits) +
                         " permutations in a row that do not fit; narrow the selection with --where");
        return sieve.finish(space->product());
    }
    const auto permutations = listed(options, fits, console);
    if (!permutations)
        return std::nullopt;
    std::set<Key> seen;
    for (const Permutation& permutation : *permutations)
        if (space->contains(permutation) && seen.insert(toKey(permutation)).second && fits(permutation) &&
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
    if (selected->offered == 0) {
        console.error({"selection.empty", "", "no permutation is selected", "loosen the filters"});
        return std::nullopt;
    }
    if (!selected->complete)
        console.note("stopped at the limit of " + std::to_string(options.limit.value_or(kDefaultLimit)) +
                     "; see --limit");
    return permutations;
}

} // namespace franken::cli
