// SPDX-License-Identifier: MIT
#include "franken/ray_through.h"

#include "checks.h"

#include <glm/ext/matrix_double2x2.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace franken {
namespace {

/// From clip space as the viewer sees it to that of the panel.
glm::dmat2 panelFromViewer(Rotation rotation) {
    const std::array<float, 16> turn = clipRotation(rotation);
    return {turn[0], turn[1], turn[4], turn[5]};
}

/// The point in the viewpoint's clip space: from the viewer's whole picture to the panel, into the area, and
/// back to what the viewer sees of it.
glm::dvec2 clipPoint(const DrawTarget& target, const glm::dvec2& point) {
    const glm::dvec2 panelSize(target.width, target.height);
    const glm::dvec2 size = swapsAxes(target.rotation) ? glm::dvec2(panelSize.y, panelSize.x) : panelSize;
    const glm::dmat2 turn = panelFromViewer(target.rotation);
    const glm::dvec2 seen(2 * point.x / size.x - 1, 1 - 2 * point.y / size.y);
    const glm::dvec2 pixel = 0.5 * (turn * seen + 1.0) * panelSize;
    const TargetArea area = areaOf(target);
    const glm::dvec2 inArea = (pixel - glm::dvec2(area.x, area.y)) / glm::dvec2(area.width, area.height);
    return glm::transpose(turn) * (2.0 * inArea - 1.0);
}

} // namespace

Result<Ray> rayThrough(const Viewpoint& viewpoint, const DrawTarget& target, double x, double y) {
    if (Result<void> checked = check(viewpoint); !checked)
        return checked.error();
    if (Result<void> checked = check(target); !checked)
        return checked.error();
    if (!std::isfinite(x) || !std::isfinite(y))
        return Error{"renderer.point", "x, y", "they must be finite", "pass another point"};
    // As seen from the eye, so that the inverse is exact wherever in the world the eye is.
    const glm::dmat4 fromEye = viewpoint.viewProjection * glm::translate(glm::dmat4(1.0), viewpoint.eye);
    const glm::dmat4 toEye = glm::inverse(fromEye);
    const glm::dvec2 clip = clipPoint(target, {x, y});
    const glm::dvec4 near = toEye * glm::dvec4(clip, -1, 1), far = toEye * glm::dvec4(clip, 1, 1);
    const glm::dvec3 begin = glm::dvec3(near) / near.w;
    const glm::dvec3 along = glm::dvec3(far) - far.w * begin; // Where the far plane is infinite, its w is 0.
    const double length = glm::length(along);
    if (!std::isfinite(length) || length == 0)
        return Error{"renderer.viewpoint", "viewProjection", "the matrix has no inverse",
                     "pass a viewpoint of viewpointOf()"};
    Ray ray{.origin = viewpoint.eye + begin, .direction = along / length};
    if (const double reach = length / far.w; far.w > 0 && std::isfinite(reach))
        ray.length = reach;
    return ray;
}

} // namespace franken
