// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/permutation.h"

#include <map>
#include <string>

namespace price {

/// The lines of the price list (tests/qpu/prices.md) that a program is made of, and how often it has each.
std::map<std::string, int> featuresOf(const franken::Permutation& program);

} // namespace price
