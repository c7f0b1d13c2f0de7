// SPDX-License-Identifier: MIT
#include "exr_file.h"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include <tinyexr.h>

namespace franken::test {
namespace {

/// The planes of one block of the picture; as tinyexr wants them, by pointers to bytes.
struct Planes {
    Planes(const ExrFile& file, int left, int top, int width, int height) {
        for (std::size_t c = 0; c < file.channels.size(); ++c) {
            std::vector<float>& plane = values.emplace_back();
            for (int i = 0; i < width * height; ++i)
                plane.push_back(exrValue(c, left + i % width, top + i / width));
        }
        for (std::vector<float>& plane : values)
            pointers.push_back(reinterpret_cast<unsigned char*>(plane.data()));
    }
    std::vector<std::vector<float>> values;
    std::vector<unsigned char*> pointers;
};

std::vector<EXRChannelInfo> channelsOf(const ExrFile& file, int type) {
    std::vector<EXRChannelInfo> channels(file.channels.size());
    for (std::size_t i = 0; i < channels.size(); ++i) {
        std::strncpy(channels[i].name, file.channels[i].c_str(), sizeof channels[i].name - 1);
        channels[i].pixel_type = type;
        channels[i].x_sampling = channels[i].y_sampling = 1;
    }
    return channels;
}

std::string save(const EXRImage& image, const EXRHeader& header) {
    unsigned char* memory = nullptr;
    const char* message = nullptr;
    const std::size_t size = SaveEXRImageToMemory(&image, &header, &memory, &message);
    if (size == 0)
        throw std::runtime_error(message != nullptr ? message : "tinyexr wrote nothing");
    std::string bytes(reinterpret_cast<char*>(memory), size);
    std::free(memory);
    return bytes;
}

std::size_t valueOf(const std::string& bytes, const std::string& name) {
    const std::size_t at = bytes.find(name + '\0');
    if (at == std::string::npos)
        throw std::runtime_error("no attribute " + name);
    return bytes.find('\0', at + name.size() + 1) + 5; // Behind the type and the length.
}

} // namespace

float exrValue(std::size_t channel, int x, int y) {
    return static_cast<float>(channel + 1) * 0.25f + static_cast<float>((x * 7 + y * 13) % 64) * 0.5f;
}

std::string int32(int value) {
    std::string bytes;
    for (int i = 0; i < 4; ++i)
        bytes += static_cast<char>(static_cast<std::uint32_t>(value) >> 8 * i);
    return bytes;
}

std::string exrBytes(const ExrFile& file) {
    EXRHeader header;
    EXRImage image;
    InitEXRHeader(&header);
    InitEXRImage(&image);
    const int stored = file.half ? TINYEXR_PIXELTYPE_HALF : TINYEXR_PIXELTYPE_FLOAT;
    std::vector<EXRChannelInfo> channels = channelsOf(file, stored);
    std::vector<int> given(channels.size(), TINYEXR_PIXELTYPE_FLOAT), requested(channels.size(), stored);
    header.channels = channels.data();
    header.num_channels = image.num_channels = static_cast<int>(channels.size());
    header.pixel_types = given.data();
    header.requested_pixel_types = requested.data();
    header.compression_type = file.compression;
    image.width = file.width;
    image.height = file.height;
    if (file.tile == 0) {
        Planes planes(file, 0, 0, file.width, file.height);
        image.images = planes.pointers.data();
        return save(image, header);
    }
    header.data_window = {0, 0, file.width - 1, file.height - 1};
    header.tiled = 1;
    header.tile_size_x = header.tile_size_y = file.tile;
    std::vector<Planes> planes;
    std::vector<EXRTile> tiles;
    planes.reserve(static_cast<std::size_t>(file.width / file.tile * (file.height / file.tile)));
    for (int y = 0; y < file.height / file.tile; ++y)
        for (int x = 0; x < file.width / file.tile; ++x) {
            planes.emplace_back(file, x * file.tile, y * file.tile, file.tile, file.tile);
            tiles.push_back({x, y, 0, 0, file.tile, file.tile, planes.back().pointers.data()});
        }
    image.tiles = tiles.data();
    image.num_tiles = static_cast<int>(tiles.size());
    return save(image, header);
}

std::string withAttribute(std::string bytes, const std::string& name, const std::string& value) {
    return bytes.replace(valueOf(bytes, name), value.size(), value);
}

std::string movedData(std::string bytes, const ExrFile& file, int x, int y) {
    bytes = withAttribute(std::move(bytes), "dataWindow",
                          int32(x) + int32(y) + int32(x + file.width - 1) + int32(y + file.height - 1));
    const int lines = file.compression == 3 ? 16 : file.compression == 4 ? 32 : 1;
    const int chunks = (file.height + lines - 1) / lines;
    // The first chunk is the first thing behind the table, which ends the header.
    std::size_t chunk = bytes.size();
    std::uint64_t first = 0;
    for (std::size_t table = 8; table + 8 <= bytes.size() && chunk == bytes.size(); ++table) {
        std::memcpy(&first, bytes.data() + table, sizeof first);
        if (first == table + 8 * static_cast<std::size_t>(chunks) && bytes[table - 1] == 0)
            chunk = static_cast<std::size_t>(first);
    }
    for (int i = 0; i < chunks; ++i) {
        std::int32_t length = 0;
        std::memcpy(&length, bytes.data() + chunk + 4, sizeof length);
        bytes.replace(chunk, 4, int32(y + i * lines));
        chunk += 8 + static_cast<std::size_t>(length);
    }
    return bytes;
}

} // namespace franken::test
