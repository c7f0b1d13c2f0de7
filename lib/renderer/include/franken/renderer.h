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
#include "franken/pick.h"
#include "franken/place.h"
#include "franken/pose.h"
#include "franken/program_manager.h"
#include "franken/program_uses.h"
#include "franken/reflection.h"
#include "franken/scene.h"
#include "franken/viewpoint.h"

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

namespace FRANKEN_API franken {

/// A model that a renderer holds; no other handle of the process has its value.
enum class ModelId : unsigned {};

/// Where a ray first meets a shown model; point and distance are in the renderer's world.
struct PlaceHit : Hit {
    ModelId model{}; ///< Which model is there.
    PlaceId place{}; ///< Which of its places.
};

/// Load again what the GPU lost or evicted: a source reads its file anew, so that no pixels stay in memory
/// for that. Called from drawOverlay(), restore() and a show() that waits, in their thread; for step(), a
/// SceneSource is called on a thread of the renderer's. Never called twice at a time. A source must not call
/// the renderer. An exception that it throws becomes "renderer.exception".
using SceneSource = std::function<Result<Scene>()>;
using SkyboxSource = std::function<Result<SkyboxMap>()>;
using ReflectionSource = std::function<Result<ReflectionMaps>()>;

/// Whether a call waits until all is on the GPU.
enum class Wait { No, Yes };

/// What a step did.
struct StepReport {
    std::size_t bytes = 0; ///< Of texels, vertices and indices that were uploaded.
    unsigned programs = 0; ///< That were compiled.
    bool more = false;     ///< Something is still being loaded.
};

/// Counts of the last frame.
struct FrameCounters {
    std::size_t drawn = 0;  ///< Primitives.
    std::size_t culled = 0; ///< Primitives that lie outside the view.
};

/// Draws models: one pass, opaque and masked surfaces by program, material and mesh, then the skybox, then
/// blended surfaces back to front. Surfaces outside the view are culled.
///
/// A renderer holds any number of models on the GPU and shows some of them. If its memory has a budget (see
/// memory()), or the driver has none left, hidden models with a source are evicted, least recently shown
/// first, and loaded again when shown again; so are pictures that were not drawn since the last draw(). A
/// kiosk that changes models:
///
///     const SceneSource vase = [] { return loadGltf("vase.glb"); };
///     const Result<ModelId> id = renderer.add(*scene, vase); // The scene may come from another thread.
///     renderer.show({{*id}}, Wait::Yes);
///
/// Use it on one thread, with its GL context current, unless a function says otherwise; the destructor too. A
/// frame asks GL for nothing and sets the state that it depends on (gl_state.h has the list) where it is not
/// set yet: see invalidateState().
///
/// **Errors.** All functions that return a Result also fail with "renderer.context-lost" between
/// contextLost() and restore(), and where the context no longer answers: it counts as lost then. They fail
/// with "renderer.exception" where an exception was thrown; none leaves them. Uploads fail with
/// "memory.budget", with "renderer.memory" where the GPU's memory does not suffice even after everything that
/// can be was evicted, and with "gl.object" where the driver makes no object.
class Renderer {
public:
    /// Copies the table. Asks the context for its capabilities, and leaves GL's state as it was.
    explicit Renderer(const Gl& gl, Log log = {});
    Renderer(const Gl& gl, const Capabilities& capabilities, Log log = {});
    ~Renderer();

    /// Uploads a scene, without showing it. The scene is not needed afterwards. Logs a warning for everything
    /// that is left out. Fails as an upload, and as check(scene). A model without a source is never evicted,
    /// and is lost with the context.
    Result<ModelId> add(const Scene& scene, SceneSource source = {});

    /// Adds a scene that step() uploads; returns at once. Its images are decoded (ImageForm::Encoded) and
    /// made ready on a thread of the renderer's, one at a time, with at most 160 MiB in use for five of 4096
    /// x 4096. A loss of the context in the middle starts it again, with or without a source: the scene stays
    /// until it is uploaded. What is wrong with it, step() says. Costs the time to move the scene.
    Result<ModelId> addInSteps(Scene scene, SceneSource source = {});

