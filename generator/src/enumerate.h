// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/permutation.h"

#include <functional>
#include <vector>

namespace franken {

/// Space::forEachCanonical, given a bit for each value that a choice may have.
void enumerateCanonical(const std::vector<unsigned>& allowed,
                        const std::function<bool(const Permutation&)>& visit,
                        const std::function<void(std::uint64_t)>& tried);

} // namespace franken
