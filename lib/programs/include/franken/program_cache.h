// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/permutation.h"
#include "franken/generator/snippet_set.h"
#include "franken/key_table.h"
#include "franken/log.h"
#include "franken/own_thread.h"
#include "franken/shader_program.h"

#include <memory>
#include <optional>
#include <vector>

namespace FRANKEN_API franken {

/// What a cache has done since it was made. A run that is warm adds to `hits` alone.
struct ProgramCounters {
    unsigned compiles = 0;   ///< Shaders that the driver was asked to compile.
    unsigned links = 0;      ///< Programs that it was asked to link.
    std::uint64_t hits = 0;  ///< Look-ups that found a program ready.
    unsigned failures = 0;   ///< Programs that did not compile, link or draw.
    unsigned evictions = 0;  ///< Programs that made room for others.
    double milliseconds = 0; ///< Spent in composing, compiling and linking, by the wall clock.
};

/// Holds a program. Whoever draws with it keeps one of these: while anyone but the cache does, the program is
/// in use and is not evicted. The last holder deletes it, in the thread of the context.
using ProgramHandle = std::shared_ptr<ShaderProgram>;

struct ProgramCacheOptions {
    /// How many programs are kept, 1 and up. Above it, those make room that nobody holds, the least recently
    /// looked up first. Where all are held, the cache grows, and says so once.
    std::size_t capacity = 256;
    bool parallelCompile = false; ///< As Capabilities has it.
    Log log = {};                 ///< Told of evictions that may hurt.
};

/// The programs of one context, by permutation. A permutation is composed, compiled and linked when it is
/// asked for first. Shaders are shared between programs by their stage keys, so that a choice of output
/// compiles no vertex shader; the last program of a shader takes it along.
///
/// Permutations are canonical throughout. What failed stays failed, and costs no second attempt.
///
/// Belongs to the thread that it was made in (asserted), with the context current in all calls and in the
/// destructor. GL state that it changes: the program in use.
class ProgramCache {
public:
    /// The table must outlive the cache and all handles.
    explicit ProgramCache(const Gl& gl, ProgramCacheOptions options = {});

    /// Hands a program to the driver without waiting for it, so that drivers which compile in threads have
    /// many at a time. Does nothing where it is known already.
    void begin(const Permutation& permutation);

    /// Whether the driver is still at it, and get() would wait. Always false where it cannot tell
    /// (GL_KHR_parallel_shader_compile).
    bool pending(const Permutation& permutation) const;

    /// The program. Fails with "program.compile" or "program.link"; `where` names the permutation and the
    /// stage, and each line of the driver's log is followed by the snippet's file and line. Fails with
    /// whatever reject() was given.
    Result<ProgramHandle> get(const Permutation& permutation);

    /// The program of a key that get() has returned and that is still here, else null: the look-up of a warm
    /// run, for those who keep keys.
    ProgramHandle find(Key key) {
        Entry* entry = entryOf(key);
        if (entry == nullptr || !entry->program)
            return nullptr;
        entry->lastUse = ++m_counters.hits;
        return entry->program;
    }

    /// Why a program failed, or null where it did not (or is not known).
    const Error* failure(const Permutation& permutation) const;

    /// Makes a program a failed one, because it links and does not draw. Whoever holds it still can.
    void reject(const Permutation& permutation, Error error);

    /// Composes from other snippets from now on (those that the library was built with at first): for people
    /// who write them. The cache is empty afterwards, failures forgotten; who holds a program keeps it.
    void setSnippets(const SnippetSet& snippets);

    /// To be called in place of everything else when the context is lost: all GL names are gone, those of the
    /// programs that others hold included. The cache is empty afterwards, failures forgotten.
    void abandon();

    /// See ProgramCacheOptions; for the next context, where another one comes after abandon().
    void setParallelCompile(bool on) { m_options.parallelCompile = on; }

    std::size_t size() const { return m_live; } ///< Programs that work or are being compiled.
    const ProgramCounters& counters() const { return m_counters; }

private:
    struct Shader {
        Stage stage;
        Key key; ///< The stage key.
        GlShader name;
        std::optional<std::string> log; ///< Once it is known not to compile.
    };
    /// One of three: pending (a linked name), ready (a program) or failed (an error).
    struct Entry {
        ProgramHandle program;     // With lastUse, all that a look-up touches: one cache line.
        std::uint64_t lastUse = 0; ///< ProgramCounters::hits then; of equals, the first is the oldest.
        Permutation permutation;
        Key key;
        std::shared_ptr<Shader> vertex, fragment;
        GlProgram linked;
        Interface interface;
        std::optional<Error> error;
    };

    Entry* entryOf(Key key) {
        m_thread.check();
        const std::uint32_t place = m_table.find(key);
        return place == KeyTable::kAbsent ? nullptr : &m_entries[place];
    }
    const Entry* entryOf(Key key) const { return const_cast<ProgramCache*>(this)->entryOf(key); }
    Entry& add(const Permutation& permutation);
    std::shared_ptr<Shader> shader(const Permutation& permutation, Stage stage, const ComposedStage& text);
    GlProgram link(const Entry& entry) const;
    void finish(Entry& entry);
    void fail(Entry& entry, Error error);
    Error reasonOf(const Entry& entry) const;
    void clear();
    void makeRoom();
    void evict(std::size_t place);
    void dropUnusedShaders();

    const Gl* m_gl;
    ProgramCacheOptions m_options;
    SnippetSet m_snippets = SnippetSet::builtIn();
    OwnThread m_thread;
    KeyTable m_table; ///< Into m_entries.
    std::vector<Entry> m_entries;
    std::vector<std::shared_ptr<Shader>> m_shaders;
    std::size_t m_live = 0;
    bool m_warnedOfGrowth = false;
    ProgramCounters m_counters;
};

} // namespace franken
