// SPDX-License-Identifier: MIT
#include <cmath>

#include <glm/common.hpp>
#include <glm/ext/scalar_constants.hpp>

#include "gltf/node.h"

namespace franken::gltf {

bool readCamera(Document& source, int index, Camera& camera) {
    const tinygltf::Camera& from = source.model.cameras[at(index)];
    const tinygltf::PerspectiveCamera& perspective = from.perspective;
    const tinygltf::OrthographicCamera& orthographic = from.orthographic;
    const bool isPerspective = from.type == "perspective"; // tinygltf knows no third type
    camera.name = from.name;
    camera.index = index;
    camera.projection = isPerspective ? Camera::Projection::Perspective : Camera::Projection::Orthographic;
    camera.yfov = static_cast<float>(perspective.yfov);
    camera.aspectRatio = static_cast<float>(perspective.aspectRatio);
    camera.xmag = static_cast<float>(std::fabs(orthographic.xmag));
    camera.ymag = static_cast<float>(std::fabs(orthographic.ymag));
    camera.znear = static_cast<float>(isPerspective ? perspective.znear : orthographic.znear);
    camera.zfar = static_cast<float>(isPerspective ? perspective.zfar : orthographic.zfar);

    const float pi = glm::pi<float>();
    const bool lens = isPerspective ? camera.yfov > 0.0f && camera.yfov < pi && camera.aspectRatio >= 0.0f
                                    : camera.xmag > 0.0f && camera.ymag > 0.0f;
    const bool depth = isPerspective
                           ? camera.znear > 0.0f && (camera.zfar == 0.0f || camera.zfar > camera.znear)
                           : camera.znear >= 0.0f && camera.zfar > camera.znear;
    const bool finite = std::isfinite(camera.aspectRatio) && std::isfinite(camera.xmag) &&
                        std::isfinite(camera.ymag) && std::isfinite(camera.zfar);
    return (lens && depth && finite) ||
           source.fail("gltf.value", pathOf("cameras", index), "the camera's numbers make no projection");
}

bool isKnownLight(Document& source, int index) {
    const std::string& type = source.model.lights[at(index)].type;
    if (type == "directional" || type == "point" || type == "spot")
        return true;
    source.warn(kLeftOut, pathOf("extensions/KHR_lights_punctual/lights", index),
                "a light of type " + type + " is not known: left out");
    return false;
}

namespace {

// Cones that are no cones have one meaning: the narrowest or the widest that there is; where no light is left
// between them, the edge is sharp.
void mendCones(const Document& source, const std::string& where, Light& light) {
    constexpr float kRounding = 1.0001f; // of exporters
    const float widest = 0.5f * glm::pi<float>(), inner = light.innerConeAngle, outer = light.outerConeAngle;
    if (!(inner >= 0.0f && inner < outer && outer <= widest * kRounding))
        source.warn(kMended, where, "a spot's cones are 0 <= inner < outer <= pi/2");
    light.outerConeAngle = glm::clamp(outer, 0.0f, widest);
    light.innerConeAngle = glm::clamp(inner, 0.0f, light.outerConeAngle);
}

} // namespace

bool readLight(Document& source, int index, Light& light) {
    const tinygltf::Light& from = source.model.lights[at(index)];
    const std::string where = pathOf("extensions/KHR_lights_punctual/lights", index);
    const auto fail = [&](const char* what) { return source.fail("gltf.value", where, what); };
    light.name = from.name;
    if (from.type == "point")
        light.kind = Light::Kind::Point;
    else if (from.type == "spot")
        light.kind = Light::Kind::Spot;
    if (!from.color.empty() && from.color.size() != 3)
        return fail("a light's colour is three numbers");
    for (int i = 0; i < 3 && !from.color.empty(); ++i)
        light.color[i] = static_cast<float>(from.color[at(i)]);
    light.intensity = static_cast<float>(from.intensity);
    light.range = static_cast<float>(from.range);
    light.innerConeAngle = static_cast<float>(from.spot.innerConeAngle);
    light.outerConeAngle = static_cast<float>(from.spot.outerConeAngle);
    const float least = std::fmin(std::fmin(light.color.x, light.color.y), light.color.z);
    const float sum = light.color.x + light.color.y + light.color.z + light.intensity + light.range +
                      light.innerConeAngle + light.outerConeAngle;
    if (!std::isfinite(sum) || least < 0.0f || light.intensity < 0.0f)
        return fail("a light's colour, intensity or range is not finite, or one of the first two negative");
    if (light.range < 0.0f) {
        source.warn(kMended, where + "/range", "a range is above 0: without one it is infinite");
        light.range = 0.0f;
    }
    if (light.kind == Light::Kind::Spot)
        mendCones(source, where + "/spot", light);
    return true;
}

} // namespace franken::gltf
