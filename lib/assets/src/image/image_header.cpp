// SPDX-License-Identifier: MIT
#include "image/image_header.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace franken {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::array<std::uint8_t, 8> kPngMagic{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::size_t kPngHeaderEnd = 29; ///< Magic, chunk length and name, width, height, five bytes.
constexpr int kMaxScans = 100;
constexpr std::uint8_t kJpegScan = 0xDA, kJpegEnd = 0xD9; ///< Markers.
constexpr std::size_t kSlack = 1 << 18;                   ///< Tables, and rows that are rounded up.

Error formatError(const std::string& what) {
    return {"image.format", "", what, "save it again as PNG or JPEG"};
}

std::uint32_t bigEndian(Bytes bytes) {
    std::uint32_t value = 0;
    for (const std::uint8_t byte : bytes)
        value = value << 8 | byte;
    return value;
}

Result<ImageHeader> sized(std::uint32_t width, std::uint32_t height, int maxSize) {
    const auto limit = static_cast<std::uint32_t>(maxSize);
    if (width < 1 || height < 1 || width > limit || height > limit)
        return Error{"image.size", "",
                     "the image is " + std::to_string(width) + " x " + std::to_string(height) +
                         " pixels, the limit is " + std::to_string(maxSize),
                     "scale it down"};
    return ImageHeader{static_cast<int>(width), static_cast<int>(height), 0};
}

bool isPng(Bytes encoded) {
    return encoded.size() >= kPngMagic.size() &&
           std::equal(kPngMagic.begin(), kPngMagic.end(), encoded.begin());
}

// Whether the first chunk of pixels is empty. The standard allows it and nobody writes it; stb_image 2.27
// then copies to where it has allocated nothing.
bool hasEmptyStart(Bytes encoded) {
    constexpr std::size_t kBeforeChunk = 8, kAroundChunk = 12; // its length and name, then its checksum
    for (Bytes rest = encoded.subspan(kPngMagic.size()); rest.size() >= kBeforeChunk;) {
        const std::size_t length = bigEndian(rest.first(4));
        if (bigEndian(rest.subspan(4, 4)) == 0x49444154) // "IDAT"
            return length == 0;
        if (length > rest.size())
            return false;
        rest = rest.subspan(std::min(kAroundChunk + length, rest.size()));
    }
    return false;
}

Result<ImageHeader> readPng(Bytes encoded, int maxSize) {
    if (encoded.size() < kPngHeaderEnd || bigEndian(encoded.subspan(12, 4)) != 0x49484452) // "IHDR"
        return formatError("the PNG does not begin with its header");
    if (hasEmptyStart(encoded))
        return formatError("the PNG's first chunk of pixels is empty");
    Result<ImageHeader> header =
        sized(bigEndian(encoded.subspan(16, 4)), bigEndian(encoded.subspan(20, 4)), maxSize);
    if (!header)
        return header;
    const std::size_t pixels = header->pixelBytes() / 4;
    const std::size_t depth = encoded[24], type = encoded[25];
    const std::size_t channels = type == 2 ? 3 : type == 6 ? 4 : type == 4 ? 2 : 1;
    if (pixels / 8 * depth * channels / 1032 > encoded.size())
        return formatError("the PNG is cut off: its size in bytes cannot hold its size in pixels");
    // The compressed bytes are gathered, then inflated, then filtered into pixels of at most four channels.
    header->decodingBytes = 2 * encoded.size() + pixels * (depth == 16 ? 16 : 8) + kSlack;
    return header;
}

/// Walks the markers of a JPEG.
class JpegReader {
public:
    explicit JpegReader(Bytes encoded) : m_rest(encoded.subspan(2)) {}

    /// Behind the next marker, which is returned; 0 at the end.
    std::uint8_t marker() {
        // 0xFF 0x00 is a byte of data, 0xD0 to 0xD7 restart it, 0xFF fills.
        for (; m_rest.size() >= 2; m_rest = m_rest.subspan(1)) {
            const std::uint8_t code = m_rest[1];
            if (m_rest[0] != 0xFF || code == 0 || code == 0xFF || (code >= 0xD0 && code <= 0xD7))
                continue;
            m_rest = m_rest.subspan(2);
            return code;
        }
        return 0;
    }

    /// What the marker says, and moves behind it. False where that is not all there.
    bool segment(Bytes& content) {
        const std::size_t length = m_rest.size() < 2 ? 0 : bigEndian(m_rest.first(2));
        if (length < 2 || length > m_rest.size())
            return false;
        content = m_rest.subspan(2, length - 2);
        m_rest = m_rest.subspan(length);
        return true;
    }

private:
    Bytes m_rest;
};

bool isJpeg(Bytes encoded) { return encoded.size() >= 4 && encoded[0] == 0xFF && encoded[1] == 0xD8; }