    /// Shows these models and no others. Those that are not resident are loaded by step(), in their order,
    /// and are drawn from the frame on in which they are: the call never waits, unless it is told to. To keep
    /// the old picture until the new one is there, show both until isResident() says so. Fails with
    /// "renderer.model" for an unknown model, and with "renderer.no-source" for a lost one; what was shown
    /// stays then. With Wait::Yes, it fails as add() and as a source do, too, and the models that were shown
    /// stay, unless they were evicted to make room.
    Result<void> show(std::span<const ModelId> models, Wait wait = Wait::No);

    /// Whether a model is on the GPU, with its programs. Fails with the error that its loading ended with
    /// (show() begins again), and with "renderer.model". Costs nothing.
    Result<bool> isResident(ModelId model) const;

    /// Goes on with what is loaded in steps: does units of work until the time is up, at least one, and none
    /// where a thread has to read something first. A unit uploads at most 256 KiB of texels, vertices or
    /// indices, or makes one program, so that a call takes little more than its budget. A unit is longer
    /// where a program does not compile, and the simpler ones that stand in for it are tried one after the
    /// other, and where setTexture() changed a texture while its model was away, which is uploaded whole.
    /// Once in each frame, before draw(). Fails as an upload and as a source do, once for each model: it is
    /// not loaded further then, and all others are.
    Result<StepReport> step(std::chrono::microseconds budget = {});

    /// Deletes a model and its places. Does nothing for an unknown one.
    void remove(ModelId model);

    /// Adds a model, shows it and removes all others. Fails as add() does; the other models stay then, unless
    /// they were evicted to make room.
    Result<void> load(const Scene& scene, SceneSource source = {});

    // Places. add() puts a model at one place, where its scene has it. All places of a model share its
    // buffers, textures and programs: one more costs no GPU memory and some 300 bytes for each primitive.
    // All of them are drawn while the model is shown, but those that are hidden. None of these calls needs
    // the context, and none loses its effect where the model is evicted or the context lost. They fail with
    // "renderer.model" and "renderer.place" for what is not there (any more), and with "renderer.transform"
    // for a matrix that is not finite, or not affine.

    /// Puts a model at one more place. `world` leads from the scene's world to the renderer's. The next frame
    /// sorts all draws anew.
    Result<PlaceId> addPlace(ModelId model, const glm::dmat4& world = glm::dmat4(1.0));
    /// The oldest place of a model: the one that add() made, until it is removed.
    Result<PlaceId> firstPlace(ModelId model) const;
    /// Removes a place; the next frame sorts all draws anew. Does nothing for an unknown place.
    void removePlace(PlaceId place);
    /// Moves all that stands there; a mirror in the matrix mirrors. Uploads nothing: the next frame computes
    /// one matrix for each primitive of the place.
    Result<void> setWorld(PlaceId place, const glm::dmat4& world);
    /// Moves the nodes of what stands there (pose.h), and hides what the pose hides: the next frame computes
    /// one matrix for each primitive of the place, and one for each joint of a skin, which its program gets
    /// as uniforms. Where that is not enough (morph targets whose weights have changed, more than
    /// Permutation::kMaxInfluences joints for a vertex, files without normals, a program that fell down the
    /// ladder), the frame computes the vertices of what is in view on the CPU and uploads them, into buffers
    /// that the place has for itself (draw() fails with "memory.budget" or as an upload where there is no
    /// room; then they are drawn at rest, and those of a program that fell down the ladder are not drawn).
    /// The same pose again costs the CPU nothing. A skin that a program moves costs the GPU as much at rest
    /// as in motion, so that a first pose asks for no other program: 0.15 ms of a Pi 3's frame for 3,273
    /// vertices of four joints. Capabilities::joints of none has skins at rest drawn from vertices at rest.
    /// Allocates for the first pose of a place alone. Lighting and viewpoint are the application's: follow()
    /// moves the scene's lights and cameras. Fails with "pose.nodes" for a pose of another scene.
    Result<void> setPose(PlaceId place, const Pose& pose);
    /// Hides or shows what stands there, at no cost. Its programs are there already when it is shown.
    Result<void> setVisible(PlaceId place, bool visible);

