// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/permutation.h"
#include "franken/shader_program.h"

#include <memory>
#include <vector>

namespace franken {

/// What a cache has done since it was made.
struct ProgramCounters {
    unsigned compiles = 0; ///< Shaders that the driver was asked to compile.
    unsigned links = 0;    ///< Programs that it was asked to link.
    unsigned hits = 0;     ///< Calls of get() that asked for neither.
};

/// The programs of one context, by permutation. A permutation is composed, compiled and linked when it is
/// asked for first. Shaders are shared between programs by their stage keys, so that a choice of output
/// compiles no vertex shader.
///
/// Belongs to the thread of its context, which must be current in all calls and in the destructor.
class ProgramCache {
public:
    /// The table must outlive the cache.
    explicit ProgramCache(const Gl& gl) : m_gl(&gl) {}

    /// The program of a canonical permutation; good for as long as the cache lives. May change which program
    /// is in use. Fails with "program.compile" or "program.link"; `where` names the permutation and the
    /// stage, and each line of the driver's log is followed by the snippet's file and line. What failed once
    /// is not tried again.
    Result<ShaderProgram*> get(const Permutation& permutation);

    const ProgramCounters& counters() const { return m_counters; }

private:
    struct ProgramEntry {
        Key key;
        Result<std::unique_ptr<ShaderProgram>> program;
    };
    struct ShaderEntry {
        Stage stage;
        Key key; ///< The stage key.
        Result<GlShader> shader;
    };

    Result<std::unique_ptr<ShaderProgram>> make(const Permutation& permutation);
    Result<GLuint> shader(const Permutation& permutation, Stage stage, const ComposedStage& text);
    Result<GlShader> compile(const Permutation& permutation, Stage stage, const ComposedStage& text);
    Result<GlProgram> link(const Permutation& permutation, const Interface& interface, GLuint vertex,
                           GLuint fragment);

    const Gl* m_gl;
    std::vector<ProgramEntry> m_programs; ///< Sorted by key.
    std::vector<ShaderEntry> m_shaders;
    ProgramCounters m_counters;
};

} // namespace franken
