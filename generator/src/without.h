// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/choices.h"

namespace franken {

/// The permutation with one choice at its default; not canonical.
inline Permutation without(Permutation permutation, const Choice& choice) {
    choice.set(permutation, 0);
    return permutation;
}

inline Permutation withoutEffect(Permutation permutation) {
    permutation.effect = {};
    return permutation;
}

} // namespace franken