    // Changes of a model. Each uploads what changed and nothing else, and outlasts eviction and loss of the
    // context. Where a material comes to need another program, that is a miss as any other (see takeMisses()
    // and setCompileBudget()); usesOf() lists the programs of all variants beforehand, and those of changed
    // materials for a scene that has them. They fail with "renderer.model" for an unknown model.

    /// Chooses one of the scene's variants (KHR_materials_variants) for all places that the model has now;
    /// "" for the materials without a variant. The materials of all variants are on the GPU from the start,
    /// so that nothing is uploaded; the next frame sorts all draws anew. Fails with "renderer.variant" for an
    /// unknown name.
    Result<void> setVariant(ModelId model, std::string_view name);
    /// Chooses a variant for one place. Fails as the function above does.
    Result<void> setVariant(PlaceId place, std::string_view name);

    /// Replaces a material of the scene; `material` is an index into Scene::materials. Where only factors are
    /// others (colours, metallic, roughness, scales, cutoff), no program is looked up: some uniforms are
    /// uploaded with the next draw; mips of roughness keep what they had of a normal map. Fails with
    /// "renderer.material" for an unknown index, for numbers out of range, for a texture that the scene does
    /// not have, and where the model would be drawn with one that none of its materials was drawn with when
    /// it was uploaded.
    Result<void> setMaterial(ModelId model, int material, const Material& values);
    /// The material as it is now, to be changed and set again. Fails as setMaterial() does.
    Result<Material> materialOf(ModelId model, int material) const;

    /// Replaces the pixels of a texture of the scene (an index into Scene::textures), and its size; its
    /// filters stay. Uploads the image with its mipmaps, into the same memory where the size is the same. The
    /// source reads the pixels again; without one, the renderer keeps them. Fails as an upload, and with
    /// "renderer.texture" for an index that is unknown or that no material uses. Mips of roughness keep what
    /// they had of a normal map (Scene::normalsWidenRoughness) where that is replaced, and have none of it
    /// where they are.
    Result<void> setTexture(ModelId model, int texture, const Image& image, PictureSource source = {});

    /// The names in a model; of evicted models as well. Copies them.
    Result<ModelNames> namesOf(ModelId model) const;

    // Picking. The renderer keeps no vertices on the CPU; a PickTree of a model's scene does. Neither call
    // needs the context.

    /// Takes the tree of the model's scene, by which pick() finds it, or none. Costs nothing; outlasts
    /// eviction and loss of the context. Fails with "renderer.model" for an unknown model, and with
    /// "renderer.tree" for a tree of a scene with other counts of instances, materials, variants or nodes.
    Result<void> setPickTree(ModelId model, std::optional<PickTree> tree);
    /// What the ray first meets of the models that are shown and have a tree, at all of their places that are
    /// visible, in their variants and with their materials as they are now: rayThrough() makes the ray of a
    /// point of the picture. It follows setWorld() and setPose(), but not an effect that moves vertices: what
    /// that moves is met where the tree's scene has it. Costs a test of a box for each such place, and O(log
    /// n) for a place that is near the ray; allocates nothing. A place in a pose costs more (PickTree). A
    /// place that its matrix presses flat is not met. Fails as PickTree::pick().
    Result<std::optional<PlaceHit>> pick(const Ray& ray) const;

