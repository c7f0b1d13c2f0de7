// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/texture_role.h"
#include "franken/scene.h"

namespace FRANKEN_API franken {

/// The image at another size (1 and up), filtered with a tent as wide as the larger of both pixel sizes:
/// colours in linear light, numbers as they are, normals made unit again. Beyond its edges the image goes on
/// as the wraps of the texture say.
Image resampled(const Image& image, int width, int height, const Texture& texture, TextureContents contents);

} // namespace franken
