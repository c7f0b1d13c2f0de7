// SPDX-License-Identifier: MIT
#include "qpu_compiler.h"

#include "child_process.h"
#include "franken/generator/compose.h"
#include "temporary_folder.h"

#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

namespace franken::cli {
namespace {

namespace fs = std::filesystem;

Error cannotRun(const std::string& where, const std::string& reason) {
    return {"cost.run", where, "cannot be run: " + reason,
            "see that TMPDIR can be written to, and run tests/qpu/toolchain.sh again"};
}

// A program's files and line in the list of pairs are called by its number, which needs no quoting.
bool writePairs(const fs::path& folder, std::span<const Permutation> permutations, std::size_t begin) {
    std::ofstream list(folder / "pairs");
    for (std::size_t i = begin; i < permutations.size(); ++i) {
        const std::string file = (folder / std::to_string(i)).string();
        const bool blend = permutations[i].alpha == Alpha::Blend;
        list << i << '\t' << file << ".vert\t" << file << ".frag\t" << (blend ? "blend" : "opaque") << '\n';
    }
    list.close();
    return static_cast<bool>(list);
}

bool writeTexts(const fs::path& folder, std::span<const Permutation> permutations,
                const SnippetSet& snippets) {
    bool written = true;
    for (std::size_t i = 0; i < permutations.size(); ++i) {
        const Composed program = compose(permutations[i], snippets);
        const std::string file = (folder / std::to_string(i)).string();
        std::ofstream vertex(file + ".vert", std::ios::binary), fragment(file + ".frag", std::ios::binary);
        vertex << program.vertex.text;
        fragment << program.fragment.text;
        vertex.close();
        fragment.close();
        written = written && vertex && fragment;
    }
    return written;
}

void readRow(const std::string& row, std::map<std::size_t, Cost>& costs) {
    std::istringstream columns(row);
    std::string gpu, stage;
    std::size_t number = 0;
    if (!(columns >> gpu >> number >> stage))
        return;
    Cost& cost = costs[number];
    if (stage == "error") {
        std::getline(columns >> std::ws, cost.error);
        return;
    }
    ShaderCost& shader = stage == "fragment" ? cost.fragment
                         : stage == "vertex" ? cost.vertex
                                             : cost.coordinate;
    columns >> shader.instructions >> shader.threads >> shader.uniforms >> shader.temps >> shader.spills >>
        shader.fills;
}

std::string firstLine(const fs::path& file) {
    std::string line;
    std::ifstream in(file);
    std::getline(in, line);
    return line;
}

// Measures from `begin` on and appends; what the compiler does not survive ends the run and is appended too.
Result<void> measureSome(const fs::path& program, const Gpu& gpu, const fs::path& folder,
                         std::span<const Permutation> permutations, std::vector<Cost>& costs) {
    const std::size_t begin = costs.size();
    if (!writePairs(folder, permutations, begin))
        return cannotRun(folder.string(), "the disk is full");
    const Outcome outcome =
        runProgram({program.string(), std::string(gpu.name)},
                   {.in = folder / "pairs", .out = folder / "rows", .err = folder / "errors"});
    if (outcome.spawnError != 0)
        return cannotRun(program.string(), std::strerror(outcome.spawnError));
    if (outcome.exitCode > 0 && outcome.exitCode < 128)
        return cannotRun(program.string(), firstLine(folder / "errors"));
    std::map<std::size_t, Cost> measured;
    std::ifstream rows(folder / "rows");
    for (std::string row; std::getline(rows, row);)
        readRow(row, measured);
    for (std::size_t i = begin; i < permutations.size() && measured.count(i) > 0; ++i)
        costs.push_back(measured[i]);
    if (costs.size() < permutations.size()) {
        costs.emplace_back();
        costs.back().error = "the compiler crashes";
    }
    return {};
}

} // namespace

double breakEvenPixels(const Cost& perVertex, const Cost& perPixel) {
    const int more = perVertex.vertexInstructions() - perPixel.vertexInstructions();
    const int saved = perPixel.fragment.instructions - perVertex.fragment.instructions;
    if (saved <= 0)
        return std::numeric_limits<double>::infinity();
    return more <= 0 ? 0 : static_cast<double>(more) / saved;
}

Result<QpuCompiler> QpuCompiler::open() {
    const auto variable = [](const char* name) -> fs::path {
        const char* value = std::getenv(name);
        return value ? value : "";
    };
    fs::path folder = variable("FRANKEN_QPU");
    if (folder.empty()) {
        const fs::path cache = variable("XDG_CACHE_HOME");
        folder = (cache.empty() ? variable("HOME") / ".cache" : cache) / "frankenshader/qpu";
    }
    const fs::path program = folder / "bin/qpu-stats";
    if (access(program.c_str(), X_OK) != 0)
        return Error{
            "cost.toolchain", program.string(), "the compilers of the Raspberry Pi's GPUs are not here",
            "run toolchain.sh, in tests/qpu of FrankenShader's sources or share/frankenshader/qpu of an "
            "installation, or name their folder in FRANKEN_QPU"};
    return QpuCompiler(program);
}

Result<std::vector<Cost>> QpuCompiler::measure(const Gpu& gpu, std::span<const Permutation> canonical,
                                               const SnippetSet& snippets) const {
    const Result<TemporaryFolder> folder = TemporaryFolder::make();
    if (!folder || !writeTexts(folder->path(), canonical, snippets))
        return cannotRun(folder ? folder->path().string() : "", "no temporary file can be written");
    std::vector<Cost> costs;
    while (costs.size() < canonical.size())
        if (auto done = measureSome(m_program, gpu, folder->path(), canonical, costs); !done)
            return done.error();
    return costs;
}

} // namespace franken::cli
