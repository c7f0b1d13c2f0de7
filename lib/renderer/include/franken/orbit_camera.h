// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/result.h"
#include "franken/scene.h"

#include <limits>
#include <numbers>

namespace FRANKEN_API franken {

/// Where a camera stands that looks at a point.
struct Orbit {
    glm::dvec3 target{0.0}; ///< World space, m.
    double yaw = 0;         ///< Radians; 0 looks along -Z, growing ones are reached to the right (+X).
    double pitch = 0;       ///< Radians above the horizon, -pi/2 to pi/2.
    double distance = 1;    ///< m, > 0.
};

/// Which orbits are reached; each least value must not be above the greatest one.
struct OrbitLimits {
    /// Radians.
    double minYaw = -std::numeric_limits<double>::infinity();
    double maxYaw = std::numeric_limits<double>::infinity();
    double minPitch = -std::numbers::pi / 2, maxPitch = std::numbers::pi / 2; ///< At most these.
    /// m, > 0.
    double minDistance = 1e-6, maxDistance = 1e9; ///< m, > 0.
    Box targets = {};                             ///< Empty: all of space.
};

/// A camera that goes round a point, as fingers and a mouse drag it: what they ask for is reached by and by,
/// the rest of the way shrinking by a factor of e in each time constant, whatever the length of the frames.
///
///     camera.drag(movedX / height, movedY / height);      // at each event
///     if (camera.advance(secondsSinceTheLastFrame))       // in each frame
///         renderer.draw(viewpointOf(tightened(camera.camera(), bounds), aspect), target);
///
/// Each call costs some arithmetic. Those that return a Result fail with "renderer.orbit" for numbers that
/// are not finite or out of their range, and change nothing then. No GL; use it on one thread at a time.
class OrbitCamera {
public:
    /// At rest where `camera` stands. Its lens is kept, its roll is not. It goes round the point of its line
    /// of sight that is closest to the centre of the box (which lies at least a tenth of the box's radius
    /// ahead). A perspective camera shows everything from a thousandth of the distance on: tightened()
    /// brings the planes in.
    OrbitCamera(const Camera& camera, const Box& bounds);

    /// Holds from the next move on; limits must not be crossed.
    Result<void> setLimits(const OrbitLimits& limits);
    /// The time constant, in seconds; 0 or more. 0 at first: all is reached at once.
    Result<void> setDamping(double seconds);

    /// What was dragged, to the right and down, in heights of the picture: one height is half a turn. The
    /// scene follows the finger.
    Result<void> drag(double x, double y);
    /// Multiplies the distance (the height of view, for an orthographic camera); > 0, below 1 to come closer.
    Result<void> zoom(double factor);
    /// Asks for another orbit, within the limits.
    Result<void> moveTo(const Orbit& orbit);

    /// Goes on by a frame's time, in seconds; 0 or more. Whether the picture has changed since the last call.
    Result<bool> advance(double seconds);

    const Orbit& orbit() const { return m_current; } ///< As it is now.
    const Orbit& goal() const { return m_goal; }     ///< What was asked for.
    Camera camera() const;                           ///< As it is now.

private:
    Orbit limited(Orbit orbit) const;
    void ask(const Orbit& orbit);

    Camera m_lens;
    double m_lensDistance; ///< Where its height of view is the lens's.
    OrbitLimits m_limits;
    double m_damping = 0;
    Orbit m_goal, m_current;
    bool m_changed = true;
};

} // namespace franken
