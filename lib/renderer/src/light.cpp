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

Lamp toLamp(const Light& light) {
    return {.position = toFloat3(light.position),
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
    std::size_t moreSuns = 0, moreLamps = 0;
    for (const Light& light : scene.lights) {
        if (light.kind == Light::Kind::Directional)
            lighting.suns.size() < kMost ? lighting.suns.push_back(toSun(light)) : void(++moreSuns);
        else
            lighting.lamps.size() < kMost ? lighting.lamps.push_back(toLamp(light)) : void(++moreLamps);
    }
    warnOfMore("suns", moreSuns, log);
    warnOfMore("lamps", moreLamps, log);
    return lighting;
}

LightsBlock packLighting(const Lighting& lighting, const Float3& eye) {
    assert(lighting.suns.size() <= Permutation::kMaxLights &&
           lighting.lamps.size() <= Permutation::kMaxLights);
    LightsBlock block{};
    packAmbient(block, lighting.ambientColor, lighting.exposure);
    packSky(block, lighting.sky, lighting.exposure);
    for (std::size_t i = 0; i < lighting.suns.size(); ++i)
        packSun(block, i, lighting.suns[i], lighting.exposure);
    for (std::size_t i = 0; i < lighting.lamps.size(); ++i)
        packLamp(block, i, lighting.lamps[i], eye, lighting.exposure);
    return block;
}

} // namespace franken
