// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/texture_role.h"
#include "franken/image.h"

#include <vector>

namespace FRANKEN_API franken {

/// The mip levels from 1 on, down to one pixel: each pixel is the mean of the pixels that it covers; of
/// colours, in linear light. The driver's mipmaps average sRGB codes, which makes distant fine patterns too
/// dark, and makes them all in one call that nothing can interrupt.
std::vector<Image> mipmaps(const Image& image, TextureContents contents);

} // namespace franken
