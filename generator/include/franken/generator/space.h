// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/permutation.h"

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace FRANKEN_API franken {

/// A part of the space of permutations: the values that each choice may have. At first, the whole space.
class Space {
public:
    Space();

    /// Leaves only permutations that have the word, or that lack it. Defaults are words like any other:
    /// require("opaque"). Fails as parseName() does for an unknown word, with "space.word" for more than one
    /// word, and with "space.empty" where a choice would have no value left.
    Result<void> require(std::string_view word);
    Result<void> forbid(std::string_view word);

    /// Whether all that was required holds for the permutation, which is canonical.
    bool contains(const Permutation& permutation) const;

    /// The number of combinations of the remaining values, contradictions and no-ops included: about 6.8e12
    /// for the whole space.
    std::uint64_t product() const;

    /// Visits the canonical permutations of the space, each once and always in the same order: short names
    /// first. Nothing is stored, and `visit` may stop by returning false at any time, so that the beginning
    /// of a huge space can be listed. `tried` is called every now and then with the number of combinations
    /// tried; it may be empty.
    ///
    /// Words that change no text here (the lights, in a space of skies) are found by probing 256 random
    /// combinations, of a fixed seed, of each kind of program and view, and are left out. The rarest effect
    /// of a word shows in about one combination of ten, so that a word is missed with a probability of 1e-11;
    /// a test searches thousands of random combinations for missed words.
    void forEachCanonical(const std::function<bool(const Permutation&)>& visit,
                          const std::function<void(std::uint64_t)>& tried = {}) const;

private:
    Result<void> narrow(std::string_view word, bool present);

    std::vector<unsigned> m_allowed; ///< By choice: a bit for each value.
};

} // namespace franken
