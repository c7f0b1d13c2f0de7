// SPDX-License-Identifier: MIT
#pragma once

#include "qpu_compiler.h"

#include <optional>

namespace franken::cli {

/// A program and what it costs on a GPU.
struct Priced {
    Permutation asked;
    Permutation measured; ///< forGpu(asked).
    Cost cost;
    /// Pixels a vertex from which on light vectors per vertex pay; see breakEvenPixels. Nothing where the
    /// program has only one way to get its light vectors, or where either way does not compile.
    std::optional<double> breakEven;
};

/// What canonical permutations cost on that GPU, in their order. Fails as QpuCompiler::measure does.
Result<std::vector<Priced>> price(const QpuCompiler& compiler, const Gpu& gpu,
                                  std::span<const Permutation> asked,
                                  const SnippetSet& snippets = SnippetSet::builtIn());

} // namespace franken::cli
