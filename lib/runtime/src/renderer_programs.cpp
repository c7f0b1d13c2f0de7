// SPDX-License-Identifier: MIT
#include "renderer_state.h"

namespace franken {

Result<void> Renderer::State::resolvePrograms() {
    if (resolved)
        return {};
    if (lost)
        return Error{"renderer.context-lost", "", "there is no context", "call restore() first"};
    glState.invalidate(); // Who makes programs uses them.
    for (Model* model : shown)
        for (GpuMaterial& material : model->gpu->materials)
            if (Result<void> made = resolveMaterial(material); !made)
                return made;
    if (sky)
        if (Result<void> made = resolveSky(); !made)
            return made;
    sortOpaque();
    resolved = true;
    return {};
}

Result<void> Renderer::State::resolveMaterial(GpuMaterial& material) {
    const Result<Permutation> permutation = permutationOf(material.plan, lighting, look);
    if (!permutation)
        return permutation.error();
    const Result<ProgramHandle> program = cache.get(*permutation);
    if (!program)
        return program.error();
    material.program = *program;
    material.block.edit() = packMaterial(material.plan.factors, look.brdf, lighting.exposure);
    return {};
}

Result<void> Renderer::State::resolveSky() {
    const Result<Permutation> permutation = skyPermutation(look);
    if (!permutation)
        return permutation.error();
    const Result<ProgramHandle> program = cache.get(*permutation);
    if (!program)
        return program.error();
    skyProgram = *program;
    return {};
}

} // namespace franken
