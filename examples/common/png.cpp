// SPDX-License-Identifier: MIT
#include "common/png.h"

#include "franken/file_writer.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>

using namespace franken;

std::vector<std::uint8_t> encodePng(int width, int height, int channels, std::span<const std::uint8_t> pixels,
                                    int effort) {
    std::vector<std::uint8_t> file;
    const auto append = [](void* context, void* data, int size) {
        const auto* const bytes = static_cast<const std::uint8_t*>(data);
        auto& target = *static_cast<std::vector<std::uint8_t>*>(context);
        target.insert(target.end(), bytes, bytes + size);
    };
    stbi_write_png_compression_level = effort;
    stbi_write_png_to_func(append, &file, width, height, channels, pixels.data(), width * channels);
    return file;
}

Result<void> writePng(const std::filesystem::path& path, const Image& image) {
    std::vector<std::uint8_t> rgb;
    rgb.reserve(image.rgba.size() / 4 * 3);
    for (std::size_t pixel = 0; pixel < image.rgba.size(); pixel += 4)
        for (std::size_t channel = 0; channel < 3; ++channel)
            rgb.push_back(image.rgba[pixel + channel]);
    const std::vector<std::uint8_t> png = encodePng(image.width, image.height, 3, rgb);
    return writeFile(path, png);
}
