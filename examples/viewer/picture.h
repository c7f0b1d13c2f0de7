// SPDX-License-Identifier: MIT
#pragma once

#include "franken/baked_sky.h"
#include "franken/image.h"
#include "franken/light.h"
#include "franken/scene.h"
#include "options.h"

#include <optional>

/// Everything that a picture shows.
struct Subject {
    franken::Scene scene;
    franken::Camera camera;
    franken::Lighting lighting;
    std::optional<franken::BakedSky> sky;
};

/// Opens a context, draws, and reads the picture back, row 0 at the top.
franken::Result<franken::Image> drawPicture(const Subject& subject, const Options& options,
                                            const franken::Log& log);
