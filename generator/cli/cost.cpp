// SPDX-License-Identifier: MIT
#include "columns.h"
#include "commands.h"
#include "cost_gate.h"
#include "effects.h"
#include "json.h"
#include "selection.h"

#include <cmath>
#include <cstdio>

namespace franken::cli {
namespace {

constexpr double kFullHd = 1920 * 1080 * 60 / 1e6;

std::string decimals(double value, int count) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", count, value);
    return text;
}

void writeShader(Console& console, const char* stage, const ShaderCost& shader) {
    const std::string spills = std::to_string(shader.spills) + "/" + std::to_string(shader.fills);
    console.write("  " + left(stage, 12) + right(std::to_string(shader.instructions), 14) +
                  right(std::to_string(shader.threads), 9) + right(std::to_string(shader.uniforms), 10) +
                  right(std::to_string(shader.temps), 7) + right(spills, 14) + "\n");
}

void writeModels(Console& console, const Gpu& gpu, int instructions) {
    for (const PiModel& model : gpu.models) {
        const double rate = megapixelsPerSecond(gpu, model, instructions);
        console.write("  " + left(std::string(model.name), 15) + " at " + std::to_string(model.megahertz) +
                      " MHz: at most " + right(decimals(rate, 0), 4) + " megapixels a second, " +
                      decimals(rate / kFullHd, 2) + " times 1920x1080 at 60 Hz\n");
    }
}

std::string breakEvenText(double pixels) {
    if (std::isinf(pixels))
        return "never pay: they save nothing";
    return pixels == 0 ? "always pay" : "pay from " + decimals(pixels, 1) + " pixels a vertex on";
}

void writePriced(Console& console, const Gpu& gpu, const Priced& priced) {
    console.write(console.paint(Style::Bold, std::string(gpu.name)) + " (" + std::string(gpu.meaning) + ")" +
                  ", measured as " + toName(priced.measured, snippets()) + "\n");
    if (!priced.cost.measured()) {
        console.write("  " + console.paint(Style::Red, priced.cost.error) + "\n");
        return;
    }
    console.write(
        console.paint(Style::Dim, "  shader        instructions  threads  uniforms  temps  spills/fills") +
        "\n");
    writeShader(console, "fragment", priced.cost.fragment);
    writeShader(console, "vertex", priced.cost.vertex);
    writeShader(console, "coordinate", priced.cost.coordinate);
    writeModels(console, gpu, priced.cost.fragment.instructions);
    if (priced.breakEven)
        console.write("  light vectors per vertex " + breakEvenText(*priced.breakEven) + "\n");
}

Result<std::vector<Gpu>> gpusFor(const std::vector<std::string>& names) {
    std::vector<Gpu> wanted;
    if (names.empty())
        wanted.assign(gpus().begin(), gpus().end());
    for (const std::string& name : names) {
        const auto gpu = findGpu(name);
        if (!gpu)
            return gpu.error();
        wanted.push_back(*gpu);
    }
    return wanted;
}

Result<std::vector<Bill>> billsFor(const CostOptions& options, const std::vector<Permutation>& permutations) {
    const auto wanted = gpusFor(options.gpus);
    if (!wanted)
        return wanted.error();
    const auto compiler = QpuCompiler::open();
    if (!compiler)
        return compiler.error();
    std::vector<Bill> bills;
    for (const Gpu& gpu : *wanted) {
        auto priced = price(*compiler, gpu, permutations, snippets());
        if (!priced)
            return priced.error();
        bills.push_back({gpu, *std::move(priced)});
    }
    return bills;
}

Result<CostBaseline> baselineFor(const CostOptions& options) {
    return options.baseline.empty() ? CostBaseline{} : readCostBaseline(options.baseline);
}

// A gate that compares nothing would pass for ever.
Error nothingToCompare(const std::string& file) {
    return {"cost.baseline", file, "it has none of these programs on these GPUs",
            "write it anew with 'frankenshader cost --json'"};
}

void tellFindings(const GateFindings& gate, const CostOptions& options, Console& console) {
    if (!options.json && !gate.findings.empty())
        console.write("\n");
    for (const Finding& finding : gate.findings)
        if (!options.json)
            console.write(toLine(finding));
    if (!options.baseline.empty() && gate.compared < gate.asked)
        console.note(std::to_string(gate.asked - gate.compared) + " of " + std::to_string(gate.asked) +
                     " costs are not in " + options.baseline + ", and so not compared");
    console.note(std::to_string(gate.asked) + " costs held, " + std::to_string(gate.findings.size()) +
                 " findings");
}

} // namespace

ExitCode run(const CostOptions& options, Console& console) {
    const auto permutations = select(options.selection, console);
    if (!permutations)
        return ExitCode::Refused;
    const auto baseline = baselineFor(options);
    if (!baseline)
        return console.error(baseline.error()), ExitCode::Refused;
    const auto bills = billsFor(options, *permutations);
    if (!bills)
        return console.error(bills.error()), ExitCode::Device;
    std::optional<GateFindings> gate;
    if (options.isGate())
        gate = findExcess(*bills, options.limits, *baseline);
    if (!options.baseline.empty() && gate->compared == 0)
        return console.error(nothingToCompare(options.baseline)), ExitCode::Refused;
    bool failed = gate && !gate->findings.empty();
    for (std::size_t i = 0; i < permutations->size(); ++i) {
        if (!options.json)
            console.write((i > 0 ? "\n" : "") +
                          console.paint(Style::Bold, toName((*permutations)[i], snippets())) + "\n");
        for (const Bill& bill : *bills) {
            failed = failed || !bill.priced[i].cost.measured();
            if (!options.json)
                writePriced(console, bill.gpu, bill.priced[i]);
        }
    }
    if (options.json)
        console.write(costJson(*bills, gate));
    if (gate)
        tellFindings(*gate, options, console);
    return failed ? ExitCode::Failed : ExitCode::Ok;
}

} // namespace franken::cli
