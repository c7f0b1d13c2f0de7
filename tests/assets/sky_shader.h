// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "franken/generator/pack.h"
#include "franken/reflection.h"

/// What a fragment shader makes of a sky's two textures, on the CPU and as a GPU does it: 8-bit texels,
/// bilinear filter. And how far that is from brute force.
namespace franken::test {

/// A texture's colour, clamped to the edge. uv: 0-1.
glm::vec4 sample(const Image& image, const glm::vec2& uv);

/// skyLight() of sky_irradiance.glsl. n: unit.
glm::vec3 skyLight(const ReflectionAtlas& atlas, const glm::vec3& n);

/// reflectedSky() of reflection/atlas.glsl. d: any length. level: 0-8.
glm::vec3 skyThroughLobe(const ReflectionAtlas& atlas, const glm::vec3& d, float level);

/// As glTF has it.
struct SkyMaterial {
    std::string name;
    glm::vec3 baseColor;
    float metallic;

    glm::vec3 f0() const; ///< The reflectance at normal incidence
};

/// A coloured and a white metal, a grey dielectric, and a black one, which shows the specular part alone.
const std::vector<SkyMaterial>& skyMaterials();

/// reflection/reflection.glsl. n, v: unit, v towards the eye.
glm::vec3 reflectedByShader(const ReflectionMaps& sky, const glm::vec3& n, const glm::vec3& v,
                            float roughness, const SkyMaterial& material);

/// ambient/irradiance.glsl on a white dielectric: irradiance over pi by the nine coefficients, in double.
glm::dvec3 irradianceByCoefficients(const LightsBlock& lights, const glm::vec3& n);

/// sRGB codes, 0-255, not rounded.
glm::vec3 codes(const glm::vec3& color);

/// The mean over the channels of how many codes two colours are apart.
double meanDifference(const glm::vec3& a, const glm::vec3& b);

struct SkyError {
    float nDotV, roughness;
    std::string material;
    double codes; ///< The mean difference from brute force, over orientations and channels
};

/// What the difference should not exceed: 3 codes straight on, where the split is exact, and 6 at N.V 0.2.
double goal(const SkyError& error);

/// For N.V 1 and 0.2, roughness 0.2 to 1, and all materials, in this order. The scattered light is the same
/// on both sides of the comparison, since it has a test of its own. sky: equirectangular, exposed.
std::vector<SkyError> skyErrors(const Environment& sky, int orientations);

} // namespace franken::test
