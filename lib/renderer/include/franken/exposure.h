// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/light.h"

namespace FRANKEN_API franken {

/// The exposure at which a white matt surface that faces most of the light is drawn as 1, and nothing matt is
/// overexposed: pi over the sum of all lights' illuminance in lux (KHR_lights_punctual), each as if the
/// surface faced it. A punctual light is measured at the middle of `bounds`, the scene's (no nearer than its
/// radius); a sky or an ambient colour adds the largest illuminance of six directions. Colours count by their
/// luminance. Depends on nothing else, so the same lights give the same picture. 1 where there is no light.
float autoExposure(const Lighting& lighting, const Box& bounds);

} // namespace franken
