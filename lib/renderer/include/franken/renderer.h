// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/capabilities.h"
#include "franken/draw_target.h"
#include "franken/environment.h"
#include "franken/gl.h"
#include "franken/gpu_memory.h"
#include "franken/light.h"
#include "franken/log.h"
#include "franken/material.h"
#include "franken/overlay.h"
#include "franken/program_supply.h"
#include "franken/program_uses.h"
#include "franken/scene.h"
#include "franken/specular_sky.h"
#include "franken/viewpoint.h"

#include <array>
#include <functional>
#include <memory>
#include <span>

namespace FRANKEN_API franken {

/// A model that a renderer holds; never given to another one.
enum class ModelId : unsigned {};

/// Makes again what the GPU lost or gave up, from where it came: reads the file again, so that no pixels are
/// kept in memory for that. Called from show() and restore(), in their thread; must not call the renderer.
using SceneSource = std::function<Result<Scene>()>;
using SkySource = std::function<Result<SkyCube>()>;
using MirrorSource = std::function<Result<SkyMirror>()>;

/// What the last frame showed.
struct FrameCounters {
    std::size_t drawn = 0;  ///< Primitives.
    std::size_t culled = 0; ///< Primitives that lie outside the view.
};

/// Draws models: one pass, opaque and masked surfaces by program, material and mesh, then the sky, then
/// blended surfaces back to front. What lies outside the view is not drawn.
///
/// A renderer holds any number of models on the GPU and shows some of them. Where its memory has a budget
/// (see memory()), models that are not shown and have a source are given up, those shown longest ago first,
/// and read again when they are shown. Likewise pictures for overlays that were not drawn since the last
/// draw(). A kiosk that changes models:
///
///     const SceneSource vase = [] { return loadGltf("vase.glb"); };
///     const Result<ModelId> id = renderer.add(*scene, vase); // The scene may come from another thread.
///     renderer.show({{*id}});
///
/// Belongs to the thread of its context, which must be current in all calls and in the destructor, except
/// where it is said otherwise. A frame asks GL for nothing and sets what it depends on (gl_state.h has the
/// list) where it is not set yet: see invalidateState().
class Renderer {
public:
    /// Copies the table. Asks the context for its capabilities.
    explicit Renderer(const Gl& gl, Log log = {});
    Renderer(const Gl& gl, const Capabilities& capabilities, Log log = {});
    ~Renderer();

    /// Uploads a scene, without showing it. The scene is not needed afterwards. Warns of what is left out.
    /// Fails with "memory.budget", and with "renderer.memory" where the GPU's memory does not suffice
    /// although the budget does. A model without a source is never given up, and is lost with the context.
    Result<ModelId> add(const Scene& scene, SceneSource source = {});

    /// Shows these models and no others; reads those again that were given up. Where that fails, what was
    /// shown stays, unless it had to make room. Fails as add() does, as a source does, with "renderer.model"
    /// for an unknown model, and with "renderer.no-source" for one that was lost.
    Result<void> show(std::span<const ModelId> models);

    /// Deletes a model. Does nothing for an unknown one.
    void remove(ModelId model);

    /// Adds a model, shows it and removes all others. Fails as add() does; what was there stays then, unless
    /// it had to make room.
    Result<void> load(const Scene& scene, SceneSource source = {});

    /// Shows a sky behind the scene, or none (null). It lights nothing: that is Lighting's matter. Fails as
    /// add() does.
    Result<void> setBackdrop(const SkyCube* cube, SkySource source = {});

    /// Takes what rough mirrors show of a sky, or nothing (null). Seen where Lighting::reflection asks for
    /// it; surfaces reflect no sky then while there is none here. Fails with "renderer.sky" where the atlas
    /// is larger than the GPU's textures, and as add() does.
    Result<void> setMirror(const SkyMirror* mirror, MirrorSource source = {});

    /// Free to change from frame to frame. New counts of lights, another kind of ambient light, and any other
    /// look need other programs, which the next frame or prepare() makes.
    void setLighting(const Lighting& lighting);
    void setLook(const Look& look);

    /// Makes programs from other snippets from now on, all of them anew: for people who write snippets. Who
    /// would rather keep what works tries them in a ProgramCache of his own first.
    void setSnippets(const SnippetSet& snippets);

    /// Makes the programs that the next frame needs. The driver may still compile them again for the target's
    /// format: see warmUp(). Fails as ProgramSupply::get() does; what has a program is drawn all the same.
    Result<void> prepare();

    /// Makes and draws with all these programs, so that frames that need no others compile nothing, neither
    /// in this library nor in the driver. usesOf() lists what scenes need in a certain light, readManifest()
    /// what was needed in an earlier run. To be called once for each kind of target (its format, depth buffer
    /// and samples count, its size does not), before the first frame: the target's contents are undefined
    /// afterwards. Fails with "renderer.context-lost" alone: what the driver refuses falls down the ladder.
    Result<WarmUpReport> warmUp(const DrawTarget& target, std::span<const ProgramUse> uses,
                                const WarmUpProgress& progress = {});

    /// How many programs a frame may make; beyond, simpler ones stand in until later frames. For those who
    /// stream scenes; unlimited unless set.
    void setCompileBudget(unsigned programsPerFrame);

    /// What had to be compiled outside warmUp() since the last call: for the manifest of the next start.
    std::vector<ProgramUse> takeMisses();

    /// Which programs gave way to simpler ones, in the order in which it happened, and why.
    const std::vector<LadderStep>& ladderSteps() const;

    /// Fails as prepare() does, once for each set of programs, after it drew what has a program; and with
    /// "renderer.context-lost" between contextLost() and restore().
    Result<void> draw(const Viewpoint& viewpoint, const DrawTarget& target);

    /// Uploads a picture for overlays. Fails as add() does. Without a source it is never given up, and is
    /// lost with the context.
    Result<PictureId> addPicture(const Image& picture, PictureSource source = {});
    void removePicture(PictureId picture);

    /// Draws rectangles in their order on top of what the target shows; what lies outside is cut off. Reads
    /// pictures again that were given up. Fails without drawing: with "renderer.picture" for an unknown or
    /// lost picture, as a source does, with "memory.budget" where the pictures drawn since the last draw() do
    /// not fit, and as prepare() does.
    Result<void> drawOverlay(std::span<const OverlayQuad> quads, const DrawTarget& target);

    /// Someone else changed GL's state since the last call: to be said once, before the next one. Bindings of
    /// framebuffers and the viewport need not be told of.
    void invalidateState();

    /// The context and all that was in it are gone. Makes no GL call, and needs no context. Shown models, the
    /// sky, lighting and look are remembered.
    void contextLost();

    /// Rebuilds all models that are shown and the sky in a new context, which is current, from their sources;
    /// other models and pictures come back when they are shown and drawn. Where something cannot be rebuilt,
    /// the rest is, and the first error is returned.
    /// Without contextLost() before, the old context counts as lost.
    Result<void> restore(const Gl& gl);
    Result<void> restore(const Gl& gl, const Capabilities& capabilities);

    /// Bytes in use and their budget; an application reserves its own targets in it.
    GpuMemory& memory();

    FrameCounters frameCounters() const;
    const ProgramCounters& programCounters() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace franken
