// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/pack.h"
#include "franken/log.h"
#include "franken/scene.h"

#include <glm/ext/matrix_double3x3.hpp>
#include <glm/ext/quaternion_double.hpp>

#include <string>
#include <vector>

namespace FRANKEN_API franken {

/// The lights of a picture. The numbers of suns and punctual lights, whether one of them is a spot, the kind
/// of ambient light and whether surfaces reflect it choose programs; everything else is a uniform, free to
/// change from frame to frame.
struct Lighting {
    std::vector<Sun> suns{};                     ///< See fittedLighting().
    std::vector<PunctualLight> punctualLights{}; ///< See fittedLighting().
    AmbientLight ambient{};                      ///< From all sides: none, a colour, or a sky.
    /// From the sky to the world: turns the skybox, `ambient.sky`, the reflection, and suns that are the
    /// sky's own (Sun::ofSky). About up: glm::angleAxis(angle, glm::dvec3(0, 1, 0)). Any length but 0. Costs
    /// nothing in a shader: the world is handed to programs as the sky sees it. A frame after a change
    /// computes the matrices of all objects again.
    glm::dquat skyRotation{1, 0, 0, 0};
    /// Beside Ambient::Sky: whether surfaces reflect the sky that the renderer was given
    /// (Renderer::setReflection).
    Reflection reflection = Reflection::None;
    float exposure = 1; ///< Multiplies all light, that of emissive surfaces included; above 0.
};

/// The suns and punctual lights of a scene, in its order, fitted: see fittedLighting(), which is logged.
/// Without ambient light.
Lighting lightingOf(const Scene& scene, const Log& log = {});

/// Limits the lighting to the number of lights that one program takes (Permutation::kMaxLights of each kind).
/// Of more suns, the two nearest in direction become one until four are left: their irradiances add, and the
/// direction is the mean, weighted by irradiance. Of more punctual lights, the four of the highest luminous
/// intensity remain, in their order.
Lighting fittedLighting(Lighting lighting);
/// A description of the fitting, for a log; empty where nothing has to be fitted.
std::string fittingOf(const Lighting& lighting);

/// The rotation from the world to the sky's space, in which programs compute: the inverse of skyRotation.
glm::dmat3 skyFromWorld(const Lighting& lighting);

/// Fits the lighting (see fittedLighting()) and folds it for programs. Lights are converted to the sky's
/// space, and punctual lights become relative to `eye`, the camera's position in the world, m.
LightsBlock packLighting(const Lighting& lighting, const glm::dvec3& eye);

} // namespace franken
