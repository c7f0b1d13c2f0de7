// SPDX-License-Identifier: MIT
#include "franken/program_manager.h"

#include "franken/context_check.h"
#include "franken/generator/ladder.h"
#include "franken/guard.h"
#include "program_probe.h"
#include "texture_reset.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <thread>
#include <utility>

namespace franken {
namespace {

Error drawsNothing(const std::string& name) {
    return {
        "program.draw", name,
        "links, but draws nothing or a wrong color, as where the GPU's registers or digits do not suffice",
        "see what it needs with: frankenshader cost " + name};
}

Permutation endOfChain(Permutation permutation) {
    while (const std::optional<Permutation> next = simpler(permutation))
        permutation = *next;
    return permutation;
}

unsigned unitsOf(const ShaderProgram& program) {
    unsigned units = 0;
    for (const Sampler& sampler : program.interface().samplers)
        units |= 1u << sampler.unit;
    return units;
}

using Clock = std::chrono::steady_clock;

/// The longest wait for a driver that compiles in the background; after it, the driver is asked to finish.
constexpr std::chrono::seconds kMostPatience{30};

} // namespace

struct [[gnu::visibility("hidden")]] ProgramManager::State {
    using Draw = std::pair<Key, std::uint64_t>; ///< A program and the bits of its state.

    State(const Gl& table, const Capabilities& capabilities, Log log_, std::size_t capacity)
        : gl(&table),
          log(guardedLog(std::move(log_))),
          cache(table, {.capacity = capacity, .parallelCompile = capabilities.parallelCompile, .log = log}) {
        makeParts(capabilities);
    }

    void makeParts(const Capabilities& capabilities);
    void makeReset();
    bool isValidated(const ProgramUse& use, const ProgramHandle& program) const;
    Result<ProgramHandle> make(const ProgramUse& use, const DrawTarget* target);
    Result<Supplied> standIn(ProgramUse use, const DrawTarget* target);
    void fail(const Permutation& permutation, const Error& error);
    void noteMiss(const ProgramUse& use, const ProgramHandle& program);
    Result<std::vector<bool>> validate(std::span<const ProgramUse> uses,
                                       std::span<const ProgramHandle> programs, const DrawTarget* target);
    Result<std::vector<ProgramUse>> warm(std::span<const ProgramUse> uses, const DrawTarget& target,
                                         const std::function<void()>& step);
    void holdEnds(std::span<const ProgramUse> uses);

