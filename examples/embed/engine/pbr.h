// SPDX-License-Identifier: MIT
#pragma once

#include "engine_gl.h"

#include <franken/program_cache.h>
#include <franken/uniform_block.h>

#include <franken/generator/pack.h>

/// What joins the engine to FrankenShader: a paint and the world's lights become a permutation and so a
/// program, and the engine's numbers become the four uniform blocks. Meshes, textures and GL state stay the
/// engine's.
class Pbr {
public:
    /// A thing's share of it, made once. While it lives, its program does.
    struct Look {
        franken::ProgramHandle program;
        franken::UniformBlock<franken::MaterialBlock> material;
        franken::UniformBlock<franken::ObjectBlock> object;
    };

    /// Both tables must outlive it.
    Pbr(const EngineGl& engine, const franken::Gl& gl) : m_engine(engine), m_cache(gl) {}

    franken::Result<Look> lookOf(const Paint& paint);

    /// What is the same for all things of a frame.
    void beginFrame(const World& world, float aspect);

    /// Draws with whatever is bound: the pictures to the units of their roles, depth test and culling on.
    void draw(const Thing& thing, Look& look, const GpuMesh& mesh) const;

    const franken::ProgramCounters& counters() const { return m_cache.counters(); }

private:
    void bindVertices(unsigned attributes, const GpuMesh& mesh) const;

    const EngineGl& m_engine;
    franken::ProgramCache m_cache;
    franken::UniformBlock<franken::FrameBlock> m_frame;
    franken::UniformBlock<franken::LightsBlock> m_lights;
    glm::mat4 m_viewProjection{1};
};
