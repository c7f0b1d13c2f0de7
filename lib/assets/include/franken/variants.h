// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/result.h"
#include "franken/scene.h"

#include <string_view>

namespace FRANKEN_API franken {

/// Gives each primitive the material that it has in that variant (KHR_materials_variants), for good: for what
/// draws one look of a scene. Renderer::setVariant() changes between them. Fails with "scene.variant" for a
/// name that is none of Scene::variants. Costs a pass over the primitives.
Result<void> applyVariant(Scene& scene, std::string_view name);

} // namespace franken
