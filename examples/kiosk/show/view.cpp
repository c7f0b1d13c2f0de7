// SPDX-License-Identifier: MIT
#include "kiosk/show/view.h"

#include "franken/viewpoint.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace kiosk {

using franken::Box;
using franken::Camera;

namespace {

constexpr double kDamping = 0.12; // Seconds.

franken::OrbitCamera orbitAround(const Box& bounds, double aspect) {
    franken::OrbitCamera orbit(franken::framingCamera(bounds, aspect), bounds);
    const franken::Orbit& start = orbit.orbit();
    const franken::OrbitLimits limits{.minPitch = -0.3,
                                      .maxPitch = 1.4,
                                      .minDistance = 0.3 * start.distance,
                                      .maxDistance = 2 * start.distance};
    [[maybe_unused]] const bool isSet = orbit.setLimits(limits) && orbit.setDamping(kDamping);
    return orbit;
}

} // namespace

View::View(franken::Scene still, const Box& bounds, double aspect, const Config& config)
    : m_still(std::move(still)), m_bounds(bounds), m_orbit(orbitAround(bounds, aspect)) {
    configure(config);
    advance(0);
}

void View::configure(const Config& config) {
    m_turnSeconds = config.show.turnSeconds;
    m_animations = config.show.animations;
    const bool wantsFile = config.show.camera == "file";
    if (std::exchange(m_wantsFile, wantsFile) == wantsFile)
        return;
    m_camera = wantsFile && !m_still.cameras.empty() ? 0 : franken::kNone;
    m_settling = true;
}

void View::setAspect(double aspect) {
    const franken::Orbit orbit = m_orbit.goal();
    m_orbit = orbitAround(m_bounds, aspect);
    franken::Orbit turned = m_orbit.goal();
    turned.yaw = orbit.yaw;
    turned.pitch = orbit.pitch;
    [[maybe_unused]] const auto moved = m_orbit.moveTo(turned);
}

void View::advance(double seconds) {
    if (!m_paused) {
        if (m_turnSeconds > 0 && m_camera == franken::kNone) {
            franken::Orbit goal = m_orbit.goal();
            goal.yaw += 2 * std::numbers::pi * seconds / m_turnSeconds;
            [[maybe_unused]] const auto moved = m_orbit.moveTo(goal);
        }
    }
    m_settling = m_orbit.advance(seconds).value();
    m_isPosed = playsAnimation();
    if (m_isPosed)
        m_player.advance(m_still, m_paused ? 0 : seconds);
}

bool View::moves() const {
    const bool turns = m_turnSeconds > 0 && m_camera == franken::kNone;
    return m_settling || (!m_paused && (turns || playsAnimation()));
}

Camera View::camera() const {
    if (m_camera == franken::kNone)
        return franken::tightened(m_orbit.camera(), m_bounds);
    Camera camera = m_still.cameras[static_cast<std::size_t>(m_camera)];
    if (m_isPosed) {
        std::vector<franken::NodeWorld> worlds;
        franken::worldsOf(m_still, m_player.pose(), worlds);
        franken::follow(worlds, camera);
    }
    return camera;
}

void View::nextCamera() {
    const int count = static_cast<int>(m_still.cameras.size());
    m_camera = m_camera + 1 < count ? m_camera + 1 : franken::kNone;
    m_settling = true;
}

void View::drag(double x, double y) {
    [[maybe_unused]] const auto dragged = m_orbit.drag(x, y);
    m_settling = true;
}

void View::zoom(double factor) {
    [[maybe_unused]] const auto zoomed = m_orbit.zoom(factor);
    m_settling = true;
}

} // namespace kiosk
