// SPDX-License-Identifier: MIT
#pragma once

#include "snippet.h"

namespace franken {

/// The parsed snippet of a row of the recipe.
const Snippet& snippetOf(std::size_t row);

} // namespace franken
