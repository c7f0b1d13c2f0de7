// SPDX-License-Identifier: MIT
#pragma once

#include "franken/pick.h"
#include "franken/scene.h"

#include <string>

/// What is in a scene, a line for each camera, light, variant, animation, material, image and node: what the
/// options name, and what a file is full of.
std::string listOf(const franken::Scene& scene);

/// What a ray has met, in the same words and numbers.
std::string listOf(const franken::Scene& scene, const std::optional<franken::Hit>& hit);
