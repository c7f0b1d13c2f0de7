// SPDX-License-Identifier: MIT
#pragma once

#include "franken/image.h"

namespace franken {

/// The image at another size (1 and up), filtered with a tent as wide as the larger of both pixel sizes, in
/// the encoding that the pixels have.
Image resampled(const Image& image, int width, int height);

} // namespace franken
