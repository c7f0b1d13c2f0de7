// SPDX-License-Identifier: MIT
#include "image/exr_header.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "image/byte_reader.h"

namespace franken {
namespace {

using Box = ExrHeader::Box;
using Compression = ExrHeader::Compression;

constexpr std::uint32_t kMagic = 20000630;
constexpr std::uint32_t kTiled = 0x200, kLongNames = 0x400, kDeep = 0x800, kParts = 0x1000;
constexpr std::size_t kMaxName = 255;
constexpr std::size_t kMaxAttributes = 128; ///< tinyexr keeps no more.
constexpr int kMaxCoordinate = 1000000;
constexpr std::array<std::string_view, 10> kCompressions{"none",  "RLE", "ZIPS", "ZIP",  "PIZ",
                                                         "PXR24", "B44", "B44A", "DWAA", "DWAB"};

struct Attribute {
    std::string_view name, type;
    std::span<const std::uint8_t> value;
};

/// The attributes that say how texels are stored.
class HeaderParser {
public:
    Result<void> add(const Attribute& attribute) {
        if (!m_names.insert(attribute.name).second)
            return exrFormatError("the attribute " + std::string(attribute.name) + " occurs twice");
        if (m_names.size() > kMaxAttributes)
            return exrFormatError("it has more than " + std::to_string(kMaxAttributes) + " attributes");
        ByteReader value(attribute.value);
        if (attribute.name == "channels" && attribute.type == "chlist")
            return addChannels(value);
        if (attribute.name == "compression" && attribute.type == "compression")
            return addCompression(attribute.value);
        if (attribute.name == "dataWindow" && attribute.type == "box2i")
            return addBox(value, m_header.data);
        if (attribute.name == "displayWindow" && attribute.type == "box2i")
            return addBox(value, m_header.display);
        if (attribute.name == "tiles" && attribute.type == "tiledesc")
            return addTiles(attribute.value);
        if (attribute.name == "lineOrder" && (attribute.value.size() != 1 || attribute.value[0] > 2))
            return exrFormatError("its lineOrder is none that OpenEXR has");
        return {};
    }

    /// Once all attributes are there.
    Result<ExrHeader> finish(bool tiled) {
        for (const char* name : {"channels", "compression", "dataWindow", "displayWindow", "lineOrder",
                                 "pixelAspectRatio", "screenWindowCenter", "screenWindowWidth"})
            if (!m_names.contains(name))
                return exrFormatError("it has no attribute " + std::string(name));
        if (m_header.channels.empty())
            return exrFormatError("its attribute channels lists none");
        if (m_header.data.width() < 1 || m_header.display.width() < 1)
            return exrFormatError("a window is of another type than box2i");
        if (tiled != (m_header.tileWidth > 0))
            return exrFormatError("it says in one place only that it is stored by tiles");
        return std::move(m_header);
    }

private:
    Result<void> addChannels(ByteReader& value) {
        for (;;) {
            const std::string_view name = value.text(kMaxName);
            if (value.failed())
                return exrFormatError("its list of channels is cut off");
            if (name.empty())
                return {};
            const auto type = value.number<std::uint32_t>();
            value.number<std::uint32_t>(); // Whether it is perceptually linear: for a lossy compression.
            const auto across = value.number<std::uint32_t>(), down = value.number<std::uint32_t>();
            if (value.failed() || type > 2)
                return exrFormatError("the type of the channel " + std::string(name) +
                                      " is none that OpenEXR has");
            if (across != 1 || down != 1)
                return exrFormatError("the channel " + std::string(name) + " is subsampled");
            for (const ExrHeader::Channel& other : m_header.channels)
                if (other.name == name)
                    return exrFormatError("the channel " + std::string(name) + " occurs twice");
            if (m_header.channels.size() == kMaxExrChannels)
                return exrFormatError("it has more than " + std::to_string(kMaxExrChannels) + " channels");
            m_header.channels.push_back({std::string(name), type == 1 ? 2 : 4, type == 0});
        }
    }

    Result<void> addCompression(std::span<const std::uint8_t> value) {
        if (value.size() != 1 || value[0] >= kCompressions.size())
            return exrFormatError("its compression is none that OpenEXR has");
        if (value[0] > static_cast<int>(Compression::Piz))
            return exrFormatError("its compression is " + std::string(kCompressions[value[0]]) +
                                  ", and none, RLE, ZIPS, ZIP and PIZ are read");
        m_header.compression = static_cast<Compression>(value[0]);
        return {};
    }

