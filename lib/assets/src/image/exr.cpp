// SPDX-License-Identifier: MIT
#include "image/exr.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

#include <glm/gtc/packing.hpp>
#include <tinyexr.h>

namespace franken {
namespace {

/// What tinyexr 1.0.1 may read behind the end of a broken chunk: a bitmap of PIZ, and a Huffman table.
constexpr std::size_t kPadding = 65536;

/// tinyexr's own two structures, and what it has allocated for them.
class Decoded {
public:
    Decoded() {
        InitEXRHeader(&header);
        InitEXRImage(&image);
    }
    Decoded(const Decoded&) = delete;
    Decoded& operator=(const Decoded&) = delete;
    ~Decoded() {
        FreeEXRImage(&image);
        FreeEXRHeader(&header);
    }

    /// False if the file is broken. chunks: as many tiles as the picture has.
    bool read(std::span<const std::uint8_t> file, int chunks) {
        EXRVersion version{};
        const char* message = nullptr; // Ours says more: tinyexr's names its own functions.
        bool read = ParseEXRVersionFromMemory(&version, file.data(), file.size()) == TINYEXR_SUCCESS &&
                    ParseEXRHeaderFromMemory(&header, &version, file.data(), file.size(), &message) ==
                        TINYEXR_SUCCESS;
        if (read) {
            // Where it fails, tinyexr 1.0.1 frees its arrays by these counts, which it has not set by then,
            // and leaves the pointers behind.
            image.num_channels = header.num_channels;
            image.num_tiles = header.tiled != 0 ? chunks : 0;
            read = LoadEXRImageFromMemory(&image, &header, file.data(), file.size(), &message) ==
                   TINYEXR_SUCCESS;
            if (!read)
                InitEXRImage(&image);
        }
        FreeEXRErrorMessage(message);
        return read;
    }

    EXRHeader header{};
    EXRImage image{};
};

/// The index of R, G and B, or of Y three times.
Result<std::array<std::size_t, 3>> colorChannels(const ExrHeader& header) {
    const auto find = [&](std::string_view name) {
        const auto found = std::find_if(header.channels.begin(), header.channels.end(),
                                        [&](const auto& c) { return c.name == name && !c.whole; });
        return static_cast<std::size_t>(found - header.channels.begin());
    };
    const std::size_t none = header.channels.size(), grey = find("Y");
    std::array<std::size_t, 3> colors{find("R"), find("G"), find("B")};
    if (std::count(colors.begin(), colors.end(), none) == 3)
        colors = {grey, grey, grey};
    if (std::count(colors.begin(), colors.end(), none) != 0)
        return exrFormatError("it has no channels R, G and B of halves or floats, and no Y");
    return colors;
}

/// A block of the decoder's texels: all of the picture, or a tile.
struct Block {
    unsigned char** channels;
    int left, top;     ///< In the stored texels.
    int width, height; ///< Texels.
    int stride;        ///< Texels from a row to the next.
};

class Assembly {
public:
    Assembly(const ExrHeader& header, const std::array<std::size_t, 3>& colors)
        : m_header(header),
          m_colors(colors),
          m_frame(header.data.width() == header.display.width() &&
                          header.data.height() == header.display.height()
                      ? header.data
                      : header.display) {
        image.width = m_frame.width();
        image.height = m_frame.height();
        image.texels.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    }

    /// False if a texel is not finite.
    bool add(const Block& block) {
        const int left = m_header.data.left - m_frame.left + block.left;
        const int top = m_header.data.top - m_frame.top + block.top;
        for (int y = std::max(0, -top); y < std::min(block.height, image.height - top); ++y)
            for (int x = std::max(0, -left); x < std::min(block.width, image.width - left); ++x) {
                const glm::vec3 texel =
                    texelOf(block, static_cast<std::size_t>(y) * static_cast<std::size_t>(block.stride) +
                                       static_cast<std::size_t>(x));
                if (!isFinite(texel))
                    return false;
                image.texels[static_cast<std::size_t>(top + y) * static_cast<std::size_t>(image.width) +
                             static_cast<std::size_t>(left + x)] = clampedRadiance(texel);
            }
        return true;
    }

    FloatImage image;

private:
    glm::vec3 texelOf(const Block& block, std::size_t at) const {
        glm::vec3 texel;
        for (int i = 0; i < 3; ++i) {
            const std::size_t channel = m_colors[static_cast<std::size_t>(i)];
            const unsigned char* bytes = block.channels[channel];
            if (m_header.channels[channel].bytes == 2) {
                std::uint16_t half;
                std::memcpy(&half, bytes + at * sizeof half, sizeof half);
                texel[i] = glm::unpackHalf1x16(half);
            } else {
                std::memcpy(&texel[i], bytes + at * sizeof(float), sizeof(float));
            }
        }
        return texel;
    }

    const ExrHeader& m_header;
    const std::array<std::size_t, 3>& m_colors;
    ExrHeader::Box m_frame;
};

bool assemble(Assembly& assembly, const Decoded& decoded, const ExrHeader& header) {
    const EXRImage& image = decoded.image;
    if (header.tileWidth == 0)
        return assembly.add(
            {image.images, 0, 0, header.data.width(), header.data.height(), header.data.width()});
    for (int i = 0; i < image.num_tiles; ++i) {
        const EXRTile& tile = image.tiles[i];
        if (!assembly.add({tile.images, tile.offset_x * header.tileWidth, tile.offset_y * header.tileHeight,
                           tile.width, tile.height, header.tileWidth}))
            return false;
    }
    return true;
}

/// Whether tinyexr took from the file what our own check did.
bool agree(const Decoded& decoded, const ExrHeader& header) {
    const EXRImage& image = decoded.image;
    bool same = image.width == header.data.width() && image.height == header.data.height() &&
                decoded.header.num_channels == static_cast<int>(header.channels.size()) &&
                (header.tileWidth == 0 ? image.images != nullptr : image.tiles != nullptr);
    for (std::size_t i = 0; same && i < header.channels.size(); ++i)
        same = header.channels[i].name == decoded.header.channels[i].name;
    return same;
}

} // namespace

Result<FloatImage> decodeExr(std::span<const std::uint8_t> file, int maxSize, std::size_t maxBytes) {
    const Result<ExrHeader> header = readExrHeader(file, maxSize);
    if (!header)
        return header.error();
    const Result<std::array<std::size_t, 3>> colors = colorChannels(*header);
    if (!colors)
        return colors.error();
    const std::size_t texels =
        static_cast<std::size_t>(std::max(header->data.width(), header->display.width())) *
        static_cast<std::size_t>(std::max(header->data.height(), header->display.height()));
    if (file.size() + kPadding + header->decodedBytes() + texels * sizeof(glm::vec3) > maxBytes)
        return memoryError("");

    std::vector<std::uint8_t> padded(file.size() + kPadding);
    std::copy(file.begin(), file.end(), padded.begin());
    Decoded decoded;
    if (!decoded.read(std::span(padded).first(file.size()), static_cast<int>(header->chunks())) ||
        !agree(decoded, *header))
        return exrFormatError("its texels cannot be unpacked");
    padded = {};
    Assembly assembly(*header, *colors);
    if (!assemble(assembly, decoded, *header))
        return exrFormatError("a texel is not finite");
    return std::move(assembly.image);
}

} // namespace franken
