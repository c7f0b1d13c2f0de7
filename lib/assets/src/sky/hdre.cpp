// SPDX-License-Identifier: MIT
#include "sky/hdre.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "image/byte_reader.h"
#include "image/hdr.h"

namespace franken {
namespace {

constexpr std::string_view kSignature = "HDRE";
constexpr int kFloats = 3; ///< The element type that is read.
constexpr int kLevels = 6;
constexpr std::size_t kFaces = 6;

struct Header {
    float version;
    int width, height, channels, bits, bytes, type;
};

Error formatError(std::string what) {
    return {"hdre.format", "", std::move(what), "write it again with texels of 32-bit floats, or use a .hdr"};
}

Header readHeader(std::span<const std::uint8_t> file) {
    ByteReader reader(file, kSignature.size());
    Header header{};
    header.version = reader.number<float>();
    header.width = reader.number<std::int16_t>();
    header.height = reader.number<std::int16_t>();
    reader.number<float>(); // The size of the file, rounded to a float: our own length is exact.
    header.channels = reader.number<std::int16_t>();
    header.bits = reader.number<std::int16_t>();
    header.bytes = reader.number<std::int16_t>();
    reader.number<std::int16_t>(); // The encoding, of which there is one.
    reader.number<float>();        // The brightest luminance.
    header.type = reader.number<std::int16_t>();
    return header;
}

bool isHeaderSize(const Header& header) {
    return header.version >= 2 ? header.bytes == 256 : header.bytes == 128 || header.bytes == 164;
}

/// Of all levels. The least width of a level is a rule of versions up to 2.0.
std::size_t texelsOf(const Header& header) {
    std::size_t texels = 0;
    for (int level = 0; level < kLevels; ++level) {
        const int least = header.version <= 2 ? std::min(8, header.width) : 1;
        const auto width = static_cast<std::size_t>(std::max(header.width >> level, least));
        texels += kFaces * width * width;
    }
    return texels;
}

Result<void> check(const Header& header, int maxFace) {
    if (!(header.version >= 1 && header.version < 4))
        return formatError("this is version " + std::to_string(header.version) + ", and 1 to 3 are read");
    if (header.width != header.height || header.width < 1 || header.width > maxFace)
        return Error{"hdre.size", "",
                     "the faces are " + std::to_string(header.width) + " x " + std::to_string(header.height) +
                         " texels",
                     "all six must be square, and " + std::to_string(maxFace) + " texels wide at the most"};
    if (header.type != kFloats || header.bits != 32)
        return formatError("texels are of element type " + std::to_string(header.type) + " with " +
                           std::to_string(header.bits) + " bits a channel, and only 32-bit floats are read");
    if (header.channels != 3 && header.channels != 4)
        return formatError("texels have " + std::to_string(header.channels) + " channels, not 3 or 4");
    if (!isHeaderSize(header))
        return formatError("the header claims " + std::to_string(header.bytes) +
                           " bytes, which its version does not have");
    return {};
}

} // namespace

bool isHdre(std::span<const std::uint8_t> file) {
    return file.size() >= kSignature.size() && std::equal(kSignature.begin(), kSignature.end(), file.begin());
}

Result<Environment> decodeHdre(std::span<const std::uint8_t> file, int maxFace, std::size_t maxBytes) {
    if (!isHdre(file))
        return formatError("this is no HDRE environment: it does not start with HDRE");
    const Header header = readHeader(file);
    if (const Result<void> checked = check(header, maxFace); !checked)
        return checked.error();
    const std::size_t bytes = static_cast<std::size_t>(header.bytes) +
                              texelsOf(header) * static_cast<std::size_t>(header.channels) * sizeof(float);
    if (file.size() < bytes)
        return formatError("the file is cut off: its six levels need " + std::to_string(bytes) +
                           " bytes, and it has " + std::to_string(file.size()));
    const std::size_t count =
        kFaces * static_cast<std::size_t>(header.width) * static_cast<std::size_t>(header.width);
    if (count * sizeof(glm::vec3) > maxBytes)
        return memoryError("");

    Environment sky{Environment::Layout::Cube, header.width, static_cast<int>(kFaces) * header.width, {}};
    sky.texels.reserve(count);
    ByteReader reader(file, static_cast<std::size_t>(header.bytes));
    for (std::size_t i = 0; i < count; ++i) {
        glm::vec3 texel;
        for (int channel = 0; channel < 3; ++channel)
            texel[channel] = reader.number<float>();
        if (header.channels == 4)
            reader.number<float>();
        if (!isFinite(texel))
            return formatError("texel " + std::to_string(i) + " is not finite");
        sky.texels.push_back(clampedRadiance(texel));
    }
    return sky;
}

} // namespace franken
