// SPDX-License-Identifier: MIT
#include "gpu_scene.h"

#include "equal_data.h"
#include "franken/scene_check.h"

#include <algorithm>

namespace franken {
namespace {

// Roles that share a unit have the same contents and the same default.
const TextureRoleRow& roleAt(std::size_t unit) {
    const std::span<const TextureRoleRow> roles = textureRoles();
    return *std::find_if(roles.begin(), roles.end(),
                         [&](const TextureRoleRow& role) { return role.unit == unit; });
}

class Uploader {
public:
    Uploader(Device& device, const Scene& scene, const Outline& outline, const DefaultTextures& defaults)
        : m_device(device), m_scene(scene), m_outline(outline.scene), m_defaults(defaults) {}

    Result<GpuScene> make() {
        m_gpu.textureOf.assign(m_scene.textures.size(), GpuScene::kNotUploaded);
        std::vector<std::size_t> first; // By scene mesh: its first GpuPrimitive.
        for (const Mesh& mesh : m_scene.meshes) {
            first.push_back(m_gpu.primitives.size());
            for (const Primitive& primitive : mesh.primitives)
                if (Result<void> added = add(primitive); !added)
                    return added.error();
        }
        for (const Instance& instance : m_scene.instances) {
            const auto mesh = static_cast<std::size_t>(instance.mesh);
            for (std::size_t i = 0; i < m_scene.meshes[mesh].primitives.size(); ++i)
                m_gpu.drawables.push_back({.primitive = first[mesh] + i,
                                           .world = instance.world,
                                           .mirrored = instance.mirrored,
                                           .visible = instance.visible,
                                           .nodeIndex = instance.nodeIndex,
                                           .offset = instance.offset});
        }
        return std::move(m_gpu);
    }

private:
    Result<void> add(const Primitive& primitive) {
        const auto [known, isNew] = m_meshes.try_emplace(&primitive, m_gpu.meshes.size());
        if (isNew) {
            Result<GpuMesh> made = GpuMesh::make(m_device, primitive);
            if (!made)
                return made.error();
            m_gpu.meshes.push_back(*std::move(made));
            m_contents.push_back(contentsOf(primitive));
        }
        GpuPrimitive gpu{.mesh = known->second,
                         .contents = m_contents[known->second],
                         .bounds = primitive.bounds,
                         .materials = {}};
        if (Result<void> added = addMaterial(gpu, primitive.material); !added)
            return added;
        for (const int material : primitive.variantMaterials)
            if (Result<void> added = addMaterial(gpu, material == kNone ? primitive.material : material);
                !added)
                return added;
        m_gpu.primitives.push_back(std::move(gpu));
        return {};
    }

    Result<void> addMaterial(GpuPrimitive& primitive, int material) {
        const Result<std::size_t> made = materialFor(material, primitive.contents);
        if (!made)
            return made.error();
        primitive.materials.push_back(*made);
        return {};
    }

    Result<std::size_t> materialFor(int material, const VertexContents& contents) {
        for (std::size_t i = 0; i < m_gpu.materials.size(); ++i)
            if (m_gpu.materials[i].material == material && m_gpu.materials[i].contents == contents)
                return i;
        GpuMaterial gpu{.material = material,
                        .contents = contents,
                        .plan = {},
                        .textures = {},
                        .state = {},
                        .doubleSided = false,
                        .blended = false,
                        .block = {}};
        planMaterial(gpu, m_outline, m_device.log);
        for (std::size_t unit = 0; unit < kMaterialUnits; ++unit)
            if (Result<void> uploaded = uploadFor(gpu.plan.textures[unit], unit); !uploaded)
                return uploaded.error();
        bindTextures(gpu, m_gpu, m_defaults);
        m_gpu.materials.push_back(std::move(gpu));
        return m_gpu.materials.size() - 1;
    }

    Result<void> uploadFor(int index, std::size_t unit) {
        if (index == kNone || m_gpu.textureOf[static_cast<std::size_t>(index)] != GpuScene::kNotUploaded)
            return {};
        const Texture& source = m_scene.textures[static_cast<std::size_t>(index)];
        const Image& image = m_scene.images[static_cast<std::size_t>(source.image)];
        const SampledImage sampled{&image, source, roleAt(unit).contents};
        const auto [known, isNew] = m_textures.try_emplace(sampled, m_gpu.textures.size());
        if (isNew) {
            Result<GpuTexture> made = uploadTexture(m_device, image, source, sampled.contents);
            if (!made)
                return made.error();
            m_gpu.textures.push_back(*std::move(made));
        }
        m_gpu.textureOf[static_cast<std::size_t>(index)] = known->second;
        return {};
    }

    Device& m_device;
    const Scene& m_scene;
    const Scene& m_outline;
    const DefaultTextures& m_defaults;
    GpuScene m_gpu;
    MapOfGeometry m_meshes;                 ///< To GpuScene::meshes.
    std::vector<VertexContents> m_contents; ///< By mesh.
    MapOfSampledImages m_textures;          ///< To GpuScene::textures.
};

} // namespace

DefaultTextures::DefaultTextures(const Gl& gl) {
    for (std::size_t unit = 0; unit < kMaterialUnits; ++unit)
        m_textures.push_back(uploadTexel(gl, roleAt(unit).defaultTexel));
}

Outline outlineOf(const Scene& scene) {
    Outline outline;
    outline.scene.textures = scene.textures;
    outline.scene.materials = scene.materials;
    outline.scene.variants = scene.variants;
    outline.scene.nodes = scene.nodes;
    for (const Instance& instance : scene.instances)
        outline.nodes.push_back(instance.name);
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
    for (std::size_t unit = 0; unit < kMaterialUnits; ++unit) {
        const int texture = material.plan.textures[unit];
        material.textures[unit] =
            texture == kNone ? defaults.at(unit)
                             : gpu.textures[gpu.textureOf[static_cast<std::size_t>(texture)]].texture.name();
    }
}

Result<GpuScene> upload(Device& device, const Scene& scene, const Outline& outline,
                        const DefaultTextures& defaults) {
    if (Result<void> checked = check(scene); !checked)
        return checked.error();
    return Uploader(device, scene, outline, defaults).make();
}

} // namespace franken
