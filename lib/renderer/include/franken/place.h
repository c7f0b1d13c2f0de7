// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"

#include <string>
#include <vector>

namespace FRANKEN_API franken {

/// A place where a model stands; no other handle of the process has its value. See Renderer::addPlace().
enum class PlaceId : unsigned {};

/// The names of a model's parts, each array in the scene's order; names may be empty, and several may be
/// equal.
struct ModelNames {
    std::vector<std::string> nodes;     ///< Of Scene::instances.
    std::vector<std::string> materials; ///< Of Scene::materials: see Renderer::setMaterial().
    std::vector<std::string> variants;  ///< Of Scene::variants: see Renderer::setVariant().
};

} // namespace franken
