// SPDX-License-Identifier: MIT
#include "franken/program_supply.h"

#include "franken/generator/ladder.h"
#include "program_probe.h"
#include "texture_reset.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>

namespace franken {
namespace {

Error drawsNothing(const Permutation& permutation) {
    const std::string name = toName(permutation);
    return {"program.draw", name, "links, but draws nothing, as where the GPU's registers do not suffice",
            "see what it needs with: frankenshader cost " + name};
}

std::string hexOf(Key key) {
    char text[17];
    std::snprintf(text, sizeof(text), "%016llx", static_cast<unsigned long long>(key));
    return text;
}

Permutation lastRung(Permutation permutation) {
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

} // namespace

ProgramSupply::ProgramSupply(const Gl& gl, const Capabilities& capabilities, Log log, std::size_t capacity)
    : m_gl(&gl),
      m_log(std::move(log)),
      m_cache(gl, {.capacity = capacity, .parallelCompile = capabilities.parallelCompile, .log = m_log}) {
    makeParts(capabilities);
}

void ProgramSupply::makeParts(const Capabilities& capabilities) {
    m_needsReset = capabilities.compilesForStaleTextures;
    m_reset = std::make_unique<TextureReset>(*m_gl);
    m_probe = std::make_unique<ProgramProbe>(*m_gl, *m_reset, m_log);
}

// Where it fails, programs without textures are compiled more often, and that is all.
void ProgramSupply::makeReset() {
    if (!m_needsReset || m_reset->hasProgram())
        return;
    if (Result<ProgramHandle> program = m_cache.get(resetPermutation()))
        m_reset->setProgram(*std::move(program));
}

ProgramSupply::~ProgramSupply() = default;

void ProgramSupply::prepareDraw(GlState& state, const ShaderProgram& next) { m_reset->prepareFor(state, next); }

void ProgramSupply::invalidateState() { m_reset->invalidate(); }

void ProgramSupply::setBudget(unsigned programsPerFrame) {
    m_budget = programsPerFrame;
    m_left = programsPerFrame;
}

void ProgramSupply::setSnippets(const SnippetSet& snippets) {
    m_cache.setSnippets(snippets);
    m_proved.clear();
    m_lastRungs.clear();
    m_steps.clear();
}

void ProgramSupply::abandon() {
    m_cache.abandon();
    m_proved.clear();
    m_lastRungs.clear();
    makeParts(Capabilities{});
}

void ProgramSupply::setCapabilities(const Capabilities& capabilities) {
    m_cache.setParallelCompile(capabilities.parallelCompile);
    makeParts(capabilities);
}

bool ProgramSupply::isProved(const ProgramUse& use, const ProgramHandle& program) const {
    const auto found = m_proved.find({toKey(use.permutation), toBits(use.state, unitsOf(*program))});
    return found != m_proved.end() && found->second.lock() == program;
}

Result<ProgramSupply::Supplied> ProgramSupply::get(const ProgramUse& use, const DrawTarget* target) {
    ProgramUse rung = use;
    while (true) {
        const Error* const failed = m_cache.failure(rung.permutation);
        if (!failed) {
            if (ProgramHandle program = m_cache.find(toKey(rung.permutation));
                program && isProved(rung, program))
                return Supplied{std::move(program)};
            if (m_left == 0)
                return standIn(rung, target);
            --m_left;
            if (Result<ProgramHandle> made = make(rung, target); made) {
                noteMiss(rung, *made);
                return Supplied{*std::move(made)};
            }
        }
        const std::optional<Permutation> next = simpler(rung.permutation);
        if (!next)
            return *m_cache.failure(rung.permutation);
        rung.permutation = *next;
    }
}

// What is resident, or else the last rung, which does not count: something must be drawn.
Result<ProgramSupply::Supplied> ProgramSupply::standIn(ProgramUse use, const DrawTarget* target) {
    while (const std::optional<Permutation> next = simpler(use.permutation)) {
        use.permutation = *next;
        if (ProgramHandle program = m_cache.find(toKey(*next)); program && isProved(use, program))
            return Supplied{std::move(program), true};
    }
    Result<ProgramHandle> made = make(use, target);
    if (!made)
        return made.error();
    m_lastRungs.push_back(*made);
    return Supplied{*std::move(made), true};
}

Result<ProgramHandle> ProgramSupply::make(const ProgramUse& use, const DrawTarget* target) {
    Result<ProgramHandle> program = m_cache.get(use.permutation);
    if (!program) {
        fail(use.permutation, program.error());
        return program;
    }
    if (prove({&use, 1}, {&*program, 1}, target).front())
        return program;
    return *m_cache.failure(use.permutation);
}

void ProgramSupply::fail(const Permutation& permutation, const Error& error) {
    const auto isIt = [&](const LadderStep& step) { return step.failed == permutation; };
    if (std::any_of(m_steps.begin(), m_steps.end(), isIt))
        return;
    const std::optional<Permutation> next = simpler(permutation);
    m_steps.push_back({permutation, next, error});
    if (m_log)
        m_log(LogLevel::Error, toString(error) + "; key " + hexOf(toKey(permutation)) + "; " +
                                   (next ? "drawn with " + toName(*next) + " instead" : "not drawn"));
}

void ProgramSupply::noteMiss(const ProgramUse& use, const ProgramHandle& program) {
    const unsigned units = unitsOf(*program);
    const auto isIt = [&](const ProgramUse& miss) {
        return miss.permutation == use.permutation && toBits(miss.state, units) == toBits(use.state, units);
    };
    if (std::none_of(m_misses.begin(), m_misses.end(), isIt))
        m_misses.push_back(use);
}

std::vector<bool> ProgramSupply::prove(std::span<const ProgramUse> uses,
                                       std::span<const ProgramHandle> programs, const DrawTarget* target) {
    std::vector<ProgramProbe::Draw> draws;
    for (std::size_t i = 0; i < uses.size(); ++i)
        draws.push_back({&uses[i].permutation, programs[i].get(), &uses[i].state});
    makeReset();
    const std::vector<bool> drawn = m_probe->draw(draws, target);
    for (std::size_t i = 0; i < uses.size(); ++i)
        if (drawn[i]) {
            const std::uint64_t bits = toBits(uses[i].state, unitsOf(*programs[i]));
            m_proved[{toKey(uses[i].permutation), bits}] = programs[i];
        } else {
            const Error error = drawsNothing(uses[i].permutation);
            m_cache.reject(uses[i].permutation, error);
            fail(uses[i].permutation, error);
        }
    return drawn;
}

WarmUpReport ProgramSupply::warmUp(std::span<const ProgramUse> uses, const DrawTarget& target,
                                   const WarmUpProgress& progress) {
    const Clock::time_point begin = Clock::now();
    const unsigned failures = m_cache.counters().failures;
    std::vector<ProgramUse> round;
    const auto add = [&round](const ProgramUse& use) {
        if (std::find(round.begin(), round.end(), use) == round.end())
            round.push_back(use);
    };
    for (const ProgramUse& use : uses)
        add(use);
    for (const ProgramUse& use : uses)
        add({lastRung(use.permutation), {.blend = use.state.blend}});
    WarmUpReport report;
    std::size_t total = 0, done = 0;
    while (!round.empty()) {
        report.draws += round.size();
        total += 2 * round.size();
        round = warm(round, target, [&] {
            if (progress)
                progress(++done, total);
        });
    }
    for (const ProgramUse& use : uses)
        if (ProgramHandle last = m_cache.find(toKey(lastRung(use.permutation))))
            if (std::find(m_lastRungs.begin(), m_lastRungs.end(), last) == m_lastRungs.end())
                m_lastRungs.push_back(std::move(last));
    report.programs = m_cache.size();
    report.failed = m_cache.counters().failures - failures;
    report.milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
    return report;
}

// All are begun before the first is waited for: two steps each, because some drivers compile in the one and
// some in the other. Returns the next rungs of those that failed.
std::vector<ProgramUse> ProgramSupply::warm(std::span<const ProgramUse> uses, const DrawTarget& target,
                                            const std::function<void()>& step) {
    for (const ProgramUse& use : uses) {
        m_cache.begin(use.permutation);
        step();
    }
    std::vector<ProgramUse> made, below;
    std::vector<ProgramHandle> programs;
    const auto goDown = [&](const ProgramUse& use) {
        if (const std::optional<Permutation> next = simpler(use.permutation))
            below.push_back({*next, use.state});
    };
    for (const ProgramUse& use : uses) {
        while (m_cache.pending(use.permutation))
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (Result<ProgramHandle> program = m_cache.get(use.permutation); program) {
            made.push_back(use);
            programs.push_back(*std::move(program));
        } else {
            fail(use.permutation, program.error());
            goDown(use);
        }
        step();
    }
    const std::vector<bool> drawn = prove(made, programs, &target);
    for (std::size_t i = 0; i < made.size(); ++i)
        if (!drawn[i])
            goDown(made[i]);
    return below;
}

} // namespace franken
