// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/pack.h"
#include "franken/log.h"
#include "franken/scene.h"

#include <vector>

namespace FRANKEN_API franken {

/// What lights a picture. How many suns and punctual lights there are, whether one of them is a spot, the
/// kind of ambient light and whether it is mirrored choose programs; all else are uniforms, free to change
/// from frame to frame.
struct Lighting {
    std::vector<Sun> suns;                     ///< Up to Permutation::kMaxLights.
    std::vector<PunctualLight> punctualLights; ///< Up to Permutation::kMaxLights.
    Ambient ambient = Ambient::None;           ///< Which of the next two is used.
    Float3 ambientColor{0, 0, 0};              ///< Linear radiance, 0 and up.
    SkyCoefficients sky{};
    /// Beside Ambient::Sky: whether surfaces mirror the sky that the renderer was given
    /// (Renderer::setReflection).
    Reflection reflection = Reflection::None;
    float exposure = 1; ///< Multiplies all light, that of emissive surfaces included; above 0.
};

/// The suns and punctual lights of a scene, in its order. Warns of those beyond what one program takes and
/// leaves them out. Without ambient light.
Lighting lightingOf(const Scene& scene, const Log& log = {});

/// Folds all of it for programs. Punctual lights are given from the eye: `eye` is the camera's place in the
/// world, m.
LightsBlock packLighting(const Lighting& lighting, const glm::dvec3& eye);

} // namespace franken
