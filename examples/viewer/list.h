// SPDX-License-Identifier: MIT
#pragma once

#include "franken/scene.h"

#include <string>

/// What is in a scene, a line for each camera, light, variant, material and node: what the options name.
std::string listOf(const franken::Scene& scene);