Result<ImageHeader> readFrame(Bytes frame, bool progressive, Bytes encoded, int maxSize) {
    if (frame.size() < 6)
        return formatError("the JPEG's header is cut off");
    Result<ImageHeader> header =
        sized(bigEndian(frame.subspan(3, 2)), bigEndian(frame.subspan(1, 2)), maxSize);
    if (!header)
        return header;
    if (header->pixelBytes() / 4 / 64 / 8 > encoded.size())
        return formatError("the JPEG is cut off: its size in bytes cannot hold its size in pixels");
    // Each component as bytes, and as 16-bit coefficients too if they come in parts; then RGBA.
    const std::size_t components = std::min<std::size_t>(frame[5], 4);
    const std::size_t padded = (std::size_t{31} + header->width) * (std::size_t{31} + header->height);
    header->decodingBytes = padded * (components * (progressive ? 3 : 1) + 4) + kSlack;
    return header;
}

// T.81, C.2: no length has more codes than are left by the shorter ones.
bool areCodesPossible(Bytes counts) {
    std::size_t codes = 0, most = 1;
    for (const std::uint8_t count : counts) {
        codes = 2 * codes + count;
        most *= 2;
        if (count > 0 && codes > most)
            return false;
    }
    return true;
}

// T.81, B.2.4.2: tables of a byte, 16 counts and as many symbols as these add up to. stb_image 2.27 writes
// past its own table where they are more than 256.
bool areHuffmanTablesSound(Bytes tables) {
    constexpr std::size_t kCounts = 17;
    while (!tables.empty()) {
        if (tables.size() < kCounts || tables[0] >> 4 > 1 || (tables[0] & 15) > 3)
            return false;
        const Bytes counts = tables.subspan(1, 16);
        const std::size_t symbols = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
        if (symbols > 256 || symbols > tables.size() - kCounts || !areCodesPossible(counts))
            return false;
        tables = tables.subspan(kCounts + symbols);
    }
    return true;
}

// T.81, B.2.4.1: tables of a byte and 64 values, of 8 or 16 bits.
bool areQuantisersSound(Bytes tables) {
    while (!tables.empty()) {
        const std::size_t size = tables[0] >> 4 == 0 ? 65 : 129;
        if (tables[0] >> 4 > 1 || (tables[0] & 15) > 3 || tables.size() < size)
            return false;
        tables = tables.subspan(size);
    }
    return true;
}

// stb_image 2.30 shows what it has of a picture where such a segment is broken, 2.27 refuses: we refuse.
bool isSegmentSound(std::uint8_t marker, Bytes content) {
    constexpr std::uint8_t kHuffmanTables = 0xC4, kQuantisers = 0xDB, kLines = 0xDC, kRestarts = 0xDD;
    if (marker == kHuffmanTables)
        return areHuffmanTablesSound(content);
    if (marker == kQuantisers)
        return areQuantisersSound(content);
    if (marker == kLines || marker == kRestarts)
        return content.size() == 2;
    const bool isFrame = marker >= 0xC0 && marker <= 0xC2; // Baseline, extended, progressive.
    const bool isApplications = marker >= 0xE0 && marker <= 0xEF;
    return isFrame || isApplications || marker == kJpegScan || marker == 0xFE; // 0xFE: a comment
}

Result<ImageHeader> readJpeg(Bytes encoded, int maxSize) {
    Result<ImageHeader> header = formatError("the JPEG has no header");
    JpegReader reader(encoded);
    int frames = 0, scans = 0;
    std::uint8_t marker = reader.marker();
    for (; marker != 0 && marker != kJpegEnd; marker = reader.marker()) {
        Bytes content;
        if (!reader.segment(content))
            return formatError("the JPEG is cut off inside its headers");
        if (!isSegmentSound(marker, content))
            return formatError("the JPEG has a broken table, or a part that is unknown");
        if (marker >= 0xC0 && marker <= 0xC2 && ++frames == 1)
            header = readFrame(content, marker == 0xC2, encoded, maxSize);
        if (marker == kJpegScan && ++scans > kMaxScans)
            return formatError("the JPEG has more than " + std::to_string(kMaxScans) + " scans");
    }
    if (frames > 1)
        return formatError("the JPEG has more than one picture in it");
    if (header && (marker != kJpegEnd || scans == 0))
        return formatError("the JPEG is cut off: it ends in the middle of its picture");
    return header;
}

} // namespace

Result<ImageHeader> readImageHeader(Bytes encoded, int maxSize) {
    if (encoded.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        return formatError("the image has more than 2 GiB");
    if (isPng(encoded))
        return readPng(encoded, maxSize);
    if (isJpeg(encoded))
        return readJpeg(encoded, maxSize);
    return formatError("the image is neither a PNG nor a JPEG");
}

} // namespace franken
