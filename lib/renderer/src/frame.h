// SPDX-License-Identifier: MIT
#pragma once

#include "draw_list.h"
#include "franken/program_manager.h"
#include "reflection_textures.h"
#include "skybox.h"

namespace franken {

/// Lighting and look, the programs that they ask for, and the draws of a frame.
class Frame final : public GlOwner {
public:
    struct Content {
        Models& models;
        Skybox& skybox;
        ReflectionTextures& reflection;
    };
    Frame(Device& device, ProgramManager& programs, const Content& content)
        : m_device(device), m_programs(programs), m_content(content) {}

    void setLighting(const Lighting& lighting);
    void setLook(const Look& look);
    const Look& look() const { return m_look; }
    void setEffectValues(const EffectBlock& values) { m_effect.set(values); }
    /// The skybox or the snippets have changed.
    void forgetPrograms() { m_resolved = false; }

    /// Finds the program of each material and of the skybox. Goes on after an error: materials that have a
    /// program are drawn. Returns the first error.
    Result<void> resolvePrograms(const DrawTarget* target);

    /// Makes the next program that the scene needs and that is not there yet; false where there is none left.
    /// Goes on after an error: draw() tells it.
    bool makeProgram(GpuScene& scene);

    /// With resolved programs. Fails where there is no memory for the vertices of a pose: they are drawn at
    /// rest, and all else is drawn.
    Result<void> draw(const Viewpoint& viewpoint, const DrawTarget& target);

    FrameCounters counters() const { return m_counters; }

    void lost() override;
    Result<void> restore() override { return {}; }

private:
    Result<ProgramHandle> resolve(const Result<Permutation>& permutation, const DrawState& state,
                                  const DrawTarget* target);
    Result<void> resolveMaterial(GpuMaterial& material, const DrawTarget* target);
    Result<void> resolveSkybox(const DrawTarget* target);

    void updateBlocks(const PlacedView& view, const DrawTarget& target);
    PlacedView viewFrom(const Viewpoint& viewpoint, Rotation rotation) const;
    void begin(const DrawTarget& target);
    void clear(const DrawTarget& target);
    void use(ShaderProgram& program, const BlockViews& blocks);
    void bind(const GpuMaterial& material);
    /// Of what poses have changed and programs do not move.
    Result<void> moveVertices();
    Result<void> moveVertices(Object& object);
    Result<void> moveVertices(Object& object, const Deforming& pose, PosedMesh& posed);
    void feedPalette(ShaderProgram& program, const Object& object, std::size_t part);
    void drawOne(const Object& object);
    void drawSides(const Object& object);
    void drawOpaque();
    void drawSkybox();
    void drawBlended();

    Device& m_device;
    ProgramManager& m_programs;
    Content m_content;

    Lighting m_lighting;
    Look m_look;
    bool m_resolved = false;      ///< No program is missing, and none stands in for another.
    unsigned m_modelRevision = 0; ///< That the list was built for.
    DrawList m_list;
    ProgramHandle m_skyboxProgram;
    UniformBlock<FrameBlock> m_frame;
    UniformBlock<LightsBlock> m_lights;
    UniformBlock<EffectBlock> m_effect;           ///< Where a place has no values of its own.
    SkinBlock m_skin = {};                        ///< Of the part of a mesh that was drawn last.
    std::uint64_t m_skinSerial = 0;               ///< Of the block.
    const GpuMaterial* m_boundMaterial = nullptr; ///< Whose program and textures are bound; null: unknown.
    FrameCounters m_counters;
    Vertices m_moved; ///< Of the last object whose vertices were moved.
};

} // namespace franken
