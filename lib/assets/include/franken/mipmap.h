// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/image.h"

#include <vector>

namespace FRANKEN_API franken {

/// The levels from 1 on, down to one pixel, of an image whose colours are sRGB: each pixel is the mean of those that it
/// covers, in linear light. The driver's mipmaps are means of codes, which makes fine patterns darker the
/// further away they are.
std::vector<Image> srgbMipmaps(const Image& image);

} // namespace franken
