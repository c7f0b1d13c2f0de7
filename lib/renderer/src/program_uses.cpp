// SPDX-License-Identifier: MIT
#include "franken/program_uses.h"

#include "franken/scene_check.h"

#include <algorithm>

namespace franken {

DrawState drawStateOf(const Scene& scene, const MaterialPlan& plan, bool blended) {
    DrawState state{.blend = blended};
    for (std::size_t unit = 0; unit < plan.textures.size(); ++unit)
        if (plan.textures[unit] != kNone) {
            const Texture& texture = scene.textures[static_cast<std::size_t>(plan.textures[unit])];
            state.wraps[unit] = {texture.wrapS, texture.wrapT};
        }
    return state;
}

Result<std::vector<ProgramUse>> usesOf(const Scene& scene, const Lighting& lighting, const Look& look,
                                       const Log& log) {
    if (Result<void> checked = check(scene); !checked)
        return checked.error();
    std::vector<ProgramUse> uses;
    for (const Mesh& mesh : scene.meshes)
        for (const Primitive& primitive : mesh.primitives) {
            const Material& material = scene.materials[static_cast<std::size_t>(primitive.material)];
            const MaterialPlan plan = planMaterial(scene, primitive.material, contentsOf(primitive), log);
            const Result<Permutation> permutation = permutationOf(plan, lighting, look);
            if (!permutation)
                return permutation.error();
            const bool blended = material.alphaMode == AlphaMode::Blend;
            const ProgramUse use{*permutation, drawStateOf(scene, plan, blended)};
            if (std::find(uses.begin(), uses.end(), use) == uses.end())
                uses.push_back(use);
        }
    return uses;
}

Result<ProgramUse> skyboxUse(const Look& look) {
    const Result<Permutation> permutation = skyPermutation(look);
    if (!permutation)
        return permutation.error();
    return ProgramUse{*permutation, {}};
}

} // namespace franken
