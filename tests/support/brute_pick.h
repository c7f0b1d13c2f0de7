// SPDX-License-Identifier: MIT
#pragma once

#include "franken/pick.h"

namespace franken::test {

/// The nearest hit by testing every triangle where it stands in the world (T. Möller and B. Trumbore, "Fast,
/// Minimum Storage Ray/Triangle Intersection", 1997): what a tree is compared with. The ray's direction has
/// length 1.
std::optional<Hit> pickByTestingAll(const Scene& scene, const Ray& ray);

} // namespace franken::test
