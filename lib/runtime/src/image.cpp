// SPDX-License-Identifier: MIT
#include "franken/image.h"

#include <limits>
#include <memory>

// Its own copy of stb, not Debian's library, so that only the two decoders that glTF has are built in.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#include <stb/stb_image.h>

namespace franken {
namespace {

Error formatError() {
    const char* reason = stbi_failure_reason();
    return {"image.format", "",
            std::string("the image is neither a PNG nor a JPEG: ") + (reason ? reason : "unknown"),
            "save it again as PNG or JPEG"};
}

} // namespace

Result<Image> decodeImage(std::span<const std::uint8_t> encoded, int maxSize) {
    if (encoded.empty() || encoded.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        return Error{"image.format", "", "the image has no data, or more than 2 GiB",
                     "save it again as PNG or JPEG"};
    const int size = static_cast<int>(encoded.size());

    int width = 0, height = 0, channels = 0;
    if (!stbi_info_from_memory(encoded.data(), size, &width, &height, &channels))
        return formatError();
    if (width < 1 || height < 1 || width > maxSize || height > maxSize)
        return Error{"image.size", "",
                     "the image is " + std::to_string(width) + " x " + std::to_string(height) +
                         " pixels, the limit is " + std::to_string(maxSize),
                     "scale it down"};

    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(encoded.data(), size, &width, &height, &channels, STBI_rgb_alpha),
        stbi_image_free);
    if (!pixels)
        return formatError();
    Image image;
    image.width = width;
    image.height = height;
    image.rgba.assign(pixels.get(), pixels.get() + std::size_t{4} * width * height);
    return image;
}

} // namespace franken
