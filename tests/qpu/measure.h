// SPDX-License-Identifier: MIT
#pragma once

#include "priced.h"

#include <optional>
#include <string>

namespace franken::test {

/// The compilers, as toolchain.sh made them once for this run; or nothing, and why.
struct Compilers {
    std::optional<cli::QpuCompiler> compiler;
    std::string whyNot;
};

/// Looked for once a process. Throws std::runtime_error where toolchain.sh failed instead of saying why the
/// machine cannot have them.
const Compilers& compilers();

/// Measures on the GPU of that name. Throws std::runtime_error where the compilers cannot be run.
std::vector<cli::Priced> priceOn(std::string_view gpu, std::span<const Permutation> permutations);

/// Those of tests/golden/named.manifest, canonical.
std::vector<Permutation> namedPermutations();

} // namespace franken::test