    /// Shows a sky behind the scene, or none (null). It lights nothing; Lighting does. Fails as an upload,
    /// and with "renderer.sky" or "renderer.image" where the cube's faces do not fit together or the GPU.
    Result<void> setSkybox(const SkyboxMap* cube, SkyboxSource source = {});

    /// Takes the textures that surfaces reflect, or none (null). They are seen where Lighting::reflection
    /// asks for a reflection; without them, surfaces reflect no sky. Fails as setSkybox() does.
    Result<void> setReflection(const ReflectionMaps* maps, ReflectionSource source = {});

    /// May change from frame to frame. Other counts of lights, another kind of ambient light and any other
    /// look need other programs, which the next frame or prepare() compiles. Of more than four suns or
    /// punctual lights, four are used: see fittedLighting(). Lights with numbers that are not finite, or
    /// negative where they may not be, are refused: the last good ones stay, and draw() and prepare() fail
    /// with "renderer.lighting".
    void setLighting(const Lighting& lighting);
    void setLook(const Look& look);

    /// Recompiles all programs from these snippets: for snippet authors, and for applications with effects of
    /// their own (SnippetSet::with(), then Look::effect). To keep working programs on an error, try the
    /// snippets in a separate ProgramCache first. An effect that a driver refuses, or that draws nothing, is
    /// left out, and the log says so: see fallbacks().
    void setSnippets(const SnippetSet& snippets);
    const SnippetSet& snippets() const; ///< What programs are composed from now.

    /// The values of the effect, in the order in which its text declares them; those that are left out are 0,
    /// as all are at first. Uploads them with the next draw of each program, if they changed. Fails with
    /// "renderer.effect" for more than kEffectValues, and for numbers that are not finite.
    Result<void> setEffectValues(std::span<const Float4> values);
    /// Other values for what stands at a place; none for those above again. Fails with "renderer.place", too.
    Result<void> setEffectValues(PlaceId place, std::span<const Float4> values);

    /// Compiles the programs that the next frame needs. The driver may still compile them again for the
    /// target's format: see warmUp(). Fails as ProgramManager::get() does; materials that have a program are
    /// drawn all the same.
    Result<void> prepare();

    /// Compiles and draws with all these programs, so that frames that need no others compile nothing,
    /// neither in this library nor in the driver. usesOf() lists the needs of a scene in a certain light,
    /// readManifest() those of an earlier run. Call it once for each kind of target (its format, depth buffer
    /// and samples count, its size does not), before the first frame: the target's contents are undefined
    /// afterwards. Fails with "renderer.target"; a program that the driver refuses is replaced by the next
    /// simpler one.
    Result<WarmUpReport> warmUp(const DrawTarget& target, std::span<const ProgramUse> uses,
                                const WarmUpProgress& progress = {});

    /// How many programs a frame may compile; beyond, simpler ones stand in until later frames. For
    /// applications that stream scenes; unlimited at first.
    void setCompileBudget(unsigned programsPerFrame);

    /// The programs that were compiled outside warmUp() since the last call: for the manifest of the next
    /// start.
    std::vector<ProgramUse> takeMisses();

    /// The programs that were replaced by simpler ones, in the order in which they were, and why.
    const std::vector<Fallback>& fallbacks() const;

    /// Clears the target, or its area, and draws. Fails without drawing: with "renderer.target" for a size
    /// below 1, an area that is not in the target, bits that are not 1 to 16, or a background that is not
    /// finite; with "renderer.viewpoint" for numbers that are not finite. Fails as prepare() does, once for
    /// each set of programs, after it drew all materials that have a program.
    Result<void> draw(const Viewpoint& viewpoint, const DrawTarget& target);

