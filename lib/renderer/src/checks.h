// SPDX-License-Identifier: MIT
#pragma once

#include "franken/draw_target.h"
#include "franken/generator/pack.h"
#include "franken/image.h"
#include "franken/light.h"
#include "franken/overlay.h"
#include "franken/result.h"
#include "franken/viewpoint.h"

#include <span>

/// What a caller can get wrong with numbers. Each check names the first wrong one.
namespace franken {

/// "renderer.lighting"
Result<void> check(const Lighting& lighting);
/// "renderer.viewpoint"
Result<void> check(const Viewpoint& viewpoint);
/// "renderer.target"
Result<void> check(const DrawTarget& target);
/// "renderer.overlay"
Result<void> check(std::span<const OverlayQuad> quads);
/// "renderer.image": width and height, and as many bytes as they say.
Result<void> check(const Image& image);
/// "renderer.transform": finite, and affine.
Result<void> checkTransform(const glm::dmat4& matrix);
/// "renderer.sky": the range of an encoded sky.
Result<void> checkRange(float range);
/// Of these values, the others 0. "renderer.effect": too many, or not finite.
Result<EffectBlock> effectBlock(std::span<const Float4> values);

/// "renderer.model", "renderer.place"
Error unknownModel();
Error unknownPlace();

} // namespace franken
