// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "franken/environment.h"
#include "franken/reflection.h"

namespace franken {

/// `count` points, evenly over the unit square (Hammersley).
std::vector<glm::vec2> evenPoints(int count);

/// A microfacet's normal, distributed as GGX is, in a frame whose z is N (Walter et al., "Microfacet Models
/// for Refraction through Rough Surfaces", 2007, equations 35 and 36). alpha: roughness^2.
glm::vec3 microfacet(const glm::vec2& point, float alpha);

/// Height-correlated Smith shadowing over 4 N.L N.V, as glTF 2.0 has it.
float smithVisibility(float nDotL, float nDotV, float alpha);

/// A sky at several resolutions, to be looked up through lobes.
class SkyFilter {
public:
    /// One direction of a lobe, around +Z.
    struct Sample {
        glm::vec3 direction;
        float weight; ///< All of a lobe's make 1.
        int level;    ///< Whose texels are about as large as what the sample stands for.
    };

    explicit SkyFilter(const Environment& sky);

    /// What glTF's BRDF shows where N = V. roughness: above 0 to 1.
    std::vector<Sample> lobe(float roughness) const;

    /// What a white Lambert surface shows.
    std::vector<Sample> cosineLobe() const;

    /// Radiance through a lobe around a unit direction.
    glm::vec3 radiance(const std::vector<Sample>& lobe, const glm::vec3& direction) const;

private:
    /// density: of the samples around a direction, 1/sr, of `count` in all.
    int levelFor(float density, int count) const;

    std::vector<Environment> m_levels; ///< Cubes, each half as wide as the one before.
};

/// Calls row(0) to row(count - 1), on as many threads as there are cores; `progress` on this thread.
void forEachRow(int count, const std::function<void(int)>& row, const Progress& progress);

} // namespace franken
