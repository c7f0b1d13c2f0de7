// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/permutation.h"
#include "franken/generator/snippet_set.h"
#include "franken/log.h"
#include "franken/shader_program.h"

#include <cstdint>
#include <memory>

namespace FRANKEN_API franken {

/// Counts of a cache since it was made. A warm run adds to `hits` alone.
struct ProgramCounters {
    unsigned compiles = 0;   ///< Shaders that were given to the driver.
    unsigned links = 0;      ///< Programs that were given to the driver.
    std::uint64_t hits = 0;  ///< Look-ups that found a program ready.
    unsigned failures = 0;   ///< Programs that did not compile, link or draw.
    unsigned evictions = 0;  ///< Programs that made room for others.
    double milliseconds = 0; ///< Spent in composing, compiling and linking, by the wall clock.
};

/// Holds a program. Keep one for as long as you draw with the program: while anyone but the cache holds it,
/// it is in use and is not evicted. The last holder deletes it, in the thread of the context.
using ProgramHandle = std::shared_ptr<ShaderProgram>;

/// How a ProgramCache is made.
struct ProgramCacheOptions {
    /// How many programs are kept, 1 and up. Above it, programs that nobody holds are evicted, the least
    /// recently looked up first. Where all are held, the cache grows and logs it once.
    std::size_t capacity = 256;
    bool parallelCompile = false; ///< Capabilities::parallelCompile.
    Log log = {};                 ///< Told when the cache grows.
};

/// The programs of one context, by permutation. A permutation is composed, compiled and linked at its first
/// get(). Shaders are shared between programs by their stage keys, so that another output compiles no vertex
/// shader; the last program of a shader deletes it.
///
/// Permutations are canonical throughout. A program that failed stays failed, and costs no second attempt.
///
/// Use it on the thread that made it (asserted), with the context current, the destructor included. GL state
/// that it changes: the program in use.
class ProgramCache {
public:
    /// The table must outlive the cache and all handles.
    explicit ProgramCache(const Gl& gl, ProgramCacheOptions options = {});
    ProgramCache(ProgramCache&&) noexcept;
    ProgramCache& operator=(ProgramCache&&) noexcept;
    ~ProgramCache();

    /// Starts compiling a program without waiting for it, so that drivers with compiler threads get many at a
    /// time. Does nothing where the program is known already.
    void compileInBackground(const Permutation& permutation);

    /// Whether the driver is still compiling, so that get() would wait. Always false where the driver cannot
    /// tell (GL_KHR_parallel_shader_compile).
    bool pending(const Permutation& permutation) const;

    /// The program. Fails with "program.compile" or "program.link"; `where` names the permutation and the
    /// stage, and each line of the driver's log is followed by the snippet's (or effect's) file and line.
    /// Fails with "effect.missing" where the snippets have not got the permutation's effect, with whatever
    /// reject() was given, and with "renderer.context-lost" where the context no longer answers; that failure
    /// is not remembered.
    Result<ProgramHandle> get(const Permutation& permutation);

    /// The program of a key if get() has returned it before and it was not evicted, else null: the fast
    /// look-up for applications that keep keys.
    ProgramHandle find(const Key& key);

    /// Why a program failed, or null where it did not (or is not known).
    const Error* failure(const Permutation& permutation) const;

    /// Marks a program as failed, because it links but does not draw. Its holders can still use it.
    void reject(const Permutation& permutation, Error error);

    /// Composes from other snippets from now on (at first: those that the library was built with), for
    /// snippet authors. The cache is empty afterwards, failures forgotten; programs that others hold stay.
    void setSnippets(const SnippetSet& snippets);
    const SnippetSet& snippets() const; ///< What programs are composed from now.

    /// Call this, and nothing else, when the context is lost: all GL names are gone, those of the programs
    /// that others hold included. Makes no GL call. The cache is empty afterwards, failures forgotten.
    void lost();

    /// See ProgramCacheOptions; for the next context, after lost().
    void setParallelCompile(bool on);

    std::size_t size() const;                ///< Programs that work or are being compiled.
    const ProgramCounters& counters() const; ///< Since it was made.

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace franken
