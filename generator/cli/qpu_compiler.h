// SPDX-License-Identifier: MIT
#pragma once

#include "franken/result.h"
#include "gpu.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace franken::cli {

/// What a driver's compiler made of one shader.
struct ShaderCost {
    int instructions = 0;
    int threads = 0; ///< That share a QPU and hide each other's waiting: at most 2 on vc4, 4 on v3d.
    int uniforms = 0;
    int temps = 0; ///< Registers.
    /// Registers written to memory and read back; vc4 cannot, and gives up instead.
    int spills = 0, fills = 0;

    friend bool operator==(const ShaderCost&, const ShaderCost&) = default;
};

/// What a driver made of a program, or why it made nothing.
struct Cost {
    ShaderCost fragment, vertex;
    ShaderCost coordinate; ///< The vertex shader as it runs for the first time, to sort triangles into tiles.
    /// Empty; "out of registers", and then such a program draws nothing on the GPU; or else.
    std::string error;

    bool measured() const { return error.empty(); }

    /// Of a vertex, which both shaders run over.
    int vertexInstructions() const { return vertex.instructions + coordinate.instructions; }
};

/// From how many pixels a vertex on the first program, which does more work per vertex and less per pixel, is
/// the cheaper one: a vertex instruction costs what a pixel's does. 0 where it is always the cheaper one, and
/// infinite where it never is. Vertices are counted once; the GPU may shade those of a triangle in several
/// tiles again.
double breakEvenPixels(const Cost& perVertex, const Cost& perPixel);

/// Mesa's compilers for the Raspberry Pi's GPUs, as tests/qpu/toolchain.sh installs them: a program beside
/// ours.
class QpuCompiler {
public:
    /// Looks in the folder that FRANKEN_QPU names, else in $XDG_CACHE_HOME/frankenshader/qpu, else in
    /// ~/.cache/frankenshader/qpu. Fails with "cost.toolchain" where nothing is there.
    static Result<QpuCompiler> open();

    /// One cost for each, in their order; programs are taken as they are. Takes 0.02 to 0.05 s each. Fails
    /// with "cost.run" where the compilers cannot be run at all; a program that they do not survive is an
    /// error of its own cost.
    Result<std::vector<Cost>> measure(const Gpu& gpu, std::span<const Permutation> canonical,
                                      const SnippetSet& snippets = SnippetSet::builtIn()) const;

private:
    explicit QpuCompiler(std::filesystem::path program) : m_program(std::move(program)) {}

    std::filesystem::path m_program;
};

} // namespace franken::cli