    static Result<void> addBox(ByteReader& value, Box& box) {
        for (int* side : {&box.left, &box.top, &box.right, &box.bottom}) {
            *side = value.number<std::int32_t>();
            if (value.failed() || *side < -kMaxCoordinate || *side > kMaxCoordinate)
                return exrFormatError("a window reaches further than " + std::to_string(kMaxCoordinate) +
                                      " texels");
        }
        if (box.width() < 1 || box.height() < 1)
            return Error{"exr.size", "", "a window of the picture is empty", "save it again"};
        return {};
    }

    Result<void> addTiles(std::span<const std::uint8_t> bytes) {
        ByteReader value(bytes);
        const auto width = value.number<std::uint32_t>(), height = value.number<std::uint32_t>();
        if (bytes.size() != 9 || width < 1 || height < 1 || width > 8192 || height > 8192)
            return exrFormatError("its tiles have no sound size");
        if (bytes[8] != 0)
            return exrFormatError("it has tiles of several levels, and those of one level are read");
        m_header.tileWidth = static_cast<int>(width);
        m_header.tileHeight = static_cast<int>(height);
        return {};
    }

    ExrHeader m_header;
    std::set<std::string_view> m_names;
};

int linesOfChunk(Compression compression) {
    return compression == Compression::Zip ? 16 : compression == Compression::Piz ? 32 : 1;
}

/// Where chunks lie in the picture: columns and rows of them, each of that size but for the last ones.
struct Grid {
    bool tiled;
    int chunkWidth, chunkHeight;
    int columns, rows;
    std::size_t count() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
};

Grid gridOf(const ExrHeader& header) {
    const bool tiled = header.tileWidth > 0;
    const int width = tiled ? header.tileWidth : header.data.width();
    const int height = tiled ? header.tileHeight : linesOfChunk(header.compression);
    return {tiled, width, height, (header.data.width() - 1) / width + 1,
            (header.data.height() - 1) / height + 1};
}

/// Whether a run-length code (a count and a texel's byte, or a negative count and as many bytes) unpacks to
/// exactly that many bytes.
bool unpacksTo(std::span<const std::uint8_t> code, std::size_t bytes) {
    std::size_t made = 0;
    for (std::size_t at = 0; at < code.size();) {
        const int count = static_cast<std::int8_t>(code[at]);
        const std::size_t values = count < 0 ? static_cast<std::size_t>(-count) : 1;
        made += count < 0 ? values : static_cast<std::size_t>(count) + 1;
        at += 1 + values;
        if (made > bytes || at > code.size())
            return false;
    }
    return made == bytes;
}

/// A PIZ chunk: the range of a bitmap of 8192 bytes, its bytes, and the length of a Huffman code that begins
/// with 20 bytes.
bool isPiz(std::span<const std::uint8_t> code) {
    ByteReader reader(code);
    const auto first = reader.number<std::uint16_t>(), last = reader.number<std::uint16_t>();
    if (last >= 8192)
        return false;
    if (first <= last)
        reader.take(std::size_t{last} - first + 1);
    const auto length = reader.number<std::uint32_t>();
    return !reader.failed() && length >= 20 && length <= code.size() - reader.at();
}

bool isSoundCode(Compression compression, std::span<const std::uint8_t> code, std::size_t bytes) {
    if (code.size() == bytes) // Stored as it is, where it would not have become smaller.
        return true;
    if (code.size() > bytes || code.size() < 3)
        return false;
    switch (compression) {
    case Compression::None:
        return false;
    case Compression::Rle:
        return unpacksTo(code, bytes);
    case Compression::Piz:
        return isPiz(code);
    default:
        return bytes / 1032 <= code.size(); // Deflate packs no more into a byte.
    }
}

/// The index in the grid of the chunk at that place in the file; nothing if it is broken.
std::optional<std::size_t> readChunk(std::span<const std::uint8_t> file, std::size_t at,
                                     const ExrHeader& header, const Grid& grid) {
    ByteReader reader(file, at);
    int column = 0, row = 0;
    if (grid.tiled) {
        column = reader.number<std::int32_t>();
        row = reader.number<std::int32_t>();
        if (reader.number<std::int32_t>() != 0 || reader.number<std::int32_t>() != 0)
            return {};
    } else {
        const std::int64_t line = std::int64_t{reader.number<std::int32_t>()} - header.data.top;
        if (line < 0 || line % grid.chunkHeight != 0 || line / grid.chunkHeight >= grid.rows)
            return {};
        row = static_cast<int>(line / grid.chunkHeight);
    }
    if (column < 0 || row < 0 || column >= grid.columns || row >= grid.rows)
        return {};
    const auto length = reader.number<std::int32_t>();
    const auto code = reader.take(length < 0 ? file.size() : static_cast<std::size_t>(length));
    const int width = std::min(grid.chunkWidth, header.data.width() - column * grid.chunkWidth);
    const int height = std::min(grid.chunkHeight, header.data.height() - row * grid.chunkHeight);
    std::size_t bytes = 0;
    for (const ExrHeader::Channel& channel : header.channels)
        bytes += static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                 static_cast<std::size_t>(channel.bytes);
    if (reader.failed() || !isSoundCode(header.compression, code, bytes))
        return {};
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) +
           static_cast<std::size_t>(column);
}

/// Each chunk of the picture is in the file, whole and once.
Result<void> checkChunks(std::span<const std::uint8_t> file, std::size_t table, const ExrHeader& header) {
    const Grid grid = gridOf(header);
    if (grid.count() > (file.size() - table) / sizeof(std::uint64_t))
        return exrFormatError("the file is cut off");
    std::vector<bool> found(grid.count());
    ByteReader offsets(file, table);
    const std::size_t end = table + grid.count() * sizeof(std::uint64_t);
    for (std::size_t i = 0; i < grid.count(); ++i) {
        const auto offset = offsets.number<std::uint64_t>();
        std::optional<std::size_t> index;
        if (offset >= end && offset < file.size())
            index = readChunk(file, static_cast<std::size_t>(offset), header, grid);
        if (!index || found[*index])
            return exrFormatError("chunk " + std::to_string(i) + " of its texels is broken or cut off");
        found[*index] = true;
    }
    return {};
}

Result<void> checkSize(const Box& box, int maxSize) {
    if (box.width() <= maxSize && box.height() <= maxSize)
        return {};
    return Error{"exr.size", "",
                 "the picture is " + std::to_string(box.width()) + " x " + std::to_string(box.height()) +
                     " texels, the limit is " + std::to_string(maxSize),
                 "scale it down"};
}

Result<bool> readVersion(ByteReader& reader) {
    if (reader.number<std::uint32_t>() != kMagic)
        return exrFormatError("this is no OpenEXR picture: it does not start as one");
    const auto version = reader.number<std::uint32_t>();
    if (version & kDeep)
        return exrFormatError("it is a deep picture, and flat ones are read");
    if (version & kParts)
        return exrFormatError("it has several parts, and those of one part are read");
    if (reader.failed() || (version & ~(kTiled | kLongNames)) != 2)
        return exrFormatError("its version is not 2");
    return (version & kTiled) != 0;
}

} // namespace

