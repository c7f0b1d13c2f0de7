// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/permutation.h"

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace FRANKEN_API franken {

/// A part of the space of permutations: which values each choice may have. At first, all of it.
class Space {
public:
    Space();

    /// Leaves only permutations that have the word, or that do not. Defaults are words like any other:
    /// require("opaque"). Fails as parseName does for what is no word, with "space.word" for more than one
    /// word, and with "space.empty" where a choice is left without a value.
    Result<void> require(std::string_view word);
    Result<void> forbid(std::string_view word);

    bool contains(const Permutation& permutation) const;

    /// The number of combinations of the values that are left, contradictions and no-ops included: about
    /// 6.8e12 for the whole space.
    std::uint64_t product() const;

    /// Visits the canonical permutations in it, each once and always in the same order: short names first.
    /// Nothing is stored, and `visit` may stop by returning false at any time, so that a space too large to
    /// write out can be listed from its simple end. `tried` hears every now and then how many combinations
    /// have been looked at; it may be empty.
    ///
    /// Words that change no text here (the lights, in a space of skies) are found by probing 256 random
    /// combinations, of a fixed seed, of each kind of program and view, and are left out. The rarest effect
    /// of a word shows in about one combination of ten, so that a word is missed with a probability of 1e-11;
    /// a test looks for missing ones among thousands of random ones.
    void forEachCanonical(const std::function<bool(const Permutation&)>& visit,
                          const std::function<void(std::uint64_t)>& tried = {}) const;

private:
    Result<void> narrow(std::string_view word, bool present);

    std::vector<unsigned> m_allowed; ///< By choice: a bit for each value.
};

} // namespace franken
