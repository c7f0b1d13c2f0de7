// SPDX-License-Identifier: MIT
// In place of exr.cpp where tinyexr is not there.
#include "image/exr.h"

namespace franken {

Result<FloatImage> decodeExr(std::span<const std::uint8_t>, int, std::size_t) {
    return Error{"exr.absent", "", "this is an OpenEXR picture, and this build was made without tinyexr",
                 "install libtinyexr-dev and build again, or save the picture as a Radiance .hdr"};
}

} // namespace franken
