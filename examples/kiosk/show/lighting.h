// SPDX-License-Identifier: MIT
#pragma once

#include "franken/baked_sky.h"
#include "franken/light.h"
#include "franken/material.h"
#include "kiosk/config/config.h"

#include <optional>
#include <string>

namespace kiosk {

/// What visitors change.
struct LightControls {
    bool suns = true;
    double exposure = 1; ///< Multiplies the configuration's.
};

/// The lights of a scene: the configuration's suns, else the file's lights, else one sun; with the sky or an
/// ambient colour.
franken::Lighting lightingFor(const franken::Scene& scene, const Config& config, const franken::BakedSky* sky,
                              const LightControls& controls);

/// `driver`: GL_RENDERER. `isCoarse`: the target has 5 and 6 bits a colour.
franken::Look lookFor(const Config& config, const std::string& driver, bool isCoarse, bool srgbTarget);

} // namespace kiosk
