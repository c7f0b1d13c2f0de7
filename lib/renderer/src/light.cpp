// SPDX-License-Identifier: MIT
#include "franken/light.h"

#include <cassert>

namespace franken {
namespace {

Float3 toFloat3(const glm::vec3& v) { return {v.x, v.y, v.z}; }

Sun toSun(const Light& light) {
    return {.direction = toFloat3(light.direction),
            .color = toFloat3(light.color),
            .illuminance = light.intensity};
}

PunctualLight toPunctualLight(const Light& light) {
    return {.position = {light.position.x, light.position.y, light.position.z},
            .direction = toFloat3(light.direction),
            .color = toFloat3(light.color),
            .intensity = light.intensity,
            .range = light.range,
            .spot = light.kind == Light::Kind::Spot,
            .innerCone = light.innerConeAngle,
            .outerCone = light.outerConeAngle};
}

void warnOfMore(const char* what, std::size_t left, const Log& log) {
    if (left > 0 && log)
        log(LogLevel::Warning, "the scene has more than " + std::to_string(Permutation::kMaxLights) + " " +
                                   what + ": the last " + std::to_string(left) + " are left out");
}

} // namespace

Lighting lightingOf(const Scene& scene, const Log& log) {
    constexpr std::size_t kMost = Permutation::kMaxLights;
    Lighting lighting;
    std::size_t moreSuns = 0, morePunctual = 0;
    for (const Light& light : scene.lights) {
        if (light.kind == Light::Kind::Directional)
            lighting.suns.size() < kMost ? lighting.suns.push_back(toSun(light)) : void(++moreSuns);
        else
            lighting.punctualLights.size() < kMost ? lighting.punctualLights.push_back(toPunctualLight(light))
                                                   : void(++morePunctual);
    }
    warnOfMore("suns", moreSuns, log);
    warnOfMore("punctual lights", morePunctual, log);
    return lighting;
}

LightsBlock packLighting(const Lighting& lighting, const glm::dvec3& eye) {
    assert(lighting.suns.size() <= Permutation::kMaxLights &&
           lighting.punctualLights.size() <= Permutation::kMaxLights);
    LightsBlock block{};
    packAmbient(block, lighting.ambientColor, lighting.exposure);
    packSky(block, lighting.sky, lighting.exposure);
    for (std::size_t i = 0; i < lighting.suns.size(); ++i)
        packSun(block, i, lighting.suns[i], lighting.exposure);
    for (std::size_t i = 0; i < lighting.punctualLights.size(); ++i)
        packPunctualLight(block, i, lighting.punctualLights[i], {eye.x, eye.y, eye.z}, lighting.exposure);
    return block;
}

} // namespace franken
