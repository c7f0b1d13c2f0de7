// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/rotation.h"
#include "franken/scene.h"

#include <glm/ext/matrix_double3x3.hpp>
#include <glm/ext/matrix_double4x4.hpp>
#include <glm/ext/vector_double3.hpp>

namespace FRANKEN_API franken {

/// A camera in front of a target of a certain shape. In double precision: a matrix is rounded to float once,
/// when it is complete.
struct Viewpoint {
    glm::dmat4 viewProjection{1.0}; ///< World space to GL's clip space.
    glm::dvec3 eye{0.0}; ///< World space, m. For an orthographic camera: so far behind it that all of its
                         ///< lines of sight are parallel.
    glm::dvec3 forward{0, 0, -1}; ///< World space, unit.
    glm::dmat3 clipToSky{1.0};    ///< (x, y, 1) in clip space to a direction in world space.

    friend bool operator==(const Viewpoint&, const Viewpoint&) = default;
};

/// `aspect` is the target's width over its height. Nothing is stretched: where the camera has an aspect ratio
/// of its own and the target is narrower, the angle of view (the height of view, for an orthographic camera)
/// grows until everything that the camera sees fits in. Scale and mirroring in the camera's `world` are
/// ignored (glTF 2.0, 3.10.2): the camera looks along -Z with +Y up, and +X is always on its right.
Viewpoint viewpointOf(const Camera& camera, double aspect);

/// As it is drawn on a panel that is mounted like that, so that its viewer sees what the viewpoint shows. The
/// renderer turns by DrawTarget::rotation; this is for others that draw along.
Viewpoint turned(const Viewpoint& viewpoint, Rotation rotation);

/// A perspective camera that shows all of the box, from the front, a little from the right and above.
/// For an empty box: at the origin.
Camera framingCamera(const Box& bounds, double aspect);

/// The camera with its clipping planes brought in as far as they show all of the box that they showed: a
/// depth buffer has 24 bits, or 16, and files are generous (0.05 m to 1000 km). For an empty box: as it was.
Camera tightened(const Camera& camera, const Box& bounds);

} // namespace franken
