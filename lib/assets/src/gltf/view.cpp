// SPDX-License-Identifier: MIT
#include <cmath>

#include <glm/common.hpp>
#include <glm/ext/scalar_constants.hpp>

#include "gltf/internal.h"

namespace franken::gltf {

bool readCamera(Source& source, int index, Camera& camera) {
    const tinygltf::Camera& from = source.model.cameras[at(index)];
    const tinygltf::PerspectiveCamera& perspective = from.perspective;
    const tinygltf::OrthographicCamera& orthographic = from.orthographic;
    const bool isPerspective = from.type == "perspective"; // tinygltf knows no third type
    camera.name = from.name;
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

bool isKnownLight(Source& source, int index) {
    const std::string& type = source.model.lights[at(index)].type;
    if (type == "directional" || type == "point" || type == "spot")
        return true;
    source.warn(pathOf("extensions/KHR_lights_punctual/lights", index),
                "a light of type " + type + " is not known: left out");
    return false;
}

bool readLight(Source& source, int index, Light& light) {
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
    const float sum = light.color.x + light.color.y + light.color.z + light.intensity + light.range;
    if (!std::isfinite(sum) || least < 0.0f || light.intensity < 0.0f || light.range < 0.0f)
        return fail("a light's colour, intensity or range is negative or not finite");
    const float widest = 0.5f * glm::pi<float>() * 1.0001f; // exporters round
    if (light.innerConeAngle < 0.0f || !(light.innerConeAngle < light.outerConeAngle) ||
        light.outerConeAngle > widest)
        return fail("a spot's cones are 0 <= inner < outer <= pi/2");
    return true;
}

} // namespace franken::gltf
