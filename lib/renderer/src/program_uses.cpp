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

namespace {

Result<ProgramUse> useOf(const Scene& scene, int index, const VertexContents& contents,
                         const Lighting& lighting, const Look& look, const Log& log) {
    const MaterialPlan plan = planMaterial(scene, index, contents, log);
    const Result<Permutation> permutation = permutationOf(plan, lighting, look);
    if (!permutation)
        return permutation.error();
    const Material& material = scene.materials[static_cast<std::size_t>(index)];
    return ProgramUse{*permutation, drawStateOf(scene, plan, material.alphaMode == AlphaMode::Blend)};
}

} // namespace

Result<std::vector<ProgramUse>> usesOf(const Scene& scene, const Lighting& lighting, const Look& look,
                                       const Log& log, Variants variants) {
    if (Result<void> checked = check(scene); !checked)
        return checked.error();
    std::vector<ProgramUse> uses;
    for (const Mesh& mesh : scene.meshes)
        for (const Primitive& primitive : mesh.primitives) {
            std::vector<int> materials{primitive.material};
            if (variants == Variants::All)
                for (const int material : primitive.variantMaterials)
                    if (material != kNone)
                        materials.push_back(material);
            const VertexContents contents = contentsOf(primitive);
            for (const int material : materials) {
                const Result<ProgramUse> use = useOf(scene, material, contents, lighting, look, log);
                if (!use)
                    return use.error();
                if (std::find(uses.begin(), uses.end(), *use) == uses.end())
                    uses.push_back(*use);
            }
        }
    return uses;
}

Result<ProgramUse> skyboxUse(const Look& look) {
    return skyPermutation(look).transform([](const Permutation& sky) { return ProgramUse{sky, {}}; });
}

} // namespace franken
