// SPDX-License-Identifier: MIT
#include "franken/light.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

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

constexpr std::size_t kMost = Permutation::kMaxLights;

glm::dvec3 toVector(const Float3& v) { return {v[0], v[1], v[2]}; }

Float3 toFloat3(const glm::dvec3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

glm::dvec3 directionOf(const Sun& sun) {
    const glm::dvec3 direction = toVector(sun.direction);
    const double length = glm::length(direction);
    return length > 0 ? direction / length : glm::dvec3(0, -1, 0);
}

/// Of a light's channels, the one that counts for how strong it is.
double brightest(const Float3& color) { return std::max({color[0], color[1], color[2]}); }

/// One sun in place of two. Opposite suns of equal strength have no mean: the first one's direction is kept.
Sun merged(const Sun& a, const Sun& b) {
    const glm::dvec3 first = toVector(a.color) * double{a.illuminance};
    const glm::dvec3 second = toVector(b.color) * double{b.illuminance};
    const double ofFirst = brightest(toFloat3(first)), ofSecond = brightest(toFloat3(second));
    const glm::dvec3 mean = directionOf(a) * ofFirst + directionOf(b) * ofSecond;
    constexpr double kNoDirection = 1e-9;
    const bool hasMean = glm::length(mean) > kNoDirection * (ofFirst + ofSecond);
    return {.direction = toFloat3(hasMean ? glm::normalize(mean) : directionOf(a)),
            .color = toFloat3(first + second),
            .illuminance = 1};
}

void mergeNearest(std::vector<Sun>& suns) {
    std::size_t first = 0, second = 1;
    double nearest = -2;
    for (std::size_t i = 0; i < suns.size(); ++i)
        for (std::size_t j = i + 1; j < suns.size(); ++j)
            if (const double cosine = glm::dot(directionOf(suns[i]), directionOf(suns[j]));
                cosine > nearest) {
                nearest = cosine;
                first = i;
                second = j;
            }
    suns[first] = merged(suns[first], suns[second]);
    suns.erase(suns.begin() + static_cast<std::ptrdiff_t>(second));
}

void keepStrongest(std::vector<PunctualLight>& lights) {
    const auto strength = [](const PunctualLight& light) { return brightest(light.color) * light.intensity; };
    while (lights.size() > kMost)
        lights.erase(std::min_element(lights.begin(), lights.end(), [&](const auto& a, const auto& b) {
            return strength(a) < strength(b);
        }));
}

/// With all directions in the world, where the sky's rotation no longer counts for them.
Sun inWorld(Sun sun, const glm::dmat3& worldFromSky) {
    if (sun.ofSky)
        sun.direction = toFloat3(worldFromSky * toVector(sun.direction));
    sun.ofSky = false;
    return sun;
}

Sun inSky(Sun sun, const glm::dmat3& skyFromWorld) {
    if (!sun.ofSky)
        sun.direction = toFloat3(skyFromWorld * toVector(sun.direction));
    return sun;
}

/// From the eye.
PunctualLight inSky(PunctualLight light, const glm::dvec3& eye, const glm::dmat3& skyFromWorld) {
    const glm::dvec3 position =
        skyFromWorld * (glm::dvec3(light.position[0], light.position[1], light.position[2]) - eye);
    light.position = {position.x, position.y, position.z};
    light.direction = toFloat3(skyFromWorld * toVector(light.direction));
    return light;
}

} // namespace

glm::dmat3 skyFromWorld(const Lighting& lighting) {
    const glm::dquat& rotation = lighting.skyRotation;
    if (rotation == glm::dquat(1, 0, 0, 0))
        return glm::dmat3(1.0);
    return glm::transpose(glm::mat3_cast(glm::normalize(rotation)));
}

Lighting fittedLighting(Lighting lighting) {
    if (lighting.suns.size() > kMost)
        for (Sun& sun : lighting.suns)
            sun = inWorld(sun, glm::transpose(skyFromWorld(lighting)));
    while (lighting.suns.size() > kMost)
        mergeNearest(lighting.suns);
    keepStrongest(lighting.punctualLights);
    return lighting;
}

std::string fittingOf(const Lighting& lighting) {
    const auto text = [](std::size_t count, const char* kind, const char* rule) {
        return "there are " + std::to_string(count) + " " + kind + ", and a program takes " +
               std::to_string(kMost) + ": " + rule;
    };
    if (lighting.suns.size() > kMost)
        return text(lighting.suns.size(), "suns", "those nearest in direction become one");
    if (lighting.punctualLights.size() > kMost)
        return text(lighting.punctualLights.size(), "punctual lights", "the strongest remain");
    return {};
}

Lighting lightingOf(const Scene& scene, const Log& log) {
    Lighting lighting;
    for (const Light& light : scene.lights)
        if (light.kind == Light::Kind::Directional)
            lighting.suns.push_back(toSun(light));
        else
            lighting.punctualLights.push_back(toPunctualLight(light));
    if (const std::string fitting = fittingOf(lighting); log && !fitting.empty())
        log(LogLevel::Warning, fitting);
    return fittedLighting(std::move(lighting));
}

LightsBlock packLighting(const Lighting& lighting, const glm::dvec3& eye) {
    if (lighting.suns.size() > kMost || lighting.punctualLights.size() > kMost)
        return packLighting(fittedLighting(lighting), eye);
    LightsBlock block{};
    block.ambient = packAmbient(lighting.ambient, lighting.exposure);
    const glm::dmat3 toSky = skyFromWorld(lighting);
    for (std::size_t i = 0; i < lighting.suns.size(); ++i)
        packSun(block, i, inSky(lighting.suns[i], toSky), lighting.exposure);
    for (std::size_t i = 0; i < lighting.punctualLights.size(); ++i)
        packPunctualLight(block, i, inSky(lighting.punctualLights[i], eye, toSky), {0, 0, 0},
                          lighting.exposure);
    return block;
}

} // namespace franken
