// SPDX-License-Identifier: MIT
#pragma once

#include "franken/renderer.h"
#include "gl_owner.h"
#include "gpu_scene.h"
#include "scene_loader.h"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace franken {

struct Model;

/// Where a model stands.
struct Place {
    PlaceId id;
    Model* model;
    glm::dmat4 world{1.0};
    bool visible = true;
    int variant = kNone;                                  ///< Of the scene.
    std::vector<NodeWorld> nodes = {};                    ///< In the model, by Scene::nodes; empty: at rest.
    Pose pose = {};                                       ///< That `nodes` are from.
    unsigned poses = 0;                                   ///< How often `pose` has changed.
    unsigned movements = 0;                               ///< How often `world` and `nodes` have changed.
    std::optional<UniformBlock<EffectBlock>> effect = {}; ///< Instead of the frame's.
};

/// Pixels in place of those of the scene.
struct TextureChange {
    Image image; ///< Without pixels where there is a source.
    PictureSource source;
};

/// A scene that was handed over, on the GPU or not.
struct Model {
    ModelId id;
    SceneSource source; ///< May be empty.
    Outline outline;
    std::vector<Place*> places;                        ///< The oldest first.
    std::map<int, Material> changedMaterials = {};     ///< By scene material.
    std::map<int, TextureChange> changedTextures = {}; ///< By scene texture.
    std::optional<PickTree> pickTree = {};
    std::shared_ptr<const Scene> scene = {}; ///< Of addInSteps(), until it is on the GPU.
    std::optional<Error> failure = {};       ///< Why its loading ended.
    std::optional<GpuScene> gpu = {};
    std::uint64_t lastShown = 0; ///< By Device::clock.
};

/// Fails with "renderer.material" where the model, which is on the GPU, would be drawn with a texture that
/// was not uploaded if the material had these values.
Result<void> checkLoaded(Model& model, int index, const Material& values);

/// The models of a renderer: which are on the GPU, which are shown, and where. Renderer says what its
/// functions do.
class Models final : public GlOwner {
public:
    explicit Models(Device& device);

    Result<ModelId> add(const Scene& scene, SceneSource source);
    Result<ModelId> addInSteps(Scene scene, SceneSource source);
    Result<void> show(std::span<const ModelId> ids, Wait wait);
    Result<bool> isResident(ModelId id) const;
    void remove(ModelId id);
    Result<void> load(const Scene& scene, SceneSource source);

    Result<PlaceId> addPlace(ModelId id, const glm::dmat4& world);
    Result<PlaceId> firstPlace(ModelId id) const;
    void removePlace(PlaceId id);
    Result<void> setWorld(PlaceId id, const glm::dmat4& world);
    Result<void> setVisible(PlaceId id, bool visible);
    Result<void> setEffectValues(PlaceId id, std::span<const Float4> values);
    Result<void> setPose(PlaceId id, const Pose& pose);

    Result<void> setVariant(ModelId id, std::string_view name);
    Result<void> setVariant(PlaceId id, std::string_view name);
    Result<void> setMaterial(ModelId id, int index, const Material& values);
    Result<Material> materialOf(ModelId id, int index) const;
    Result<void> setTexture(ModelId id, int index, const Image& image, PictureSource source);
    Result<ModelNames> namesOf(ModelId id) const;

    Result<void> setPickTree(ModelId id, std::optional<PickTree> tree);
    Result<std::optional<PlaceHit>> pick(const Ray& ray) const;

    /// Uploads a part of the model that is being loaded, of at most kStepBytes; how many bytes.
    Result<std::size_t> step();
    /// That is uploaded, and whose programs are to be made before finishLoading(); null where there is none.
    GpuScene* uploaded() { return m_loading && m_loading->gpu ? &*m_loading->gpu : nullptr; }
    /// Makes it resident, and shows it where that was asked for.
    Result<void> finishLoading();
    bool isLoading() const { return !m_queue.empty(); }
    /// Whether step() can do nothing until a thread has read or made something.
    bool isWaiting() const;

    void lost() override;
    Result<void> restore() override;
    std::optional<std::uint64_t> oldestUse() const override;
    void evictOldest() override;

    /// Filters the textures of what is shown so, where they are filtered otherwise.
    void setAnisotropy(float anisotropy);
    /// Those that are shown; all of them are on the GPU.
    const std::vector<Model*>& shown() const { return m_shown; }
    /// Another number after each change of what is shown: pointers into the models are only good for one.
    unsigned revision() const { return m_revision; }
    /// Another number after each change of where places are and whether they are visible.
    unsigned movements() const { return m_movements; }

private:
    static constexpr std::size_t kStepBytes = std::size_t{256} << 10;

    /// A model on its way.
    struct Loading {
        Model* model;
        std::unique_ptr<SceneLoader> loader;
        SceneUpload upload = {};
        std::optional<GpuScene> gpu = {}; ///< All of it is uploaded.
        Outline outline = {};
    };

    void enqueue(Model& model);
    void dequeue(const Model& model);
    bool beginLoading();
    void cancelLoading();
    Result<std::size_t> uploadPart();
    Result<void> applyMaterials(Model& model);
    void noteFailure(Model& model, const Error& error);

    Model* find(ModelId id) const;
    const Place* find(PlaceId id) const;
    Place* find(PlaceId id) { return const_cast<Place*>(std::as_const(*this).find(id)); }
    Place& makePlace(Model& model, const glm::dmat4& world);
    /// The next frame sorts all draws anew, where the model is shown.
    void notePlaces(const Model& model);
    /// What stands there is placed anew by the next frame.
    void noteMovement(Place& place);
    void erase(Model& model);
    void eraseAllBut(const Model* kept);
    Result<void> applyChanges(Model& model);
    void replan(GpuMaterial& material, const Model& model);
    Result<void> replaceTexture(Model& model, int index, const Image& image);
    bool isNeeded(const Model& model) const;
    const Model* oldest() const;
    void forgetOldNodes(Model& model);
    Result<void> upload(Model& model, const Scene& scene);
    Result<void> makeResident(Model& model);
    Result<void> makeResident(std::span<Model* const> models);
    void setShown(std::vector<Model*> models);
    Result<void> showResident(std::vector<Model*> list);

    Device& m_device;
    std::optional<DefaultTextures> m_defaults; ///< Nothing while there is no context.
    std::vector<std::unique_ptr<Model>> m_models;
    std::unordered_map<PlaceId, Place> m_places; ///< Whose addresses stay.
    std::vector<Model*> m_asked;                 ///< What show() was called with, resident or not.
    std::vector<Model*> m_shown;                 ///< Of these, the resident ones.
    std::vector<Model*> m_wanted;                ///< About to be shown. These and `m_asked` are not evicted.
    std::vector<Model*> m_queue;                 ///< To be loaded by step(); the first is being loaded.
    std::optional<Loading> m_loading;
    std::vector<std::unique_ptr<SceneLoader>> m_ending; ///< Cancelled; they keep the next one waiting.
    unsigned m_revision = 0, m_movements = 0;
};

} // namespace franken
