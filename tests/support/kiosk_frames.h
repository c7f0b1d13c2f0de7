// SPDX-License-Identifier: MIT
#pragma once

#include "franken/renderer.h"

#include <vector>

namespace franken::test {

/// The life of a kiosk in short: models change, move, bend and are coloured anew, lights go on and off, the
/// skybox comes and goes, the surface is resized. All that a run will need is known before: uses().
class KioskFrames {
public:
    KioskFrames();

    /// Of all models in all lights.
    std::vector<ProgramUse> uses() const;

    /// Adds the models.
    Result<void> load(Renderer& renderer);

    /// Draws frame number `frame`. `targets`: as many as there are sizes of the surface; each is used for
    /// some frames in turn.
    Result<void> draw(Renderer& renderer, int frame, const std::vector<DrawTarget>& targets);

private:
    Result<void> change(Renderer& renderer, int frame, std::size_t model);

    std::vector<Scene> m_scenes;
    std::vector<Lighting> m_lightings;
    std::vector<ModelId> m_models;
    std::vector<PlaceId> m_places; ///< A second one of each model.
    SkyboxMap m_sky;
};

} // namespace franken::test
