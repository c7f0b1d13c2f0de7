// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/permutation.h"

#include <span>

namespace FRANKEN_API franken {

/// One value that a choice can take.
struct Option {
    std::string_view word;    ///< Its word in a name; unique over all choices.
    std::string_view meaning; ///< For --help and documentation.
};

/// One row of the table that names, packs, parses, lists and flips the choices of a permutation.
struct Choice {
    std::string_view name;               ///< That of the member of Permutation.
    bool material;                       ///< Joined by '.' in a name; others by '+'.
    unsigned shift, bits;                ///< Its place in the key, from 0 to 127; never over both words.
    std::span<const Option> options;     ///< The first is the default.
    unsigned (*get)(const Permutation&); ///< Its option in a permutation: an index into `options`.
    void (*set)(Permutation&, unsigned); ///< Sets that option, which must be in range.
};

/// A range of key bits that a later feature will use.
struct ReservedBits {
    std::string_view name; ///< The feature that it waits for.
    unsigned shift, bits;  ///< Its place in the key, as a Choice's.
};

/// The bits that say which schema a key is of.
inline constexpr ReservedBits kSchemaBits{"the schema version", 120, 8};

/// The bits that hold the slot of an effect.
inline constexpr ReservedBits kEffectBits{"the effect", 50, 6};

/// A value at its place in a key.
constexpr Key keyBits(std::uint64_t value, unsigned shift) {
    Key key;
    key.words[shift / 64] = value << shift % 64;
    return key;
}

/// The value of `bits` bits of a key.
constexpr std::uint64_t valueOf(const Key& key, unsigned shift, unsigned bits) {
    return key.words[shift / 64] >> shift % 64 & ((std::uint64_t{1} << bits) - 1);
}

/// All choices but the effect, whose values are the application's, in the order of names and of the table in
/// the README.
std::span<const Choice> choices();

/// Bits that are reserved, so that these features will change no existing key. New values of an existing
/// choice need no bits of their own: its field has room for them.
std::span<const ReservedBits> reservedBits();

} // namespace franken
