// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/draw_target.h"
#include "franken/pick.h"
#include "franken/viewpoint.h"

namespace FRANKEN_API franken {

/// The ray through a point of a picture that is drawn from that viewpoint to that target: from the near to
/// the far clipping plane, because nothing else is drawn. x to the right and y down are pixels from the upper
/// left corner of the whole target as its viewer sees it, which is how touches and pointers are reported;
/// pixel centres have halves. The target's area and rotation are accounted for; a point outside the area
/// gives a ray past what is seen.
///
/// Costs the inverse of a matrix. Fails with "renderer.viewpoint" for a viewpoint that is not finite or whose
/// matrix has no inverse, with "renderer.target" as Renderer::draw() does, and with "renderer.point" for a
/// point that is not finite.
Result<Ray> rayThrough(const Viewpoint& viewpoint, const DrawTarget& target, double x, double y);

} // namespace franken
