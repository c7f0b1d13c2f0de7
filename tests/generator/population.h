// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/permutation.h"

#include <string>
#include <vector>

namespace franken::test {

/// Any permutations that are not refused, no-ops and all; the same ones for the same seed.
std::vector<Permutation> randomPermutations(std::size_t count, unsigned seed);

/// All of {normal x ambient x suns x BRDF x output}.
std::vector<Permutation> litProduct();

/// Every choice of that permutation set to every other value, as far as the result is not refused.
std::vector<Permutation> singleFlips(const Permutation& permutation);

/// The canonical permutations that the large tests run over, each once: the covering set, litProduct(),
/// 2,000 random ones, and the single flips of the default and of a surface where most choices matter.
const std::vector<Permutation>& population();

/// A surface with textures, suns and punctual lights, sky, spots and masks.
Permutation richSurface();

/// Canonicalises; a refusal is a bug of the test.
Permutation canonical(const Permutation& permutation);

/// Reads a name and canonicalises it.
Permutation named(std::string_view name);

/// Without comments, without the spaces before them, and without lines that are empty then.
std::string withoutComments(const std::string& glsl);

} // namespace franken::test
