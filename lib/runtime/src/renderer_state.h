// SPDX-License-Identifier: MIT
#pragma once

#include "franken/gl_state.h"
#include "franken/renderer.h"
#include "gpu_scene.h"
#include "gpu_sky.h"

#include <memory>
#include <optional>

namespace franken {

/// Asked after an upload; GL's other errors are bugs.
Result<void> checkMemory(const Gl& gl);

/// A scene that was handed over, on the GPU or not.
struct Model {
    ModelId id;
    SceneSource source; ///< May be empty.
    std::optional<GpuScene> gpu = {};
    std::uint64_t lastShown = 0; ///< By State::shows.
};

/// A drawable of one of the models that are shown.
struct Placed {
    const GpuScene* scene;
    Drawable* drawable;
    const GpuMaterial& material() const { return scene->materials[drawable->material]; }
};

/// What a renderer is made of. The member functions stand by their subject: renderer_models.cpp,
/// renderer_programs.cpp, renderer_draw.cpp, renderer_sky.cpp.
struct Renderer::State {
    State(const Gl& table, const Capabilities& found, Log log_);

    Model* find(ModelId id);
    bool isShown(const Model& model) const;
    Result<void> upload(Model& model, const Scene& scene);
    Result<void> makeResident(Model& model);
    bool evictOne();
    void setShown(std::vector<Model*> models);

    Result<void> resolvePrograms(const DrawTarget* target);
    Result<ProgramHandle> resolve(const Result<Permutation>& permutation, const DrawState& state,
                                  const DrawTarget* target);
    Result<void> resolveMaterial(GpuMaterial& material, const DrawTarget* target);
    Result<void> resolveSky(const DrawTarget* target);
    void sortOpaque();

    void updateBlocks(const Viewpoint& viewpoint, const DrawTarget& target);
    void findVisible(const Viewpoint& viewpoint);
    void beginFrame(const DrawTarget& target);
    void use(ShaderProgram& program, const BlockViews& blocks);
    void drawOne(const Placed& placed);
    void drawBlended();

    Result<void> uploadBackdrop(const SkyCube& cube);
    Result<void> uploadMirror(const SkyMirror& source);
    void drawBackdrop();

    Device device() { return {gl, capabilities, memory, log}; }

    Gl gl; ///< A copy, so that it can be taken away when the context is lost.
    Capabilities capabilities;
    const Log log;
    GlState glState{gl};
    GpuMemory memory;
    ProgramSupply programs{gl, capabilities, log};
    std::optional<DefaultTextures> defaults; ///< Nothing while there is no context; likewise:
    std::optional<GpuMirror> mirror;
    MirrorSource mirrorSource;
    bool lost = false;

    std::vector<std::unique_ptr<Model>> models;
    std::vector<Model*> shown, wanted; ///< Neither is evicted; `wanted` is about to be shown.
    unsigned lastId = 0;
    std::uint64_t shows = 0;

    std::vector<Placed> opaque, blended;               ///< Of all that is shown.
    std::vector<Placed> visibleOpaque, visibleBlended; ///< In the order in which they are drawn.
    std::optional<glm::dmat4> seenFrom;                ///< What `visible…` were found with.

    GlTexture sky;
    MemoryLease skyMemory;
    GlBuffer skyTriangle;
    float skyRange = 0;
    SkySource skySource;
    ProgramHandle skyProgram;

    Lighting lighting;
    Look look;
    bool resolved = false; ///< No program is missing, and none stands in for another.
    UniformBlock<FrameBlock> frame;
    UniformBlock<LightsBlock> lights;
    const GpuMaterial* boundMaterial = nullptr; ///< Whose textures are bound; null: unknown.
};

} // namespace franken
