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

/// A program that failed, and the program that replaces it. The same driver fails in the same way elsewhere;
/// `frankenshader dump` writes both programs from their names.
struct Fallback {
    Permutation failed;              ///< What was asked for.
    std::optional<Permutation> next; ///< Nothing after the end of the chain.
    Error error; ///< "program.compile", "program.link", "program.draw" or "effect.missing".
};

/// Called with the number of steps that are done; in the thread of the caller. Exceptions that it throws are
/// dropped.
using WarmUpProgress = std::function<void(std::size_t done, std::size_t total)>;

/// What warmUp() did.
struct WarmUpReport {
    std::size_t programs = 0; ///< Programs that are resident now, the ends of fallback chains included.
    std::size_t draws = 0;    ///< Combinations of program and state that were drawn.
    std::size_t failed = 0;   ///< Programs that were replaced by simpler ones.
    double milliseconds = 0;  ///< By the wall clock.
};

/// Provides programs that are known to draw; stands between a renderer and ProgramCache.
///
/// **Fallback chain** (a ladder of simpler programs, see simpler()). A program that fails to compile, to link
/// or to draw is replaced by the next simpler one. vc4's worst failure is silent: the link succeeds, the
/// registers do not suffice at the draw, and nothing is drawn. Each program therefore draws one cleared
/// pixel, which is read back; if it is unchanged over two different clear colours, the program failed. Where
/// the target cannot be read back (two clears look the same, as with several samples a pixel that are not
/// resolved), they draw a second time, to a small target of their own, which is read. Only where that cannot
/// be read either, programs are trusted to draw, which is logged once. A program with an effect of the
/// application's may draw any colour: it only has to change the pixel, with all values of the effect 1, or
/// else 0.
///
/// **Warm-up.** warmUp() hands all programs to the driver, asks for their status afterwards, and draws with
/// each in each state in which it will be used. A program that get() still has to compile afterwards is a
/// miss.
///
/// **Budget.** When get() may compile no more programs in this frame, it returns the first resident program
/// of the fallback chain instead.
///
/// Use it on the thread of its context, as ProgramCache. Compiling a program leaves GL's state undefined (see
/// GlState for the list), framebuffer and viewport included.
class ProgramManager {
public:
    /// For setBudget(): as many as are asked for.
    static constexpr unsigned kUnlimited = std::numeric_limits<unsigned>::max();

    /// The table must outlive the object. Each fallback is logged once.
    ProgramManager(const Gl& gl, const Capabilities& capabilities, Log log,
                   std::size_t capacity = ProgramCacheOptions{}.capacity);
    ~ProgramManager();

    /// How many programs get() may compile from one resetBudget() to the next.
    void setBudget(unsigned programsPerFrame);
    void resetBudget(); ///< To be called at the beginning of each frame.

    /// What get() returns.
    struct Supplied {
        ProgramHandle program; ///< Never null.
        bool standIn = false;  ///< Ask again in the next frame.
    };

    /// The program with which to draw now. Programs that have to be validated draw into the target (its
    /// contents are undefined afterwards), or into a target of the manager's own if it is null. Fails with
    /// the last error of the fallback chain if even its end fails, and with "renderer.context-lost" if the
    /// context no longer answers.
    Result<Supplied> get(const ProgramUse& use, const DrawTarget* target);

    /// Compiles all programs that these uses need, and the ends of their fallback chains. The target has the
    /// format and samples of later targets; its contents are undefined afterwards. Fails with
    /// "renderer.context-lost", and with "permutation.range" as canonicalise() does.
    Result<WarmUpReport> warmUp(std::span<const ProgramUse> uses, const DrawTarget& target,
                                const WarmUpProgress& progress = {});

    /// Call it before each draw of a program that get() returned, with blending and depth state set: some
    /// drivers need textures reset (Capabilities::compilesForStaleTextures). May change program, arrays and
    /// unit 0.
    void prepareDraw(GlState& state, const ShaderProgram& next);

    /// For when others changed GL's state.
    void invalidateState();

    /// Programs that get() had to compile since the last call, for a manifest.
    std::vector<ProgramUse> takeMisses();
    /// All since the manager was made, or since setSnippets().
    const std::vector<Fallback>& fallbacks() const;
    const ProgramCounters& counters() const; ///< Those of the cache.

    /// See ProgramCache. Forgets the fallbacks, too.
    void setSnippets(const SnippetSet& snippets);
    const SnippetSet& snippets() const; ///< What programs are composed from now.

    /// Call it when the context is lost: forgets all GL objects, and failures, but keeps counters, misses and
    /// fallbacks. The table must be replaced by one whose functions delete nothing.
    void lost();
    /// Call it when a new context is current and the table is that of the new context.
    void restore(const Capabilities& capabilities);

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace franken
