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

/// "renderer.context-lost"
Error noContext();

/// A scene that was handed over, on the GPU or not.
struct Model {
    ModelId id;
    SceneSource source; ///< May be empty.
    std::optional<GpuScene> gpu = {};
    std::uint64_t lastShown = 0; ///< By State::clock.
};

/// A picture for overlays, on the GPU or not.
struct Picture {
    PictureId id;
    PictureSource source;        ///< May be empty.
    std::uint64_t lastDrawn = 0; ///< By State::clock.
    GpuTexture texture = {};
};

/// A drawable of a model that is shown: all that a frame reads of it, in one place.
struct Object {
    ObjectBlock block;
    std::uint64_t serial = 0; ///< Of the block.
    Bounds bounds;
    glm::dvec3 position; ///< Of its origin, in the world.
    const GpuMesh* mesh;
    const GpuMaterial* material;
    unsigned order; ///< By model, material and mesh.
    bool mirrored, doubleSided;
    bool visible = false;
};

/// What a renderer is made of. The member functions stand by their subject: renderer_models.cpp,
/// renderer_programs.cpp, renderer_draw.cpp, renderer_sky.cpp, renderer_overlay.cpp, renderer_context.cpp.
struct [[gnu::visibility("hidden")]] Renderer::State {
    State(const Gl& table, const Capabilities& found, Log log_);

    Model* find(ModelId id);
    bool isShown(const Model& model) const;
    Result<void> upload(Model & model, const Scene& scene);
    Result<void> makeResident(Model & model);
    bool evictOne();
    Model* oldestModel();
    Picture* oldestPicture();
    void setShown(std::vector<Model*> models);
    void addObjects(const GpuScene& scene);

    Result<void> resolvePrograms(const DrawTarget* target);
    Result<ProgramHandle> resolve(const Result<Permutation>& permutation, const DrawState& state,
                                  const DrawTarget* target);
    Result<void> resolveMaterial(GpuMaterial & material, const DrawTarget* target);
    Result<void> resolveSky(const DrawTarget* target);
    void sortOpaque();

    void updateBlocks(const Viewpoint& viewpoint, const DrawTarget& target);
    void findVisible(const Viewpoint& viewpoint);
    bool place(Object & object, const Frustum& frustum, const Viewpoint& viewpoint);
    void beginFrame(const DrawTarget& target);
    void use(ShaderProgram & program, const BlockViews& blocks);
    void drawOpaque();
    void bind(const GpuMaterial& material);
    void drawOne(const Object& object);
    void drawSides(const Object& object);
    void drawBlended();

    Result<void> uploadBackdrop(const SkyCube& cube);
    Result<void> uploadMirror(const SkyMirror& source);
    void drawBackdrop();

    Result<void> uploadPicture(Picture & picture, const Image& image);
    Picture* find(PictureId id);
    Result<void> makeResident(Picture & picture);
    Result<void> prepareOverlay(std::span<const OverlayQuad> quads);
    void makeOverlayBuffers();
    void beginOverlay(ShaderProgram & program, const DrawTarget& target);
    void drawQuads(std::span<const OverlayQuad> quads, unsigned attributes);

    Device device() { return {gl, capabilities, memory, log}; }

    OwnThread thread;
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
    /// Ticks with each frame and each change of what is shown. Pictures drawn since `frameBegan` are not
    /// evicted.
    std::uint64_t clock = 1, frameBegan = 1;

    std::vector<Object> opaque, blended;    ///< Of all that is shown; `opaque` in its order of drawing.
    std::vector<const Object*> backToFront; ///< Those of `blended` that are visible.
    std::optional<Viewpoint> seenFrom;      ///< What objects were placed with.
    std::size_t drawn = 0;                  ///< How many are visible.

    GlTexture sky;
    MemoryLease skyMemory;
    GlBuffer skyTriangle;
    float skyRange = 0;
    SkySource skySource;
    ProgramHandle skyProgram;

    std::vector<Picture> pictures;
    GlBuffer overlayVertices, overlayIndices;
    ProgramHandle overlayProgram; ///< Null where the look has changed.
    UniformBlock<MaterialBlock> overlayMaterial;
    UniformBlock<ObjectBlock> overlayObject;

    Lighting lighting;
    Look look;
    bool resolved = false; ///< No program is missing, and none stands in for another.
    UniformBlock<FrameBlock> frame;
    UniformBlock<LightsBlock> lights;
    const GpuMaterial* boundMaterial = nullptr; ///< Whose program and textures are bound; null: unknown.
};

} // namespace franken
