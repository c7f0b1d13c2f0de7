// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"

#include <string>
#include <vector>

namespace FRANKEN_API franken {

/// A place where a model stands; no other handle of the process has its value. See Renderer::addPlace().
enum class PlaceId : unsigned {};

/// What the things in a model are called, each array in the order of the scene's; names may be empty, and
/// equal.
struct ModelNames {
    std::vector<std::string> nodes;     ///< Of Scene::instances.
    std::vector<std::string> materials; ///< Of Scene::materials: see Renderer::setMaterial().
    std::vector<std::string> variants;  ///< Of Scene::variants: see Renderer::setVariant().
};

} // namespace franken
