// SPDX-License-Identifier: MIT
#include "gpu_scene.h"

#include <limits>

namespace franken {

DefaultTextures::DefaultTextures(const Gl& gl) {
    for (std::size_t unit = 0; unit < kUsedTextureUnits; ++unit)
        m_textures.push_back(isMaterialsUnit(unit) ? uploadTexel(gl, findRoleAt(unit)->defaultTexel)
                                                   : GlTexture());
}

Outline outlineOf(const Scene& scene) {
    Outline outline;
    outline.scene.textures = scene.textures;
    outline.scene.materials = scene.materials;
    outline.scene.variants = scene.variants;
    outline.scene.nodes = scene.nodes;
    outline.scene.skins = scene.skins;
    outline.scene.normalsWidenRoughness = scene.normalsWidenRoughness;
    for (const Instance& instance : scene.instances)
        outline.nodes.push_back(instance.name);
    worldsOf(scene, restPose(scene), outline.rest);
    return outline;
}

TextureUse useOf(const MaterialPlan& plan, const MaterialFactors& factors, std::size_t unit) {
    const Permutation& choices = plan.permutation;
    const bool packed = choices.metallicRoughness == MetallicRoughness::Packed;
    const std::size_t roughness =
        rowOf(packed ? TextureRole::MetallicRoughness : TextureRole::Roughness).unit;
    TextureUse use{.texture = plan.textures[unit]};
    if (unit != roughness || choices.normal != Normal::Map || choices.shading == Shading::Unlit ||
        choices.normalUv != choices.metallicRoughnessUv)
        return use;
    use.normals = plan.textures[rowOf(TextureRole::Normal).unit];
    use.scale = factors.normalScale;
    use.factor = factors.roughness;
    use.channel = packed ? 1 : 0;
    return use;
}

const std::size_t* GpuScene::findTexture(int texture) const {
    const auto found = textureOf.lower_bound({.texture = texture});
    return found == textureOf.end() || found->first.texture != texture ? nullptr : &found->second;
}

std::size_t GpuScene::textureFor(const TextureUse& use) const {
    const auto exact = textureOf.find(use);
    if (exact != textureOf.end())
        return exact->second;
    constexpr float kLeast = std::numeric_limits<float>::lowest();
    const auto pair =
        textureOf.lower_bound({.texture = use.texture, .normals = use.normals, .scale = kLeast});
    const bool isPair =
        pair != textureOf.end() && pair->first.texture == use.texture && pair->first.normals == use.normals;
    return isPair ? pair->second : *findTexture(use.texture);
}

void planMaterial(GpuMaterial& gpu, const Scene& outline, const Log& log) {
    const Material& source = outline.materials[static_cast<std::size_t>(gpu.material)];
    gpu.doubleSided = source.doubleSided;
    gpu.blended = source.alphaMode == AlphaMode::Blend;
    gpu.plan = planMaterial(outline, gpu.material, gpu.contents, log);
    gpu.state = drawStateOf(outline, gpu.plan, gpu.blended);
}

void replaceFactors(GpuMaterial& gpu, const Scene& outline) {
    replaceFactors(gpu.plan, outline.materials[static_cast<std::size_t>(gpu.material)]);
    gpu.isPacked = false;
}

void bindTextures(GpuMaterial& material, const GpuScene& gpu, const DefaultTextures& defaults) {
    for (std::size_t unit = 0; unit < kUsedTextureUnits; ++unit) {
        const int texture = material.plan.textures[unit];
        material.textures[unit] =
            texture == kNone
                ? defaults.at(unit)
                : gpu.textures[gpu.textureFor(useOf(material.plan, material.inMips, unit))].texture.name();
    }
}

} // namespace franken