    /// Uploads a picture for overlays. Fails as an upload, and with "renderer.image" where its size and its
    /// bytes differ. Without a source it is never evicted, and is lost with the context.
    Result<PictureId> addPicture(const Image& picture, PictureSource source = {});
    /// Replaces a picture's pixels, or a part of them whose upper left corner is at `x`, `y`. Uploads these
    /// pixels into the texture that is there, and allocates nothing: fit for each frame, but a GPU that draws
    /// in tiles (vc4, v3d) then keeps a copy for a frame that it still draws. A source must return the new
    /// pixels from then on. All pixels bring back a picture that was lost without a source. Fails as an
    /// upload and as the source where the picture is not on the GPU; with "renderer.image" as addPicture()
    /// does, with "renderer.picture-part" where the image does not lie in the picture, and for parts of a
    /// picture that was scaled down to the GPU's limit; with "renderer.picture" for an unknown picture, one
    /// that is the application's, and for a part of a lost one.
    Result<void> updatePicture(PictureId picture, const Image& image, int x = 0, int y = 0);
    /// A picture that is the application's own texture, for video. It is never written, evicted or deleted by
    /// the renderer, and not counted in memory(). Its filters and wraps stay as they are: without mipmaps,
    /// its filter must not use any, or it is black. Delete it after removePicture(); binding or writing it is
    /// a change of GL's state (invalidateState()). Asks GL whether it is a texture, which may wait for the
    /// driver. Fails with "renderer.application-texture" where it is none, or not of GL_TEXTURE_2D.
    Result<PictureId> addApplicationTexture(unsigned texture);
    /// Another texture for such a picture: after a lost context, which takes the old one along; until then
    /// drawing it fails with "renderer.picture". Fails as the function above does, and with
    /// "renderer.picture" for a picture that is not the application's. A video in several textures is best
    /// added as several pictures, because each change of names asks GL.
    Result<void> setApplicationTexture(PictureId picture, unsigned texture);
    void removePicture(PictureId picture);

    /// Draws rectangles in their order on top of the target's picture, clipped to it. Loads evicted pictures
    /// again. Fails without drawing: with "renderer.picture" for an unknown or lost picture, with
    /// "renderer.overlay" for numbers that are not finite, with "renderer.target", as a source does, as an
    /// upload where the pictures drawn since the last draw() do not fit, and as prepare() does.
    Result<void> drawOverlay(std::span<const OverlayQuad> quads, const DrawTarget& target);

    /// What the target's area holds, rows from the top down; a picture that is turned comes out turned. Waits
    /// for all that was drawn: not for every frame. Fails with "renderer.target" for a framebuffer that is
    /// not complete or that the driver cannot read, as one of several samples a pixel, and as an upload.
    Result<Image> readPixels(const DrawTarget& target);

    /// For a context that a toolkit draws with as well (Qt, GTK, SDL, ImGui): notes GL's state, all that the
    /// library touches (gl_state.h has the list), and takes over; stands for invalidateState(). Asks GL some
    /// 120 times, which may wait for the driver: for each frame, not for each draw.
    Result<void> acquireState();
    /// Hands GL back as it was at acquireState(); some 100 calls. Fails with "renderer.state" without it.
    Result<void> releaseState();

    /// Tells the renderer that GL's state was changed by others. Call it once, before the next other call.
    /// Bindings of framebuffers and the viewport may change untold.
    void invalidateState();

    /// The context and all objects in it are gone. Makes no GL call, and needs no context. The renderer
    /// remembers which models are shown, the skybox, the reflection, lighting and look.
    void contextLost();

    /// Rebuilds all models that are shown, the skybox and the reflection in a new context, which is current,
    /// from their sources; other models and pictures are loaded when they are shown and drawn. Where
    /// something cannot be rebuilt, the rest is, and the first error is returned. Without contextLost()
    /// before, the old context counts as lost. Leaves GL's state as it was.
    Result<void> restore(const Gl& gl);
    Result<void> restore(const Gl& gl, const Capabilities& capabilities);

    /// Bytes in use and their budget; an application reserves its own targets in it.
    GpuMemory& memory();

    FrameCounters frameCounters() const;            ///< Of the last draw().
    const ProgramCounters& programCounters() const; ///< Since the renderer was made.

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace franken
