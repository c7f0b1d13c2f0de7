// SPDX-License-Identifier: MIT
#include "gpu_scene.h"

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
    for (const Instance& instance : scene.instances)
        outline.nodes.push_back(instance.name);
    worldsOf(scene, restPose(scene), outline.rest);
    return outline;
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
            texture == kNone ? defaults.at(unit)
                             : gpu.textures[gpu.textureOf[static_cast<std::size_t>(texture)]].texture.name();
    }
}

} // namespace franken
