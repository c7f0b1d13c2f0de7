// SPDX-License-Identifier: MIT
#include "franken/viewpoint.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace franken {
namespace {

/// Half the width and height of what is seen, at distance 1 (perspective) or anywhere (orthographic).
struct Extent {
    double x, y;
};

Extent fitted(Extent extent, double aspect) {
    return extent.x / extent.y > aspect ? Extent{extent.x, extent.x / aspect}
                                        : Extent{extent.y * aspect, extent.y};
}

Extent extentOf(const Camera& camera, double aspect) {
    if (camera.projection == Camera::Projection::Orthographic)
        return fitted({std::abs(camera.xmag), std::abs(camera.ymag)}, aspect);
    const double y = std::tan(0.5 * camera.yfov);
    return fitted({y * (camera.aspectRatio > 0 ? camera.aspectRatio : aspect), y}, aspect);
}

// glTF 2.0, 3.10.3: the same matrices as gluPerspective's and glOrtho's, and their limit at infinity.
glm::dmat4 perspective(Extent extent, double near, double far) {
    glm::dmat4 m(0.0);
    m[0][0] = 1 / extent.x;
    m[1][1] = 1 / extent.y;
    m[2][2] = far > 0 ? (far + near) / (near - far) : -1;
    m[2][3] = -1;
    m[3][2] = far > 0 ? 2 * far * near / (near - far) : -2 * near;
    return m;
}

glm::dmat4 orthographic(Extent extent, double near, double far) {
    glm::dmat4 m(1.0);
    m[0][0] = 1 / extent.x;
    m[1][1] = 1 / extent.y;
    m[2][2] = 2 / (near - far);
    m[3][2] = (far + near) / (near - far);
    return m;
}

// glTF 2.0, 3.10.2: the scale of a camera's node is ignored. Where a scale is negative, which axis it turned
// round cannot be told any more; what the camera looks at and what is above stay as they are.
glm::dmat4 placeOf(const Camera& camera) {
    glm::dmat4 world(camera.world);
    for (int axis = 0; axis < 3; ++axis)
        world[axis] = glm::dvec4(glm::normalize(glm::dvec3(world[axis])), 0);
    if (glm::determinant(glm::dmat3(world)) < 0)
        world[0] = -world[0];
    return world;
}

// An orthographic camera's view vectors are parallel. Programs subtract positions from the eye, so the eye
// moves back until what is left of the angle between two of them is below what 8 bits show: half a lobe of
// roughness 0.05. Not further, because the vectors from punctual lights come from the same subtraction, and
// floats have 24 bits.
glm::dvec3 distantEye(const glm::dmat4& world, Extent extent) {
    constexpr double kDistance = 4096; // Times what is seen.
    return glm::dvec3(world[3]) + kDistance * std::hypot(extent.x, extent.y) * glm::dvec3(world[2]);
}

} // namespace

Viewpoint viewpointOf(const Camera& camera, double aspect) {
    const Extent extent = extentOf(camera, aspect);
    const glm::dmat4 world = placeOf(camera);
    const bool flat = camera.projection == Camera::Projection::Orthographic;
    const glm::dmat4 projection = flat ? orthographic(extent, camera.znear, camera.zfar)
                                       : perspective(extent, camera.znear, camera.zfar);

    Viewpoint viewpoint;
    viewpoint.viewProjection = projection * glm::inverse(world);
    viewpoint.eye = flat ? distantEye(world, extent) : glm::dvec3(world[3]);
    viewpoint.forward = -glm::dvec3(world[2]);
    const glm::dmat3 rotation(world);
    viewpoint.clipToSky = flat
                              ? glm::dmat3(glm::dvec3(0), glm::dvec3(0), viewpoint.forward)
                              : glm::dmat3(rotation[0] * extent.x, rotation[1] * extent.y, viewpoint.forward);
    return viewpoint;
}

Viewpoint turned(const Viewpoint& viewpoint, Rotation rotation) {
    if (rotation == Rotation::None)
        return viewpoint;
    const std::array<float, 16> values = clipRotation(rotation);
    const glm::dmat4 turn(glm::make_mat4(values.data()));
    Viewpoint result = viewpoint;
    result.viewProjection = turn * viewpoint.viewProjection;
    result.clipToSky = viewpoint.clipToSky * glm::transpose(glm::dmat3(turn));
    return result;
}

Camera framingCamera(const Box& bounds, double aspect) {
    Camera camera;
    if (bounds.empty())
        return camera;
    const glm::dvec3 center = 0.5 * (bounds.min + bounds.max);
    const double radius = std::max(0.5 * glm::distance(bounds.min, bounds.max), 1e-6);
    const double halfAngle = std::atan(std::tan(0.5 * camera.yfov) * std::min(aspect, 1.0));
    const double distance = radius / std::sin(halfAngle);
    const glm::dvec3 eye = center + distance * glm::normalize(glm::dvec3(0.35, 0.25, 1.0));
    camera.world = glm::inverse(glm::lookAt(eye, center, glm::dvec3(0, 1, 0)));
    camera.znear = static_cast<float>(std::max(distance - 2 * radius, 0.05 * radius));
    camera.zfar = static_cast<float>(distance + 2 * radius);
    return camera;
}

Camera tightened(const Camera& camera, const Box& bounds) {
    if (bounds.empty())
        return camera;
    const glm::dmat4 world = placeOf(camera);
    const glm::dvec3 center = 0.5 * (bounds.min + bounds.max);
    const double radius = 0.5 * glm::distance(bounds.min, bounds.max);
    const double depth = -glm::dot(center - glm::dvec3(world[3]), glm::dvec3(world[2]));
    constexpr double kMargin = 1.001;
    const double nearest = depth - kMargin * radius;
    const double farthest = depth + kMargin * radius;
    Camera tight = camera;
    tight.znear = static_cast<float>(std::max<double>(camera.znear, nearest));
    const bool infinite = camera.zfar == 0 && camera.projection == Camera::Projection::Perspective;
    const double limit = infinite ? farthest : std::min<double>(camera.zfar, farthest);
    tight.zfar = static_cast<float>(limit);
    return tight.zfar > tight.znear ? tight : camera;
}

} // namespace franken
