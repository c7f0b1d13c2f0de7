// SPDX-License-Identifier: MIT
#pragma once

#include "gpu.h"

#include "franken/generator/permutation.h"
#include "franken/generator/snippet_set.h"
#include "franken/result.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace price {

/// How the instructions of a program are known.
enum class Known {
    Compiled,     ///< Counted by the GPU's own compiler, here.
    Table,        ///< Counted by it for the table of tests/qpu (costs.tsv).
    Interpolated, ///< A program of that table, and what the features between the two cost (prices.md).
};

/// "compiled", "table", "interpolated".
std::string_view toString(Known known);

/// Instructions of a program, each of them for 16 pixels or vertices.
struct ProgramCost {
    int fragment = 0, vertex = 0, coordinate = 0;
    int threads = 0; ///< Of the fragment shader; 0 where it is not known.
    Known known = Known::Interpolated;
    std::string error = {}; ///< Why the GPU cannot run it; empty where it can.
};

/// Where the compilers are installed, they count; otherwise the table and the price list tell.
class ProgramCosts {
public:
    /// Looks for the compilers (cli::QpuCompiler::open).
    static ProgramCosts open();

    /// Why the compilers are not used; empty where they are.
    const std::string& whyNotCompiled() const { return m_whyNot; }

    /// One cost for each of these canonical permutations, in their order, for the forms that the GPU takes.
    /// Fails with "cost.run" where the compilers cannot be run.
    franken::Result<std::vector<ProgramCost>> of(const franken::cli::Gpu& gpu,
                                                 std::span<const franken::Permutation> programs,
                                                 const franken::SnippetSet& snippets) const;

private:
    struct Compiler;
    std::shared_ptr<const Compiler> m_compiler; ///< Null where there is none.
    std::string m_whyNot;
};

} // namespace price
