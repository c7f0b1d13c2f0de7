// SPDX-License-Identifier: MIT
#pragma once

#include "franken/baked_sky.h"
#include "franken/light.h"
#include "franken/log.h"
#include "franken/viewpoint.h"
#include "options.h"

#include <string>

/// The file's camera that the options ask for, or one that frames the model where it has none: in all
/// pictures of Options::frames. Fails with "viewer.camera", and with "viewer.animation".
franken::Result<franken::Camera> chooseCamera(const franken::Scene& scene, const Options& options);

/// Moves the scene to the options' animation and time, if there is one. Fails with "viewer.animation".
franken::Result<void> applyAnimation(franken::Scene& scene, const Options& options);

/// Gives the scene and the camera the pose of that picture, counted from 0, of Options::frames.
franken::Result<void> applyFrame(franken::Scene& scene, franken::Camera& camera, const Options& options,
                                 int number);

/// Moves the scene's vertices by the options' height map, if there is one. Fails with "viewer.heights" where
/// it cannot be read, and as decodeImage() and displace() do.
franken::Result<void> applyHeights(franken::Scene& scene, const Options& options);

/// The lights of the file, of the sky (null for none) and of the options, and what they come down to where
/// there is neither.
franken::Result<franken::Lighting> chooseLighting(const franken::Scene& scene, const franken::BakedSky* sky,
                                                  const Options& options, const franken::Log& log);

/// What to say of a skybox whose texels are larger than the picture's pixels, in the middle of a face, where
/// they are largest: how many there are to a pixel, and what size would do. Empty where there is nothing to
/// say.
std::string skyboxNotice(const franken::SkyboxMap& skybox, const franken::Camera& camera,
                         const franken::platform::Size& size);
