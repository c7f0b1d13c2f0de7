// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/permutation.h"

namespace franken {

/// The permutation with every choice reset that leaves the plan of that stage as it is.
Permutation withoutNoOps(const Permutation& permutation, Stage stage);

} // namespace franken
