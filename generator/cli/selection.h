// SPDX-License-Identifier: MIT
#pragma once

#include "console.h"
#include "franken/generator/budget.h"
#include "options.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace franken::cli {

/// How many permutations are listed where the whole space is asked for and no --limit is given.
inline constexpr std::size_t kDefaultLimit = 100;

/// Reads a name, or a key as toHex() writes it, and canonicalises it.
Result<Canonical> readName(std::string_view name);

/// The same; says on standard error what was wrong or what was dropped. An error
/// is told to be at `where`, if that is not empty.
std::optional<Permutation> resolve(std::string_view name, std::string_view where, Console& console);

/// The profiles of these names; "all" is all of them.
std::vector<Profile> profilesOf(const std::vector<std::string>& names);

/// How a selection ended.
struct Selected {
    std::size_t count = 0;     ///< Visited.
    std::size_t offered = 0;   ///< Before the shard was taken.
    bool complete = true;      ///< False where the limit left some out.
    std::uint64_t product = 0; ///< Of the choices that the filters leave.
};

/// Visits the permutations that the options ask for: canonical, each once. The order of work is: source,
/// filter, limit, shard; so shards 1/N to N/N together visit exactly what would be visited without. Names and
/// manifests are read to the end before the first visit. Nothing is returned where something was refused,
/// after it was reported.
std::optional<Selected> select(const SelectionOptions& options, Console& console,
                               const std::function<void(const Permutation&)>& visit);

/// The same, collected. A selection without a program is refused: what works through one would do nothing and
/// call it success.
std::optional<std::vector<Permutation>> select(const SelectionOptions& options, Console& console);

} // namespace franken::cli
