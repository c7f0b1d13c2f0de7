// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/capabilities.h"
#include "franken/draw_state.h"
#include "franken/draw_target.h"
#include "franken/program_cache.h"

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace FRANKEN_API franken {

class GlState;

/// A program that failed, and the one that is drawn in its place. The same happens wherever the driver is the
/// same: `frankenshader dump` writes both programs from their names.
struct Fallback {
    Permutation failed;
    std::optional<Permutation> next; ///< Nothing after the end of the chain.
    Error error;                     ///< "program.compile", "program.link" or "program.draw".
};

/// Called with the number of steps that are done; in the thread of the caller. Exceptions that it throws are
/// dropped.
using WarmUpProgress = std::function<void(std::size_t done, std::size_t total)>;

struct WarmUpReport {
    std::size_t programs = 0; ///< Programs that are resident now, the ends of fallback chains included.
    std::size_t draws = 0;    ///< Combinations of program and state that were drawn.
    std::size_t failed = 0;   ///< Programs that were replaced by simpler ones.
    double milliseconds = 0;
};

/// Programs that are known to draw; stands between a renderer and ProgramCache.
///
/// **Fallback chain** (a ladder of simpler programs, see simpler()). A program that fails to compile, to link
/// or to draw is replaced by the next simpler one. vc4's worst failure is silent: the link succeeds, the
/// registers do not suffice at the draw, and nothing is drawn. Each program therefore draws one cleared
/// pixel, which is read back; if it is unchanged over two different clear colours, the program failed. Where
/// the target cannot be read back (two clears look the same), programs are trusted to draw, which is logged
/// once.
///
/// **Warm-up.** warmUp() hands all programs to the driver, asks for their status afterwards, and draws with
/// each in each state in which it will be used. A program that get() still has to compile afterwards is a
/// miss.
///
/// **Budget.** When get() may compile no more programs in this frame, the first resident program of the chain
/// is returned in place of the one that was asked for.
///
/// Use it on the thread of its context, as ProgramCache. Compiling a program leaves GL's state undefined (see
/// GlState for the list), framebuffer and viewport included.
class ProgramManager {
public:
    static constexpr unsigned kUnlimited = std::numeric_limits<unsigned>::max();

    /// The table must outlive the object. Each fallback is logged once.
    ProgramManager(const Gl& gl, const Capabilities& capabilities, Log log,
                   std::size_t capacity = ProgramCacheOptions{}.capacity);
    ~ProgramManager();

    /// How many programs get() may compile from one resetBudget() to the next.
    void setBudget(unsigned programsPerFrame);
    void resetBudget();

    struct Supplied {
        ProgramHandle program;
        bool standIn = false; ///< Ask again in the next frame.
    };

    /// The program to draw with now. Programs that have to be validated draw into the target (its contents
    /// are undefined afterwards), or into a target of the manager's own where it is null. Fails where even
    /// the end of the fallback chain does, with its error, and with "renderer.context-lost" where the context
    /// no longer answers.
    Result<Supplied> get(const ProgramUse& use, const DrawTarget* target);

    /// Compiles all programs that these uses need, and the ends of their fallback chains. The target is one
    /// of those that will be drawn to, or like them; its contents are undefined afterwards. Fails with
    /// "renderer.context-lost", and with "permutation.range" as canonicalise() does.
    Result<WarmUpReport> warmUp(std::span<const ProgramUse> uses, const DrawTarget& target,
                                const WarmUpProgress& progress = {});

    /// Call it before each draw of a program that get() returned, with blending and depth state set: some
    /// drivers need textures reset (Capabilities::compilesForStaleTextures). May change program, arrays and
    /// unit 0.
    void prepareDraw(GlState& state, const ShaderProgram& next);

    /// GL's state was changed by others.
    void invalidateState();

    std::vector<ProgramUse> takeMisses();
    const std::vector<Fallback>& fallbacks() const;
    const ProgramCounters& counters() const;

    /// See ProgramCache. Forgets the fallbacks, too.
    void setSnippets(const SnippetSet& snippets);

    /// The context is gone: forgets all that was in it, failures included, and keeps counters, misses and
    /// fallbacks. The table must be replaced by one whose functions delete nothing.
    void lost();
    /// A new context is current; the table is its own.
    void restore(const Capabilities& capabilities);

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace franken
