// SPDX-License-Identifier: MIT
#pragma once

#include "franken/material.h"
#include "franken/place.h"
#include "franken/pose.h"
#include "franken/program_cache.h"
#include "franken/program_uses.h"
#include "frustum.h"
#include "gpu_mesh.h"
#include "gpu_texture.h"

#include <glm/ext/matrix_double4x4.hpp>

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace franken {

/// A texture of the scene, as a material uses it. A roughness texture is another one beside another normal
/// map, because its mips hold what those of the normal map lose.
struct TextureUse {
    int texture;             ///< Of the scene.
    int normals = kNone;     ///< Of the scene; kNone where the texture's mips are its own alone.
    float scale = 0;         ///< Of the normal map.
    float factor = 0;        ///< Of roughness.
    std::size_t channel = 0; ///< That holds roughness.
    auto operator<=>(const TextureUse&) const = default;
};
/// The material's texture in that unit, with the factors that are in its mips. Beside a normal map with other
/// texture coordinates, roughness is by itself: their mips cover other parts of the surface.
TextureUse useOf(const MaterialPlan& plan, const MaterialFactors& factors, std::size_t unit);

/// A material on the GPU, on vertices with certain contents.
struct GpuMaterial {
    int material; ///< Of the scene.
    VertexContents contents;
    MaterialPlan plan;
    std::array<GLuint, kUsedTextureUnits> textures; ///< By sampler unit; 0 for those of skies.
    DrawState state;
    bool doubleSided, blended;
    UniformBlock<MaterialBlock> block;
    MaterialFactors inMips = {};     ///< Those that mips of roughness were made with, whatever they are now.
    bool isPacked = false;           ///< The block is that of the plan, in the current light and look.
    ProgramHandle program = nullptr; ///< In the current light and look; null where none can be had.
};

/// What is drawn at once. Primitives of equal geometry share a mesh.
struct GpuPrimitive {
    std::size_t mesh; ///< Of GpuScene.
    VertexContents contents;
    Box bounds;                                     ///< At rest.
    std::shared_ptr<const Deformation> deformation; ///< May be null.
    std::vector<std::size_t> materials; ///< Of GpuScene: its own, and then one for each variant, if any.

    std::size_t materialIn(int variant) const {
        const auto place = static_cast<std::size_t>(variant + 1);
        return materials[place < materials.size() ? place : 0];
    }
};

/// A primitive of an instance.
struct Drawable {
    std::size_t primitive; ///< Of GpuScene.
    glm::dmat4 world;      ///< From the object to where the model stands, at rest.
    bool mirrored;
    bool visible;      ///< At rest.
    int nodeIndex;     ///< Of the scene; kNone for what no pose moves.
    int skin;          ///< Of the scene; kNone for what no joints move.
    glm::dmat4 offset; ///< From the object to its node.
};

/// A scene's GL objects and draws.
struct GpuScene {
    std::vector<GpuTexture> textures;
    std::map<TextureUse, std::size_t> textureOf; ///< Those that materials use.
    float anisotropy = 1;                        ///< Of all textures.
    std::vector<GpuMesh> meshes;
    std::vector<GpuMaterial> materials;
    std::vector<GpuPrimitive> primitives; ///< In the order of the scene's meshes.
    std::vector<Drawable> drawables;
    /// By place and drawable: what a pose has deformed.
    std::map<std::pair<PlaceId, std::size_t>, PosedMesh> posed;

    /// The first use of a texture of the scene; null where no material used it when it was uploaded.
    const std::size_t* findTexture(int texture) const;
    /// The same for this use; where that was not uploaded, because a material has changed, for the one that
    /// is nearest: with that normal map, or any.
    std::size_t textureFor(const TextureUse& use) const;
};

/// What stays of a scene when its pixels and vertices are on the GPU.
struct Outline {
    Scene scene; ///< Textures, materials, variants, nodes and skins alone.
    std::vector<std::string> nodes;
    std::vector<NodeWorld> rest; ///< Where the scene's nodes are at rest.
};
Outline outlineOf(const Scene& scene);

/// What is bound where a material has no texture: one texel that changes nothing.
class DefaultTextures {
public:
    explicit DefaultTextures(const Gl& gl);

    /// For a material's texture unit.
    GLuint at(std::size_t unit) const { return m_textures[unit].name(); }

private:
    std::vector<GlTexture> m_textures;
};

/// Fills in all that follows from the material of the outline, but the textures' names.
void planMaterial(GpuMaterial& gpu, const Scene& outline, const Log& log);
/// Of a material that differs from the one before in factors alone.
void replaceFactors(GpuMaterial& gpu, const Scene& outline);
/// Fills in these, all of which are uploaded.
void bindTextures(GpuMaterial& material, const GpuScene& gpu, const DefaultTextures& defaults);

} // namespace franken
