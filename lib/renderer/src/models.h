// SPDX-License-Identifier: MIT
#pragma once

#include "franken/renderer.h"
#include "gl_owner.h"
#include "gpu_scene.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace franken {

/// A scene that was handed over, on the GPU or not.
struct Model {
    ModelId id;
    SceneSource source; ///< May be empty.
    std::optional<GpuScene> gpu = {};
    std::uint64_t lastShown = 0; ///< By Device::clock.
};

/// The models of a renderer: which are on the GPU, and which are shown. Renderer says what its functions do.
class Models final : public GlOwner {
public:
    explicit Models(Device& device);

    Result<ModelId> add(const Scene& scene, SceneSource source);
    Result<void> show(std::span<const ModelId> ids);
    void remove(ModelId id);
    Result<void> load(const Scene& scene, SceneSource source);

    void lost() override;
    Result<void> restore() override;
    std::optional<std::uint64_t> oldestUse() const override;
    void evictOldest() override;

    /// Those that are shown; all of them are on the GPU.
    const std::vector<Model*>& shown() const { return m_shown; }
    /// Another number after each change of what is shown: pointers into the models are only good for one.
    unsigned revision() const { return m_revision; }

private:
    Model* find(ModelId id) const;
    bool isNeeded(const Model& model) const;
    const Model* oldest() const;
    Result<void> upload(Model& model, const Scene& scene);
    Result<void> makeResident(Model& model);
    Result<void> makeResident(std::span<Model* const> models);
    void setShown(std::vector<Model*> models);

    Device& m_device;
    std::optional<DefaultTextures> m_defaults; ///< Nothing while there is no context.
    std::vector<std::unique_ptr<Model>> m_models;
    std::vector<Model*> m_shown, m_wanted; ///< Neither is evicted; `m_wanted` is about to be shown.
    unsigned m_revision = 0;
};

} // namespace franken
