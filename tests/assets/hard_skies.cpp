// SPDX-License-Identifier: MIT
#include "hard_skies.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "sky_sampling.h"

namespace franken::test {
namespace {

/// A rectangle one metre away in that direction; width and height: halves, metres.
bool inBox(const glm::vec3& d, const glm::vec3& towards, float width, float height) {
    const glm::vec3 z = glm::normalize(towards);
    const Frame frame(z, 0);
    const float along = glm::dot(d, z);
    return along > 0 && std::abs(glm::dot(d, frame.x)) < width * along &&
           std::abs(glm::dot(d, frame.y)) < height * along;
}

glm::vec3 softBoxes(const glm::vec3& d) {
    if (inBox(d, {0.7f, 0.4f, 0.5f}, 0.35f, 0.15f))
        return {9, 8, 7};
    if (inBox(d, {-0.8f, 0.2f, 0.3f}, 0.1f, 0.5f))
        return {6, 8, 11};
    return inBox(d, {0, 1, 0.1f}, 0.5f, 0.5f) ? glm::vec3(5) : glm::vec3(0.03f);
}

glm::vec3 suns(const glm::vec3& d) {
    const std::vector<glm::vec3> places = directions(6);
    const bool sun = std::any_of(places.begin(), places.end(),
                                 [&](const glm::vec3& place) { return glm::dot(d, place) > 0.999f; });
    return sun ? glm::vec3(300, 240, 160) : glm::vec3(0.2f, 0.25f, 0.4f);
}

glm::vec3 radiance(HardSky sky, const glm::vec3& d) {
    switch (sky) {
    case HardSky::SoftBoxes:
        return softBoxes(d);
    case HardSky::Lamp:
        return glm::dot(d, glm::normalize(glm::vec3(0.4f, 0.6f, 0.7f))) > 0.9994f ? glm::vec3(900, 800, 600)
                                                                                  : glm::vec3(0.05f);
    case HardSky::Half:
        return glm::vec3(d.x > 0 ? 1.0f : 0.0f);
    case HardSky::Gradient:
        return glm::mix(glm::vec3(0.3f, 0.2f, 0.1f), glm::vec3(0.3f, 0.6f, 1.2f), 0.5f + 0.5f * d.y);
    case HardSky::Suns:
        return suns(d);
    }
    return glm::vec3(0);
}

} // namespace

const char* toString(HardSky sky) {
    constexpr std::array kNames = {"soft_boxes", "lamp", "half", "gradient", "suns"};
    return kNames[static_cast<std::size_t>(sky)];
}

Environment makeHardSky(HardSky sky) {
    constexpr int kWidth = 256;
    Environment made{Environment::Layout::Equirect, kWidth, kWidth / 2, {}};
    for (int y = 0; y < made.height; ++y)
        for (int x = 0; x < kWidth; ++x)
            made.texels.push_back(radiance(sky, equirectDirection(kWidth, x, y)));
    expose(made, 0.5f);
    return made;
}

} // namespace franken::test
