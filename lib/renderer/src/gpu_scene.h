// SPDX-License-Identifier: MIT
#pragma once

#include "franken/material.h"
#include "franken/program_cache.h"
#include "franken/program_uses.h"
#include "frustum.h"
#include "gpu_mesh.h"
#include "gpu_texture.h"

#include <glm/ext/matrix_double4x4.hpp>

#include <vector>

namespace franken {

/// A material on the GPU, on vertices with certain contents.
struct GpuMaterial {
    int material; ///< Of the scene.
    VertexContents contents;
    MaterialPlan plan;
    std::array<GLuint, kMaterialUnits> textures; ///< By sampler unit; never 0.
    DrawState state;
    UniformBlock<MaterialBlock> block;
    ProgramHandle program = nullptr; ///< In the current light and look; null where none can be had.
};

/// A primitive, placed in the world.
struct Drawable {
    std::size_t mesh, material; ///< Indices into GpuScene.
    Bounds bounds;              ///< In the world.
    glm::dvec3 position;        ///< Of its origin, in the world.
    ObjectBlock block;          ///< But for what depends on the camera.
    bool mirrored, doubleSided, blended;
};

/// A scene's GL objects and draws.
struct GpuScene {
    std::vector<GpuTexture> textures; ///< By scene texture; without a name where no material uses it.
    std::vector<GpuMesh> meshes;      ///< One for each primitive.
    std::vector<GpuMaterial> materials;
    std::vector<Drawable> drawables;
};

/// What is bound where a material has no texture: one texel that changes nothing.
class DefaultTextures {
public:
    explicit DefaultTextures(const Gl& gl);

    /// For a material's texture unit.
    GLuint at(std::size_t unit) const { return m_textures[unit].name(); }

private:
    std::vector<GlTexture> m_textures;
};

/// Fails as check(scene), with "memory.budget" and with "gl.object".
Result<GpuScene> upload(Device& device, const Scene& scene, const DefaultTextures& defaults);

} // namespace franken
