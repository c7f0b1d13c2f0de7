// SPDX-License-Identifier: MIT
#include "gpu_scene.h"

#include <algorithm>

namespace franken {
namespace {

std::size_t unitOf(const char* sampler) { return static_cast<std::size_t>(samplerUnit(sampler)); }

Encoding encodingOf(std::size_t unit) {
    const bool color = unit == unitOf("uBaseColorTexture") || unit == unitOf("uEmissiveTexture");
    return color ? Encoding::Srgb : Encoding::Linear;
}

class Uploader {
public:
    Uploader(const Gl& gl, const Scene& scene, const DefaultTextures& defaults,
             const Capabilities& capabilities, const Log& log)
        : m_gl(gl), m_scene(scene), m_defaults(defaults), m_capabilities(capabilities), m_log(log) {}

    GpuScene make() {
        m_gpu.textures.resize(m_scene.textures.size());
        std::vector<std::size_t> first; // By scene mesh: its first primitive's GpuMesh.
        for (const Mesh& mesh : m_scene.meshes) {
            first.push_back(m_gpu.meshes.size());
            for (const Primitive& primitive : mesh.primitives)
                m_gpu.meshes.emplace_back(m_gl, primitive, m_capabilities);
        }
        for (const Instance& instance : m_scene.instances)
            add(instance, first[static_cast<std::size_t>(instance.mesh)]);
        return std::move(m_gpu);
    }

private:
    void add(const Instance& instance, std::size_t gpuMesh) {
        const glm::dmat4 world(instance.world);
        for (const Primitive& primitive :
             m_scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives) {
            const Material& material = m_scene.materials[static_cast<std::size_t>(primitive.material)];
            const glm::dvec3 center =
                0.5 * (glm::dvec3(primitive.bounds.min) + glm::dvec3(primitive.bounds.max));
            m_gpu.drawables.push_back({.mesh = gpuMesh++,
                                       .material = materialFor(primitive),
                                       .world = world,
                                       .center = glm::dvec3(world * glm::dvec4(center, 1)),
                                       .mirrored = instance.mirrored,
                                       .doubleSided = material.doubleSided,
                                       .blended = material.alphaMode == AlphaMode::Blend,
                                       .block = {}});
        }
    }

    std::size_t materialFor(const Primitive& primitive) {
        const VertexContents contents = contentsOf(primitive);
        for (std::size_t i = 0; i < m_gpu.materials.size(); ++i)
            if (m_gpu.materials[i].material == primitive.material && m_gpu.materials[i].contents == contents)
                return i;
        GpuMaterial gpu{.material = primitive.material,
                        .contents = contents,
                        .plan = planMaterial(m_scene, primitive.material, contents, m_log),
                        .textures = {},
                        .block = {}};
        for (std::size_t unit = 0; unit < kMaterialUnits; ++unit)
            gpu.textures[unit] = textureFor(gpu.plan.textures[unit], unit);
        m_gpu.materials.push_back(gpu);
        return m_gpu.materials.size() - 1;
    }

    GLuint textureFor(int index, std::size_t unit) {
        if (index == kNone)
            return (unit == unitOf("uNormalTexture") ? m_defaults.flatNormal : m_defaults.white).name();
        GlTexture& texture = m_gpu.textures[static_cast<std::size_t>(index)];
        const Texture& source = m_scene.textures[static_cast<std::size_t>(index)];
        if (!texture)
            texture = uploadTexture(m_gl, m_scene.images[static_cast<std::size_t>(source.image)], source,
                                    encodingOf(unit), m_capabilities, m_log);
        return texture.name();
    }

    const Gl& m_gl;
    const Scene& m_scene;
    const DefaultTextures& m_defaults;
    const Capabilities& m_capabilities;
    const Log& m_log;
    GpuScene m_gpu;
};

} // namespace

DefaultTextures::DefaultTextures(const Gl& gl)
    : white(uploadTexel(gl, {255, 255, 255, 255})), flatNormal(uploadTexel(gl, {128, 128, 255, 255})) {}

GpuScene upload(const Gl& gl, const Scene& scene, const DefaultTextures& defaults,
                const Capabilities& capabilities, const Log& log) {
    return Uploader(gl, scene, defaults, capabilities, log).make();
}

} // namespace franken
