// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/permutation.h"

#include <functional>
#include <vector>

namespace FRANKEN_API franken {

/// A small set of canonical permutations in which every combination of three choices occurs: most faults
/// of a program show up where one, two or three choices meet (Kuhn, Wallace and Gallo, "Software Fault
/// Interactions and Implications for Software Testing", 2004), and the product of all choices is far too
/// large to be tested.
///
/// Exactly: every triple of values of three different choices that occurs in some canonical permutation
/// occurs in the set. Triples that can never occur together in a canonical permutation are excluded (the
/// skybox has no normal map). Choices that change no program of this version keep their default.
///
/// The triples are found by examining some ten thousand permutations, not by proof; a test examines tens of
/// thousands of others. Deterministic: the same set, in the same order, on every machine. Takes about a
/// second: call it once.
std::vector<Permutation> coveringSet();

/// The same for a part of the space: only permutations that `accept` takes are in the set, and only triples
/// that occur in one of them are covered. Calls `accept` some 40,000 times.
std::vector<Permutation> coveringSet(const std::function<bool(const Permutation&)>& accept);

} // namespace franken
