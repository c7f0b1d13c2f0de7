// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/capabilities.h"
#include "franken/draw_state.h"
#include "franken/draw_target.h"
#include "franken/gl_state.h"
#include "franken/program_cache.h"

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <span>
#include <utility>

namespace FRANKEN_API franken {

class ProgramProbe;
class TextureReset;

/// A program that failed, and the one that is drawn with instead. The same thing happens wherever the driver
/// is the same: `frankenshader dump` writes both programs from their names.
struct LadderStep {
    Permutation failed;
    std::optional<Permutation> next; ///< Nothing below the last rung.
    Error error;                     ///< "program.compile", "program.link" or "program.draw".
};

/// Told how many of the steps are done; from the thread that called.
using WarmUpProgress = std::function<void(std::size_t done, std::size_t total)>;

struct WarmUpReport {
    std::size_t programs = 0; ///< That are resident now, those for later stand-ins included.
    std::size_t draws = 0;    ///< Combinations of program and state that were drawn.
    std::size_t failed = 0;   ///< Programs that gave way to simpler ones.
    double milliseconds = 0;
};

/// Programs that are proved to draw: what a renderer asks, above ProgramCache.
///
/// **Ladder.** A program that fails to compile, to link or to draw gives way to simpler() ones. vc4's worst
/// failure is silent: the link succeeds, the registers do not suffice at the draw, and nothing is drawn. So
/// each program is drawn once with one pixel that was cleared before and is read back; unchanged is failed.
/// It is drawn over two colours before that is said, because one of them may be what it draws. Where the
/// target cannot be read back (two clears look the same), programs are taken on trust, which is logged once.
///
/// **Warm-up.** warmUp() hands all programs to the driver, asks for their status after, and draws with each
/// in each state that will be used. What get() has to make later is a miss.
///
/// **Budget.** Where get() may make no more programs in this frame, the first rung that is resident stands
/// in.
///
/// Belongs to the thread of its context, as ProgramCache does. Making a program leaves GL's state undefined
/// (see GlState for what is touched), framebuffer and viewport included.
class ProgramSupply {
public:
    static constexpr unsigned kUnlimited = std::numeric_limits<unsigned>::max();

    /// The table must outlive it. The log hears of each step down the ladder, once.
    ProgramSupply(const Gl& gl, const Capabilities& capabilities, Log log,
                  std::size_t capacity = ProgramCacheOptions{}.capacity);
    ~ProgramSupply();

    /// How many programs get() may make from one beginFrame() to the next.
    void setBudget(unsigned programsPerFrame);
    void beginFrame() { m_left = m_budget; }

    struct Supplied {
        ProgramHandle program;
        bool standIn = false; ///< Ask again in the next frame.
    };

    /// What to draw with now. Programs that have to be proved are drawn into the target (its contents are
    /// undefined afterwards), or into one of their own where there is none. Fails where even the last rung
    /// does, with its error.
    Result<Supplied> get(const ProgramUse& use, const DrawTarget* target);

    /// Makes all that these uses need, and the last rungs of their ladders. The target is one of those that
    /// will be drawn to, or like them; its contents are undefined afterwards.
    WarmUpReport warmUp(std::span<const ProgramUse> uses, const DrawTarget& target,
                        const WarmUpProgress& progress = {});

    /// Before each draw of a program that get() returned, with blending and depth state set: some drivers need
    /// textures reset (Capabilities::compilesForStaleTextures). May change program, arrays and unit 0.
    void prepareDraw(GlState& state, const ShaderProgram& next);

    /// Someone else drew in this context.
    void invalidateState();

    std::vector<ProgramUse> takeMisses() { return std::exchange(m_misses, {}); }
    const std::vector<LadderStep>& steps() const { return m_steps; }
    const ProgramCounters& counters() const { return m_cache.counters(); }

    /// See ProgramCache. Forgets the steps down the ladder, too.
    void setSnippets(const SnippetSet& snippets);

    /// After a lost context, when the table has been replaced by one that does nothing: forgets all that was
    /// in the context, failures included, and keeps counters, misses and steps.
    void abandon();
    /// Of the next context.
    void setCapabilities(const Capabilities& capabilities);

private:
    using Draw = std::pair<Key, std::uint64_t>; ///< A program and the bits of its state.

    bool isProved(const ProgramUse& use, const ProgramHandle& program) const;
    Result<ProgramHandle> make(const ProgramUse& use, const DrawTarget* target);
    Result<Supplied> standIn(ProgramUse use, const DrawTarget* target);
    void fail(const Permutation& permutation, const Error& error);
    void noteMiss(const ProgramUse& use, const ProgramHandle& program);
    std::vector<bool> prove(std::span<const ProgramUse> uses, std::span<const ProgramHandle> programs,
                            const DrawTarget* target);
    std::vector<ProgramUse> warm(std::span<const ProgramUse> uses, const DrawTarget& target,
                                 const std::function<void()>& step);

    void makeParts(const Capabilities& capabilities);
    void makeReset();

    const Gl* m_gl;
    Log m_log;
    ProgramCache m_cache;
    std::unique_ptr<TextureReset> m_reset; ///< Never null.
    std::unique_ptr<ProgramProbe> m_probe; ///< Never null; refers to the one before.
    bool m_needsReset = false;             ///< As Capabilities has it.
    std::map<Draw, std::weak_ptr<ShaderProgram>> m_proved;
    std::vector<ProgramHandle> m_lastRungs; ///< Held, so that something can always stand in.
    std::vector<ProgramUse> m_misses;
    std::vector<LadderStep> m_steps;
    unsigned m_budget = kUnlimited, m_left = kUnlimited;
};

} // namespace franken