Error exrFormatError(std::string what) {
    return {"exr.format", "", std::move(what),
            "save it again in one part with channels R, G, B or Y, packed by ZIP, or as a Radiance .hdr"};
}

bool isExr(std::span<const std::uint8_t> file) {
    return file.size() >= sizeof kMagic && ByteReader(file).number<std::uint32_t>() == kMagic;
}

std::size_t ExrHeader::chunks() const { return gridOf(*this).count(); }

std::size_t ExrHeader::decodedBytes() const {
    const Grid grid = gridOf(*this);
    const std::size_t texels =
        grid.count() * static_cast<std::size_t>(grid.chunkWidth) * static_cast<std::size_t>(grid.chunkHeight);
    std::size_t bytes = 0;
    for (const Channel& channel : channels)
        bytes += texels * static_cast<std::size_t>(channel.bytes);
    return bytes;
}

Result<ExrHeader> readExrHeader(std::span<const std::uint8_t> file, int maxSize) {
    ByteReader reader(file);
    const Result<bool> tiled = readVersion(reader);
    if (!tiled)
        return tiled.error();
    HeaderParser parser;
    for (;;) {
        const std::string_view name = reader.text(kMaxName);
        if (reader.failed())
            return exrFormatError("its header is broken or cut off");
        if (name.empty())
            break;
        const std::string_view type = reader.text(kMaxName);
        const auto value = reader.take(reader.number<std::uint32_t>());
        if (reader.failed() || type.empty())
            return exrFormatError("its attribute " + std::string(name) + " is broken or cut off");
        if (Result<void> added = parser.add({name, type, value}); !added)
            return added.error();
    }
    Result<ExrHeader> header = parser.finish(*tiled);
    if (!header)
        return header;
    for (const Box& box : {header->data, header->display})
        if (Result<void> checked = checkSize(box, maxSize); !checked)
            return checked.error();
    if (Result<void> checked = checkChunks(file, reader.at(), *header); !checked)
        return checked.error();
    return header;
}

} // namespace franken
