// SPDX-License-Identifier: MIT
#include "common/png.h"

#include <cerrno>
#include <cstring>
#include <fstream>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>

using namespace franken;

namespace {

Error failed(const std::filesystem::path& path, const std::string& why) {
    return {"png.write", path.string(), "cannot be written: " + why,
            "check the folder, its permissions and the space left"};
}

} // namespace

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
    std::ofstream file(path, std::ios::binary);
    if (file.write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size())) &&
        file.flush())
        return {};
    return failed(path, std::strerror(errno));
}

Result<void> replacePng(const std::filesystem::path& path, const Image& image) {
    std::filesystem::path beside = path;
    beside += ".new";
    if (Result<void> written = writePng(beside, image); !written)
        return written;
    std::error_code error;
    std::filesystem::rename(beside, path, error);
    if (error)
        return failed(path, error.message());
    return {};
}
