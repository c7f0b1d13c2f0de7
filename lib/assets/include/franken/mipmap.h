// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/image.h"

#include <vector>

namespace FRANKEN_API franken {

/// The mip levels from 1 on, down to one pixel, of an image whose colours are sRGB: each pixel is the mean of
/// the pixels that it covers, in linear light. The driver's mipmaps average sRGB codes, which makes distant
/// fine patterns too dark.
std::vector<Image> srgbMipmaps(const Image& image);

} // namespace franken
