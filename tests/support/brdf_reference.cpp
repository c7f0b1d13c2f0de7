// SPDX-License-Identifier: MIT
#include "support/brdf_reference.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace franken::test {
namespace {

// Cosines, clamped at 0.
struct Angles {
    double nDotL, nDotV, nDotH, vDotH;
};

Angles anglesOf(const LitPoint& point) {
    const glm::dvec3 halfway = glm::normalize(point.toCamera + point.toLight);
    const auto cosine = [](const glm::dvec3& a, const glm::dvec3& b) {
        return std::max(glm::dot(a, b), 0.0);
    };
    return {cosine(point.normal, point.toLight), cosine(point.normal, point.toCamera),
            cosine(point.normal, halfway), cosine(point.toCamera, halfway)};
}

// Walter et al., "Microfacet Models for Refraction through Rough Surfaces", 2007, equation 33.
double distribution(double nDotH, double alpha) {
    const double denominator = nDotH * nDotH * (alpha * alpha - 1) + 1;
    return alpha * alpha / (glm::pi<double>() * denominator * denominator);
}

// Heitz, "Understanding the Masking-Shadowing Function", 2014, as G / (4 N.L N.V).
double visibilityGltf(const Angles& a, double alpha) {
    const auto masked = [alpha](double to, double from) {
        return to * std::sqrt(from * from * (1 - alpha * alpha) + alpha * alpha);
    };
    const double sum = masked(a.nDotL, a.nDotV) + masked(a.nDotV, a.nDotL);
    return sum > 0 ? 0.5 / sum : 0;
}

// Hammon, "PBR Diffuse Lighting for GGX+Smith Microsurfaces", 2017.
double visibilityFast(const Angles& a, double alpha) {
    return 0.5 / glm::mix(2 * a.nDotL * a.nDotV, a.nDotL + a.nDotV, alpha);
}

// Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", 1994: G1(x) = x / (x (1 - k) + k).
double schlickOverCosine(double cosine, double k) { return 1 / (cosine * (1 - k) + k); }

double visibilitySchlick(const Angles& a, double alpha) {
    return schlickOverCosine(a.nDotL, alpha / 2) * schlickOverCosine(a.nDotV, alpha / 2) / 4;
}

// The page divides by 4 N.L N.V, but by no less than 0.001.
double visibilitySeed(const Angles& a, double roughness) {
    const double k = (roughness + 1) * (roughness + 1) / 8;
    return a.nDotL * schlickOverCosine(a.nDotL, k) * a.nDotV * schlickOverCosine(a.nDotV, k) /
           std::max(4 * a.nDotL * a.nDotV, 0.001);
}

double visibility(const Angles& angles, double roughness, Brdf brdf) {
    const double alpha = roughness * roughness;
    switch (brdf) {
    case Brdf::Gltf:
        return visibilityGltf(angles, alpha);
    case Brdf::Fast:
        return visibilityFast(angles, alpha);
    case Brdf::Schlick:
        return visibilitySchlick(angles, alpha);
    case Brdf::Seed:
        return visibilitySeed(angles, roughness);
    }
    return 0;
}

} // namespace

glm::dvec3 radianceOf(const LitPoint& point, Brdf brdf) {
    const Angles angles = anglesOf(point);
    if (angles.nDotL <= 0)
        return glm::dvec3(0);
    const double lobe = glm::pi<double>() * angles.nDotL *
                        distribution(angles.nDotH, point.roughness * point.roughness) *
                        visibility(angles, point.roughness, brdf);
    const double rim = std::pow(1 - angles.vDotH, 5);
    const auto fresnel = [rim](const glm::dvec3& f0) { return f0 + (1.0 - f0) * rim; };
    if (brdf == Brdf::Seed) {
        const glm::dvec3 f = fresnel(glm::mix(glm::dvec3(0.04), point.baseColor, point.metallic));
        return (1.0 - f) * (1 - point.metallic) * point.baseColor * angles.nDotL + f * lobe;
    }
    // glTF 2.0, appendix B.2: two materials, mixed by metalness.
    const glm::dvec3 metal = fresnel(point.baseColor) * lobe;
    const glm::dvec3 f = fresnel(glm::dvec3(0.04));
    const glm::dvec3 dielectric = (1.0 - f) * point.baseColor * angles.nDotL + f * lobe;
    return glm::mix(dielectric, metal, point.metallic);
}

} // namespace franken::test
