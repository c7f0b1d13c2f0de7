// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/permutation.h"

#include <span>

namespace FRANKEN_API franken {

/// One value that a choice can take.
struct Option {
    std::string_view word;    ///< As it stands in a name; unique over all choices.
    std::string_view meaning; ///< For --help and documentation.
};

/// One row of the table that names, packs, parses, lists and flips the choices of a permutation.
struct Choice {
    std::string_view name;           ///< As the member of Permutation is called.
    bool material;                   ///< Joined by '.' in a name; others by '+'.
    unsigned shift, bits;            ///< Its place in the key.
    std::span<const Option> options; ///< The first is the default.
    unsigned (*get)(const Permutation&);
    void (*set)(Permutation&, unsigned);
};

/// All choices, in the order of names and of the table in the README.
std::span<const Choice> choices();

/// A range of key bits that a later feature will use.
struct ReservedBits {
    std::string_view name;
    unsigned shift, bits;
};

/// What is put by, so that these features will change no key: skinning, morphs, shadows, more workarounds.
std::span<const ReservedBits> reservedBits();

} // namespace franken
