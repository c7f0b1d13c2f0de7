// SPDX-License-Identifier: MIT
#include "renderer_state.h"

namespace franken {

Error noContext() { return {"renderer.context-lost", "", "there is no context", "call restore() first"}; }

// Goes on after an error: what has a program is drawn.
Result<void> Renderer::State::resolvePrograms(const DrawTarget* target) {
    thread.check();
    if (lost)
        return noContext();
    if (resolved)
        return {};
    Result<void> result;
    const auto keepFirst = [&](Result<void> next) {
        if (result && !next)
            result = std::move(next);
    };
    glState.invalidate(); // Who makes programs uses them.
    resolved = true;
    for (Model* model : shown)
        for (GpuMaterial& material : model->gpu->materials)
            keepFirst(resolveMaterial(material, target));
    if (sky)
        keepFirst(resolveSky(target));
    sortOpaque();
    return result;
}

Result<ProgramHandle> Renderer::State::resolve(const Result<Permutation>& permutation, const DrawState& state,
                                               const DrawTarget* target) {
    if (!permutation)
        return permutation.error();
    const Result<ProgramSupply::Supplied> supplied = programs.get({*permutation, state}, target);
    if (!supplied)
        return supplied.error();
    resolved = resolved && !supplied->standIn;
    return supplied->program;
}

Result<void> Renderer::State::resolveMaterial(GpuMaterial& material, const DrawTarget* target) {
    material.program = nullptr;
    const Result<ProgramHandle> program =
        resolve(permutationOf(material.plan, lighting, look), material.state, target);
    if (!program)
        return program.error();
    material.program = *program;
    material.block.edit() = packMaterial(material.plan.factors, look.brdf, lighting.exposure);
    return {};
}

Result<void> Renderer::State::resolveSky(const DrawTarget* target) {
    skyProgram = nullptr;
    const Result<ProgramHandle> program = resolve(skyPermutation(look), {}, target);
    if (!program)
        return program.error();
    skyProgram = *program;
    return {};
}

Result<void> Renderer::prepare() { return m_state->resolvePrograms(nullptr); }

Result<WarmUpReport> Renderer::warmUp(const DrawTarget& target, std::span<const ProgramUse> uses,
                                      const WarmUpProgress& progress) {
    State& state = *m_state;
    if (state.lost)
        return noContext();
    const WarmUpReport report = state.programs.warmUp(uses, target, progress);
    state.glState.invalidate();
    return report;
}

void Renderer::setCompileBudget(unsigned programsPerFrame) { m_state->programs.setBudget(programsPerFrame); }

std::vector<ProgramUse> Renderer::takeMisses() { return m_state->programs.takeMisses(); }

const std::vector<LadderStep>& Renderer::ladderSteps() const { return m_state->programs.steps(); }

const ProgramCounters& Renderer::programCounters() const { return m_state->programs.counters(); }

} // namespace franken
