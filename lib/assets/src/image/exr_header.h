// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "franken/result.h"

namespace franken {

/// Whether these bytes start as an OpenEXR picture does.
bool isExr(std::span<const std::uint8_t> file);

/// What an OpenEXR picture says of itself ("OpenEXR File Layout"), read without decoding anything.
struct ExrHeader {
    /// Texels from first to last, both included. Each coordinate is within a million of 0.
    struct Box {
        int left = 0, top = 0, right = -1, bottom = -1;
        int width() const { return right - left + 1; }
        int height() const { return bottom - top + 1; }
        bool operator==(const Box&) const = default;
    };
    enum class Compression { None = 0, Rle = 1, ZipLine = 2, Zip = 3, Piz = 4 };
    struct Channel {
        std::string name;
        int bytes = 0;      ///< A texel: 2 (half) or 4 (float, or a whole number).
        bool whole = false; ///< A whole number, such as an object's.
    };

    Box data;    ///< The texels that are stored.
    Box display; ///< The picture.
    Compression compression = Compression::None;
    std::vector<Channel> channels;
    int tileWidth = 0, tileHeight = 0; ///< 0: stored by lines.

    /// Stretches of lines or tiles, each packed by itself.
    std::size_t chunks() const;

    /// A decoder's arrays of all channels.
    std::size_t decodedBytes() const;
};

/// Reads and checks all that a decoder would believe: one part, of lines or of tiles of one level; at most
/// kMaxExrChannels channels, none subsampled; attributes that occur once and end in the file; compression by
/// none, RLE, ZIP or PIZ; a picture and stored texels of at most `maxSize`; and each chunk's place, length
/// and coordinates. Fails with "exr.format" or "exr.size". Safe on any bytes.
Result<ExrHeader> readExrHeader(std::span<const std::uint8_t> file, int maxSize);

inline constexpr std::size_t kMaxExrChannels = 16;

Error exrFormatError(std::string what);

} // namespace franken
