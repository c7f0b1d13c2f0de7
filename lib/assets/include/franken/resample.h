// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/texture_role.h"
#include "franken/scene.h"

namespace FRANKEN_API franken {

/// The image at another size (1 and up), filtered with a tent as wide as the larger of both pixel sizes:
/// colours in linear light, numbers as they are, normals normalised again. The texture's wraps say how the
/// image continues beyond its edges.
Image resampled(const Image& image, int width, int height, const Texture& texture, TextureContents contents);

} // namespace franken
