// SPDX-License-Identifier: MIT
#include <algorithm>

#include "gltf/gate.h"

namespace franken::gltf {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67;     // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A; // "JSON"
constexpr std::uint32_t kDataChunk = 0x004E4942; // "BIN"
constexpr std::size_t kHeaderSize = 12, kChunkHeaderSize = 8;

std::uint32_t word(std::span<const std::uint8_t> bytes, std::size_t offset) {
    return bytes[offset] | bytes[offset + 1] << 8 | bytes[offset + 2] << 16 |
           static_cast<std::uint32_t>(bytes[offset + 3]) << 24;
}

// The chunk at `offset`, which is moved behind it.
bool nextChunk(Source& source, std::span<const std::uint8_t> bytes, std::size_t& offset, std::uint32_t& type,
               std::span<const std::uint8_t>& chunk) {
    if (bytes.size() - offset < kChunkHeaderSize)
        return source.fail("gltf.container", "", "the .glb ends inside a chunk's header", kDamaged);
    const std::size_t size = word(bytes, offset);
    type = word(bytes, offset + 4);
    offset += kChunkHeaderSize;
    if (size > bytes.size() - offset)
        return source.fail("gltf.container", "", "a chunk of the .glb is longer than the file", kDamaged);
    chunk = bytes.subspan(offset, size);
    offset += size;
    return true;
}

// glTF 2.0, 4.4.3: the binary chunk is the second or there is none. Others behind it mean nothing to us.
bool openBinaryChunk(Source& source, std::span<const std::uint8_t> bytes, std::size_t offset) {
    std::uint32_t type = 0;
    std::span<const std::uint8_t> data;
    for (bool second = true; offset < bytes.size(); second = false) {
        if (!second && bytes.size() - offset < kChunkHeaderSize)
            return true; // padding
        if (!nextChunk(source, bytes, offset, type, data))
            return false;
        if (type == kDataChunk && !second)
            return source.fail("gltf.container", "", "the binary chunk of the .glb is not its second chunk");
        if (type == kDataChunk) {
            source.binaryChunk = data;
            return true;
        }
    }
    return true;
}

// A file that was cut is shorter than its header says as well; but then no chunk is whole behind the JSON.
bool checkLength(Source& source, std::size_t declared) {
    if (declared <= source.bytes.size())
        return true;
    if (source.binaryChunk.empty())
        return source.fail("gltf.container", "", "the .glb is shorter than its header says", kDamaged);
    source.warn(kMended, "", "the .glb is shorter than its header says, but its chunks are whole");
    return true;
}

} // namespace

// glTF 2.0, 4.4: a header of three words (magic, version, length), then chunks of length, type and data.
bool openContainer(Source& source) {
    std::span<const std::uint8_t> bytes = source.bytes;
    source.jsonText = bytes;
    if (bytes.size() < 4 || word(bytes, 0) != kMagic)
        return true; // the file is the JSON itself
    if (bytes.size() < kHeaderSize)
        return source.fail("gltf.container", "", "the .glb ends inside its header", kDamaged);
    if (word(bytes, 4) != 2)
        return source.fail("gltf.version", "",
                           "the .glb has container version " + std::to_string(word(bytes, 4)),
                           "only glTF 2.0 is read: convert the file");
    const std::size_t declared = word(bytes, 8);
    bytes = bytes.first(std::min(declared, bytes.size()));
    std::size_t offset = kHeaderSize;
    std::uint32_t type = 0;
    if (offset > bytes.size() || !nextChunk(source, bytes, offset, type, source.jsonText) ||
        type != kJsonChunk)
        return source.fail("gltf.container", "", "the .glb does not begin with a JSON chunk", kDamaged);
    return openBinaryChunk(source, bytes, offset) && checkLength(source, declared);
}

} // namespace franken::gltf
