// SPDX-License-Identifier: MIT
#include "franken/png.h"

#include "franken/file_writer.h"

#define STB_IMAGE_WRITE_STATIC // tinygltf may have one of its own.
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>

namespace franken {

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

Result<void> writePng(const std::filesystem::path& path, const Image& image, PngChannels channels) {
    const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (image.width < 1 || image.height < 1 || image.rgba.size() != 4 * pixels)
        return Error{"image.pixels", path.string(), "the image does not have four bytes for each pixel",
                     "fill in width, height, and width * height * 4 bytes"};
    if (channels == PngChannels::Rgba)
        return writeFile(path, encodePng(image.width, image.height, 4, image.rgba));
    std::vector<std::uint8_t> rgb;
    rgb.reserve(3 * pixels);
    for (std::size_t pixel = 0; pixel < image.rgba.size(); pixel += 4)
        for (std::size_t channel = 0; channel < 3; ++channel)
            rgb.push_back(image.rgba[pixel + channel]);
    return writeFile(path, encodePng(image.width, image.height, 3, rgb));
}

} // namespace franken
