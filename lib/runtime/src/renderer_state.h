// SPDX-License-Identifier: MIT
#pragma once

#include "franken/renderer.h"
#include "gpu_scene.h"
#include "gpu_sky.h"

namespace franken {

/// Asked after an upload; GL's other errors are bugs.
Result<void> checkMemory(const Gl& gl);

/// What a renderer is made of. The member functions stand by their subject: renderer_programs.cpp,
/// renderer_draw.cpp, renderer_sky.cpp.
struct Renderer::State {
    State(const Gl& table, const Capabilities& found, Log log_)
        : gl(table), capabilities(found), log(std::move(log_)), cache(gl), defaults(gl), mirror(gl) {}

    Result<void> resolvePrograms();
    Result<void> resolveMaterial(GpuMaterial& material);
    Result<void> resolveSky();
    void sortOpaque();
    void updateBlocks(const Viewpoint& viewpoint, const DrawTarget& target);
    void beginFrame(const DrawTarget& target);
    void use(ShaderProgram& program, const BlockViews& blocks);
    void drawOne(const Drawable& drawable);
    Result<void> uploadBackdrop(const SkyCube& cube);
    void drawBackdrop();
    void drawBlended(const Viewpoint& viewpoint);

    const Gl& gl;
    const Capabilities capabilities;
    const Log log;
    ProgramCache cache;
    DefaultTextures defaults;
    GpuMirror mirror;

    GpuScene scene;
    std::vector<std::size_t> opaque, blended; ///< Indices of drawables.
    GlTexture sky;
    GlBuffer skyTriangle;
    float skyRange = 0;
    ShaderProgram* skyProgram = nullptr;

    Lighting lighting;
    Look look;
    bool resolved = false;
    UniformBlock<FrameBlock> frame;
    UniformBlock<LightsBlock> lights;
    unsigned enabledAttributes = 0; ///< Bit n: the array of location n.
};

} // namespace franken
