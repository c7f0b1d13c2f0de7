// SPDX-License-Identifier: MIT
#include "franken/orbit_camera.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace franken {
namespace {

constexpr double kRadiansPerHeight = std::numbers::pi;

Error refused(const char* where, const char* what) {
    return {"renderer.orbit", where, what, "pass another number; the camera stays as it was"};
}

bool isFinite(const glm::dvec3& vector) {
    return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

/// From the target to the camera; unit.
glm::dvec3 backOf(const Orbit& orbit) {
    return {std::sin(orbit.yaw) * std::cos(orbit.pitch), std::sin(orbit.pitch),
            std::cos(orbit.yaw) * std::cos(orbit.pitch)};
}

/// Where the camera stands, and round what it goes from there.
Orbit orbitOf(const Camera& camera, const Box& bounds) {
    const glm::dvec3 eye(camera.world[3]), back = glm::normalize(glm::dvec3(camera.world[2]));
    const glm::dvec3 center = bounds.empty() ? eye - back : 0.5 * (bounds.min + bounds.max);
    const double radius = bounds.empty() ? 1 : 0.5 * glm::distance(bounds.min, bounds.max);
    const double least = radius > 0 ? 0.1 * radius : 1;
    const double distance = std::max(glm::dot(eye - center, back), least);
    return {.target = eye - distance * back,
            .yaw = std::atan2(back.x, back.z),
            .pitch = std::asin(std::clamp(back.y, -1.0, 1.0)),
            .distance = distance};
}

/// Closer to the goal by that share of the way; distances by their logarithm, as they are seen.
Orbit between(const Orbit& from, const Orbit& goal, double share) {
    return {.target = glm::mix(from.target, goal.target, share),
            .yaw = std::lerp(from.yaw, goal.yaw, share),
            .pitch = std::lerp(from.pitch, goal.pitch, share),
            .distance = from.distance * std::pow(goal.distance / from.distance, share)};
}

/// So close that no picture shows the difference.
bool hasArrived(const Orbit& from, const Orbit& goal) {
    constexpr double kUnseen = 1e-5; // A twentieth of a pixel of 4,000, in heights of the picture.
    return glm::distance(from.target, goal.target) < kUnseen * goal.distance &&
           std::abs(from.yaw - goal.yaw) < kUnseen && std::abs(from.pitch - goal.pitch) < kUnseen &&
           std::abs(from.distance - goal.distance) < kUnseen * goal.distance;
}

bool isRange(double least, double most) { return least <= most; } // Not of what is no number.

} // namespace

OrbitCamera::OrbitCamera(const Camera& camera, const Box& bounds)
    : m_lens(camera),
      m_lensDistance(orbitOf(camera, bounds).distance),
      m_goal(orbitOf(camera, bounds)),
      m_current(m_goal) {}

Result<void> OrbitCamera::setLimits(const OrbitLimits& limits) {
    constexpr const char* kOrder = "the least must not be above the greatest";
    if (!isRange(limits.minYaw, limits.maxYaw))
        return refused("minYaw, maxYaw", kOrder);
    if (!isRange(limits.minPitch, limits.maxPitch) || limits.minPitch < -std::numbers::pi / 2 ||
        limits.maxPitch > std::numbers::pi / 2)
        return refused("minPitch, maxPitch", "they must be -pi/2 to pi/2, the least first");
    if (!isRange(limits.minDistance, limits.maxDistance) || limits.minDistance <= 0 ||
        !std::isfinite(limits.maxDistance))
        return refused("minDistance, maxDistance", "they must be above 0 and finite, the least first");
    const Box& box = limits.targets;
    if (!box.empty() &&
        !(isFinite(box.min) && isFinite(box.max) && box.min.y <= box.max.y && box.min.z <= box.max.z))
        return refused("targets", "the box must be finite, or empty");
    m_limits = limits;
    const Orbit now = limited(m_current);
    m_changed = m_changed || !hasArrived(now, m_current);
    m_current = now;
    ask(m_goal);
    return {};
}

Result<void> OrbitCamera::setDamping(double seconds) {
    if (!(std::isfinite(seconds) && seconds >= 0))
        return refused("setDamping()", "the time must be finite, and 0 or more");
    m_damping = seconds;
    return {};
}

Orbit OrbitCamera::limited(Orbit orbit) const {
    orbit.yaw = std::clamp(orbit.yaw, m_limits.minYaw, m_limits.maxYaw);
    orbit.pitch = std::clamp(orbit.pitch, m_limits.minPitch, m_limits.maxPitch);
    orbit.distance = std::clamp(orbit.distance, m_limits.minDistance, m_limits.maxDistance);
    if (!m_limits.targets.empty())
        orbit.target = glm::clamp(orbit.target, m_limits.targets.min, m_limits.targets.max);
    return orbit;
}

void OrbitCamera::ask(const Orbit& orbit) { m_goal = limited(orbit); }

Result<void> OrbitCamera::drag(double x, double y) {
    Orbit orbit = m_goal;
    orbit.yaw -= kRadiansPerHeight * x;
    orbit.pitch += kRadiansPerHeight * y;
    if (!std::isfinite(orbit.yaw) || !std::isfinite(orbit.pitch))
        return refused("drag()", "the way must be finite");
    ask(orbit);
    return {};
}

Result<void> OrbitCamera::zoom(double factor) {
    if (!(std::isfinite(factor) && factor > 0))
        return refused("zoom()", "the factor must be finite, and above 0");
    Orbit orbit = m_goal;
    orbit.distance *= factor;
    ask(orbit);
    return {};
}

Result<void> OrbitCamera::moveTo(const Orbit& orbit) {
    if (!isFinite(orbit.target) || !std::isfinite(orbit.yaw) || !std::isfinite(orbit.pitch))
        return refused("target, yaw, pitch", "they must be finite");
    if (!(std::isfinite(orbit.distance) && orbit.distance > 0))
        return refused("distance", "it must be finite, and above 0");
    ask(orbit);
    return {};
}

Result<bool> OrbitCamera::advance(double seconds) {
    if (!(std::isfinite(seconds) && seconds >= 0))
        return refused("advance()", "the time must be finite, and 0 or more");
    const bool changed = m_changed;
    m_changed = false;
    const bool wasThere = hasArrived(m_current, m_goal);
    if (!wasThere && m_damping > 0)
        m_current = between(m_current, m_goal, -std::expm1(-seconds / m_damping));
    if (m_damping == 0 || hasArrived(m_current, m_goal))
        m_current = m_goal;
    return changed || !wasThere;
}

Camera OrbitCamera::camera() const {
    const bool flat = m_lens.projection == Camera::Projection::Orthographic;
    const glm::dvec3 back = backOf(m_current);
    const glm::dvec3 right(std::cos(m_current.yaw), 0, -std::sin(m_current.yaw));
    // An orthographic camera sees the same from everywhere on its line of sight.
    const glm::dvec3 eye = m_current.target + (flat ? m_lensDistance : m_current.distance) * back;
    Camera camera = m_lens;
    camera.world = glm::dmat4(glm::dvec4(right, 0), glm::dvec4(glm::cross(back, right), 0),
                              glm::dvec4(back, 0), glm::dvec4(eye, 1));
    const auto scale = static_cast<float>(m_current.distance / m_lensDistance);
    if (flat) {
        camera.xmag *= scale;
        camera.ymag *= scale;
    } else {
        camera.znear = std::min(m_lens.znear, static_cast<float>(1e-3 * m_current.distance));
        camera.zfar = 0;
    }
    return camera;
}

} // namespace franken
