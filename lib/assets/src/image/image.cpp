// SPDX-License-Identifier: MIT
#include "franken/image.h"

#include <cstdlib>
#include <cstring>
#include <memory>

#include "image/image_header.h"

namespace {

/// What stb_image may still allocate on this thread. Its inflater grows as long as there is input, whatever
/// the picture's header says, so the header's own sum is the limit.
thread_local std::size_t allowance = 0;

/// Before each block: how long it is.
constexpr std::size_t kBlockHeader = alignof(std::max_align_t);
static_assert(kBlockHeader >= sizeof(std::size_t));

std::size_t blockSize(const void* block) {
    std::size_t size = 0;
    if (block)
        std::memcpy(&size, static_cast<const char*>(block) - kBlockHeader, sizeof size);
    return size;
}

void release(void* block) {
    allowance += blockSize(block);
    if (block)
        std::free(static_cast<char*>(block) - kBlockHeader);
}

void* resize(void* block, std::size_t size) {
    const std::size_t old = blockSize(block);
    if (size > allowance + old)
        return nullptr;
    // Zeros, because stb_image 2.27 decodes with tables that a JPEG has never defined.
    void* whole = block ? std::realloc(static_cast<char*>(block) - kBlockHeader, kBlockHeader + size)
                        : std::calloc(1, kBlockHeader + size);
    if (!whole)
        return nullptr;
    allowance = allowance + old - size;
    std::memcpy(whole, &size, sizeof size);
    return static_cast<char*>(whole) + kBlockHeader;
}

} // namespace

// Its own copy of stb, not Debian's library, so that only the two decoders that glTF has are built in.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_MALLOC(size) resize(nullptr, size)
#define STBI_REALLOC(block, size) resize(block, size)
#define STBI_FREE(block) release(block)
#include <stb/stb_image.h>

namespace franken {

Result<Image> decodeImage(std::span<const std::uint8_t> encoded, int maxSize) {
    const Result<ImageHeader> header = readImageHeader(encoded, maxSize);
    if (!header)
        return header.error();
    allowance = header->decodingBytes;
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(encoded.data(), static_cast<int>(encoded.size()), &width, &height, &channels,
                              STBI_rgb_alpha),
        stbi_image_free);
    if (!pixels || width != header->width || height != header->height) {
        const char* reason = stbi_failure_reason();
        return Error{"image.format", "",
                     std::string("the image cannot be decoded: ") + (reason ? reason : "unknown"),
                     "save it again as PNG or JPEG"};
    }
    Image image;
    image.width = width;
    image.height = height;
    image.rgba.assign(pixels.get(), pixels.get() + header->pixelBytes());
    return image;
}

Result<Image> withPixels(const Image& image) {
    if (image.encoded.empty())
        return image;
    Result<Image> decoded = decodeImage(image.encoded);
    if (decoded)
        decoded->name = image.name;
    return decoded;
}

} // namespace franken
