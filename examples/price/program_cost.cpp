// SPDX-License-Identifier: MIT
#include "program_cost.h"

#include "price_tables.h"
#include "qpu_compiler.h"

#include <utility>

using namespace franken;

namespace price {

struct ProgramCosts::Compiler {
    cli::QpuCompiler compiler;
};

std::string_view toString(Known known) {
    return known == Known::Compiled ? "compiled" : known == Known::Table ? "table" : "interpolated";
}

ProgramCosts ProgramCosts::open() {
    ProgramCosts costs;
    Result<cli::QpuCompiler> compiler = cli::QpuCompiler::open();
    if (compiler)
        costs.m_compiler = std::make_shared<const Compiler>(Compiler{*std::move(compiler)});
    else
        costs.m_whyNot = toString(compiler.error());
    return costs;
}

Result<std::vector<ProgramCost>> ProgramCosts::of(const cli::Gpu& gpu, std::span<const Permutation> programs,
                                                  const SnippetSet& snippets) const {
    std::vector<ProgramCost> costs;
    if (!m_compiler) {
        static const PriceTables kTables(kCostsTable, kPriceList);
        for (const Permutation& program : programs)
            costs.push_back(kTables.of(gpu.name, program));
        return costs;
    }
    std::vector<Permutation> forms;
    for (const Permutation& program : programs)
        forms.push_back(cli::forGpu(program, gpu));
    const Result<std::vector<cli::Cost>> compiled = m_compiler->compiler.measure(gpu, forms, snippets);
    if (!compiled)
        return compiled.error();
    for (const cli::Cost& cost : *compiled)
        costs.push_back({.fragment = cost.fragment.instructions,
                         .vertex = cost.vertex.instructions,
                         .coordinate = cost.coordinate.instructions,
                         .threads = cost.fragment.threads,
                         .known = Known::Compiled,
                         .error = cost.error});
    return costs;
}

} // namespace price
