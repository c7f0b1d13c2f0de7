// SPDX-License-Identifier: MIT
#include "write_png.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

bool writePng(const std::string& path, int width, int height, const std::vector<std::uint8_t>& rgba) {
    stbi_flip_vertically_on_write(1);
    return stbi_write_png(path.c_str(), width, height, 4, rgba.data(), 4 * width) != 0;
}
