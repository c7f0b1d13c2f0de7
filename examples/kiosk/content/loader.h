// SPDX-License-Identifier: MIT
#pragma once

#include "franken/result.h"
#include "franken/scene.h"

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace kiosk {

/// A file as it was read.
struct LoadedModel {
    std::filesystem::path path;
    franken::Result<franken::Scene> scene;
    /// What views and lights need of the scene, without what fills the memory.
    franken::Scene still;
    /// What the model passes through as it turns about the middle of its box, and plays its animations.
    franken::Box swept;
    std::string caption;
    std::vector<std::string> warnings;
};

/// Reads a model, with its images as they are encoded; gives up once the token is stopped. A model that shows
/// nothing has an error in place of its scene. `progress` is called with the share that is done.
LoadedModel loadModel(const std::filesystem::path& path, const std::stop_token& cancel,
                      const std::function<void(float)>& progress = {});

/// The name that a picture of the model carries: the first line of a .txt of the same name beside it, else
/// the file's name, with spaces for hyphens and underscores.
std::string captionOf(const std::filesystem::path& model);

} // namespace kiosk