    const Gl* gl;
    Log log;
    ProgramCache cache;
    std::unique_ptr<TextureReset> reset; ///< Never null.
    std::unique_ptr<ProgramProbe> probe; ///< Never null; refers to the one before.
    bool ownSnippets = false;            ///< An application's.
    bool needsReset = false;             ///< Capabilities::compilesForStaleTextures.
    std::map<Draw, std::weak_ptr<ShaderProgram>> validated;
    std::vector<ProgramHandle>
        ends; ///< Of fallback chains; held, so that there is always a program to draw with.
    std::vector<ProgramUse> misses;
    std::vector<Fallback> fallbacks;
    unsigned budget = kUnlimited, left = kUnlimited;
};

ProgramManager::ProgramManager(const Gl& gl, const Capabilities& capabilities, Log log, std::size_t capacity)
    : m_state(std::make_unique<State>(gl, capabilities, std::move(log), capacity)) {}

ProgramManager::~ProgramManager() = default;

void ProgramManager::prepareDraw(GlState& state, const ShaderProgram& next) {
    m_state->reset->prepareFor(state, next);
}

void ProgramManager::invalidateState() { m_state->reset->invalidate(); }

void ProgramManager::setBudget(unsigned programsPerFrame) {
    m_state->budget = programsPerFrame;
    m_state->left = programsPerFrame;
}

void ProgramManager::resetBudget() { m_state->left = m_state->budget; }

const SnippetSet& ProgramManager::snippets() const { return m_state->cache.snippets(); }

void ProgramManager::setSnippets(const SnippetSet& snippets) {
    m_state->cache.setSnippets(snippets);
    m_state->ownSnippets = !snippets.isBuiltIn();
    m_state->probe =
        std::make_unique<ProgramProbe>(*m_state->gl, *m_state->reset, m_state->log, m_state->ownSnippets);
    m_state->validated.clear();
    m_state->ends.clear();
    m_state->fallbacks.clear();
}

void ProgramManager::lost() {
    m_state->cache.lost();
    m_state->validated.clear();
    m_state->ends.clear();
    m_state->makeParts(Capabilities{});
}

void ProgramManager::restore(const Capabilities& capabilities) {
    m_state->cache.setParallelCompile(capabilities.parallelCompile);
    m_state->makeParts(capabilities);
}

std::vector<ProgramUse> ProgramManager::takeMisses() { return std::exchange(m_state->misses, {}); }

const std::vector<Fallback>& ProgramManager::fallbacks() const { return m_state->fallbacks; }

const ProgramCounters& ProgramManager::counters() const { return m_state->cache.counters(); }

void ProgramManager::State::makeParts(const Capabilities& capabilities) {
    needsReset = capabilities.compilesForStaleTextures;
    reset = std::make_unique<TextureReset>(*gl);
    probe = std::make_unique<ProgramProbe>(*gl, *reset, log, ownSnippets);
}

// Where it fails, programs without textures are compiled more often, and that is all.
void ProgramManager::State::makeReset() {
    if (!needsReset || reset->hasProgram())
        return;
    if (Result<ProgramHandle> program = cache.get(resetPermutation()))
        reset->setProgram(*std::move(program));
}

bool ProgramManager::State::isValidated(const ProgramUse& use, const ProgramHandle& program) const {
    const auto found = validated.find({toKey(use.permutation), toBits(use.state, unitsOf(*program))});
    return found != validated.end() && found->second.lock() == program;
}

Result<ProgramManager::Supplied> ProgramManager::get(const ProgramUse& use, const DrawTarget* target) {
    if (const Result<Key> checked = checkedKey(use.permutation); !checked)
        return checked.error();
    State& state = *m_state;
    ProgramUse rung = use;
    while (true) {
        if (!state.cache.failure(rung.permutation)) {
            if (ProgramHandle program = state.cache.find(toKey(rung.permutation));
                program && state.isValidated(rung, program))
                return Supplied{std::move(program)};
            if (state.left == 0)
                return state.standIn(rung, target);
            --state.left;
            Result<ProgramHandle> made = state.make(rung, target);
            if (made) {
                state.noteMiss(rung, *made);
                return Supplied{*std::move(made)};
            }
            if (made.error().code == contextLost().code)
                return made.error();
        }
        const std::optional<Permutation> next = simpler(rung.permutation);
        if (!next)
            return *state.cache.failure(rung.permutation);
        rung.permutation = *next;
    }
}

// A resident program, or else the end of the chain, which does not count: something must be drawn.
Result<ProgramManager::Supplied> ProgramManager::State::standIn(ProgramUse use, const DrawTarget* target) {
    while (const std::optional<Permutation> next = simpler(use.permutation)) {
        use.permutation = *next;
        if (ProgramHandle program = cache.find(toKey(*next)); program && isValidated(use, program))
            return Supplied{std::move(program), true};
    }
    Result<ProgramHandle> made = make(use, target);
    if (!made)
        return made.error();
    ends.push_back(*made);
    return Supplied{*std::move(made), true};
}

Result<ProgramHandle> ProgramManager::State::make(const ProgramUse& use, const DrawTarget* target) {
    Result<ProgramHandle> program = cache.get(use.permutation);
    if (!program) {
        if (program.error().code != contextLost().code)
            fail(use.permutation, program.error());
        return program;
    }
    const Result<std::vector<bool>> drawn = validate({&use, 1}, {&*program, 1}, target);
    if (!drawn)
        return drawn.error();
    if (drawn->front())
        return program;
    return *cache.failure(use.permutation);
}

void ProgramManager::State::fail(const Permutation& permutation, const Error& error) {
    const auto isIt = [&](const Fallback& fallback) { return fallback.failed == permutation; };
    if (std::any_of(fallbacks.begin(), fallbacks.end(), isIt))
        return;
    const std::optional<Permutation> next = simpler(permutation);
    fallbacks.push_back({permutation, next, error});
    if (log)
        log(LogLevel::Error,
            toString(error) + "; key " + toHex(toKey(permutation)) + "; " +
                (next ? "drawn with " + toName(*next, cache.snippets()) + " instead" : "not drawn"));
}

void ProgramManager::State::noteMiss(const ProgramUse& use, const ProgramHandle& program) {
    const unsigned units = unitsOf(*program);
    const auto isIt = [&](const ProgramUse& miss) {
        return miss.permutation == use.permutation && toBits(miss.state, units) == toBits(use.state, units);
    };
    if (std::none_of(misses.begin(), misses.end(), isIt))
        misses.push_back(use);
}

Result<std::vector<bool>> ProgramManager::State::validate(std::span<const ProgramUse> uses,
                                                          std::span<const ProgramHandle> programs,
                                                          const DrawTarget* target) {
    std::vector<ProgramProbe::Draw> draws;
    for (std::size_t i = 0; i < uses.size(); ++i)
        draws.push_back({&uses[i].permutation, programs[i].get(), &uses[i].state});
    makeReset();
    std::vector<bool> drawn = probe->draw(draws, target);
    if (!answers(*gl))
        return contextLost();
    for (std::size_t i = 0; i < uses.size(); ++i)
        if (drawn[i]) {
            const std::uint64_t bits = toBits(uses[i].state, unitsOf(*programs[i]));
            validated[{toKey(uses[i].permutation), bits}] = programs[i];
        } else {
            const Error error = drawsNothing(toName(uses[i].permutation, cache.snippets()));
            cache.reject(uses[i].permutation, error);
            fail(uses[i].permutation, error);
        }
    return drawn;
}

Result<WarmUpReport> ProgramManager::warmUp(std::span<const ProgramUse> uses, const DrawTarget& target,
                                            const WarmUpProgress& progress) {
    for (const ProgramUse& use : uses)
        if (const Result<Key> checked = checkedKey(use.permutation); !checked)
            return checked.error();
    const Clock::time_point begin = Clock::now();
    const unsigned failures = counters().failures;
    std::vector<ProgramUse> round;
    const auto add = [&round](const ProgramUse& use) {
        if (std::find(round.begin(), round.end(), use) == round.end())
            round.push_back(use);
    };
    for (const ProgramUse& use : uses)
        add(use);
    for (const ProgramUse& use : uses)
        add({endOfChain(use.permutation), {.blend = use.state.blend}});
    WarmUpReport report;
    std::size_t total = 0, done = 0;
    while (!round.empty()) {
        report.draws += round.size();
        total += 2 * round.size();
        Result<std::vector<ProgramUse>> below = m_state->warm(round, target, [&] {
            ++done;
            if (progress)
                quietly([&] { progress(done, total); });
        });
        if (!below)
            return below.error();
        round = *std::move(below);
    }
    m_state->holdEnds(uses);
    report.programs = m_state->cache.size();
    report.failed = counters().failures - failures;
    report.milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
    return report;
}

void ProgramManager::State::holdEnds(std::span<const ProgramUse> uses) {
    for (const ProgramUse& use : uses)
        if (ProgramHandle end = cache.find(toKey(endOfChain(use.permutation))))
            if (std::find(ends.begin(), ends.end(), end) == ends.end())
                ends.push_back(std::move(end));
}

// All are handed to the driver before the first is waited for: two steps each, because some drivers compile
// in the one and some in the other. Returns the next simpler programs of those that failed.
Result<std::vector<ProgramUse>> ProgramManager::State::warm(std::span<const ProgramUse> uses,
                                                            const DrawTarget& target,
                                                            const std::function<void()>& step) {
    for (const ProgramUse& use : uses) {
        cache.compileInBackground(use.permutation);
        step();
    }
    std::vector<ProgramUse> made, below;
    std::vector<ProgramHandle> programs;
    const auto goDown = [&](const ProgramUse& use) {
        if (const std::optional<Permutation> next = simpler(use.permutation))
            below.push_back({*next, use.state});
    };
    const Clock::time_point deadline = Clock::now() + kMostPatience;
    for (const ProgramUse& use : uses) {
        while (cache.pending(use.permutation) && Clock::now() < deadline)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (Result<ProgramHandle> program = cache.get(use.permutation); program) {
            made.push_back(use);
            programs.push_back(*std::move(program));
        } else if (program.error().code == contextLost().code) {
            return program.error();
        } else {
            fail(use.permutation, program.error());
            goDown(use);
        }
        step();
    }
    const Result<std::vector<bool>> drawn = validate(made, programs, &target);
    if (!drawn)
        return drawn.error();
    for (std::size_t i = 0; i < made.size(); ++i)
        if (!(*drawn)[i])
            goDown(made[i]);
    return below;
}

} // namespace franken
