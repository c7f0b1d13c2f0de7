// SPDX-License-Identifier: MIT
#include "gpu_scene.h"

#include "franken/scene_check.h"
#include "object_block.h"

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
    Uploader(Device& device, const Scene& scene, const DefaultTextures& defaults)
        : m_device(device), m_scene(scene), m_defaults(defaults) {}

    Result<GpuScene> make() {
        m_gpu.textures.resize(m_scene.textures.size());
        std::vector<std::size_t> first; // By scene mesh: its first primitive's GpuMesh.
        for (const Mesh& mesh : m_scene.meshes) {
            first.push_back(m_gpu.meshes.size());
            for (const Primitive& primitive : mesh.primitives) {
                Result<GpuMesh> made = GpuMesh::make(m_device, primitive);
                if (!made)
                    return made.error();
                m_gpu.meshes.push_back(*std::move(made));
            }
        }
        for (const Instance& instance : m_scene.instances)
            if (Result<void> added = add(instance, first[static_cast<std::size_t>(instance.mesh)]); !added)
                return added.error();
        return std::move(m_gpu);
    }

private:
    Result<void> add(const Instance& instance, std::size_t gpuMesh) {
        for (const Primitive& primitive :
             m_scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives) {
            const Material& source = m_scene.materials[static_cast<std::size_t>(primitive.material)];
            const Result<std::size_t> material = materialFor(primitive);
            if (!material)
                return material.error();
            m_gpu.drawables.push_back({.mesh = gpuMesh++,
                                       .material = *material,
                                       .bounds = boundsOf(primitive.bounds, instance.world),
                                       .position = glm::dvec3(instance.world[3]),
                                       .block = {},
                                       .mirrored = instance.mirrored,
                                       .doubleSided = source.doubleSided,
                                       .blended = source.alphaMode == AlphaMode::Blend});
            placeObject(m_gpu.drawables.back().block, instance.world, instance.mirrored);
        }
        return {};
    }

    Result<std::size_t> materialFor(const Primitive& primitive) {
        const VertexContents contents = contentsOf(primitive);
        for (std::size_t i = 0; i < m_gpu.materials.size(); ++i)
            if (m_gpu.materials[i].material == primitive.material && m_gpu.materials[i].contents == contents)
                return i;
        GpuMaterial gpu{.material = primitive.material,
                        .contents = contents,
                        .plan = planMaterial(m_scene, primitive.material, contents, m_device.log),
                        .textures = {},
                        .state = {},
                        .block = {}};
        const Material& source = m_scene.materials[static_cast<std::size_t>(primitive.material)];
        gpu.state = drawStateOf(m_scene, gpu.plan, source.alphaMode == AlphaMode::Blend);
        for (std::size_t unit = 0; unit < kMaterialUnits; ++unit) {
            const Result<GLuint> texture = textureFor(gpu.plan.textures[unit], unit);
            if (!texture)
                return texture.error();
            gpu.textures[unit] = *texture;
        }
        m_gpu.materials.push_back(gpu);
        return m_gpu.materials.size() - 1;
    }

    Result<GLuint> textureFor(int index, std::size_t unit) {
        if (index == kNone)
            return m_defaults.at(unit);
        GpuTexture& texture = m_gpu.textures[static_cast<std::size_t>(index)];
        if (!texture.texture) {
            const Texture& source = m_scene.textures[static_cast<std::size_t>(index)];
            const Image& image = m_scene.images[static_cast<std::size_t>(source.image)];
            Result<GpuTexture> made = uploadTexture(m_device, image, source, roleAt(unit).contents);
            if (!made)
                return made.error();
            texture = *std::move(made);
        }
        return texture.texture.name();
    }

    Device& m_device;
    const Scene& m_scene;
    const DefaultTextures& m_defaults;
    GpuScene m_gpu;
};

} // namespace

DefaultTextures::DefaultTextures(const Gl& gl) {
    for (std::size_t unit = 0; unit < kMaterialUnits; ++unit)
        m_textures.push_back(uploadTexel(gl, roleAt(unit).defaultTexel));
}

Result<GpuScene> upload(Device& device, const Scene& scene, const DefaultTextures& defaults) {
    if (Result<void> checked = check(scene); !checked)
        return checked.error();
    return Uploader(device, scene, defaults).make();
}

} // namespace franken
