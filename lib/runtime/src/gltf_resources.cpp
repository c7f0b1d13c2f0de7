// SPDX-License-Identifier: MIT
#include "gltf_internal.h"

namespace franken::gltf {
namespace {

// glTF 2.0, 4.4.3.3: the binary chunk is the first buffer, if that has no URI.
void loadBuffer(Source& source, std::size_t index, const std::filesystem::path& folder) {
    Buffer& buffer = source.buffers[index];
    std::span<const std::uint8_t> bytes;
    if (!buffer.uri.empty()) {
        buffer.storage = readUri(buffer.uri, folder, source.options.maxFileBytes, buffer.problem);
        bytes = buffer.storage;
    } else if (index == 0) {
        bytes = source.binaryChunk;
    }
    if (!buffer.problem.empty())
        return;
    if (bytes.size() < buffer.length || bytes.empty())
        buffer.problem = "only " + std::to_string(bytes.size()) + " of its " + std::to_string(buffer.length) +
                         " bytes are there";
    else
        buffer.bytes = bytes.first(buffer.length);
}

} // namespace

void loadResources(Source& source, const std::filesystem::path& folder) {
    for (std::size_t i = 0; i < source.buffers.size(); ++i)
        loadBuffer(source, i, folder);
    for (EncodedImage& image : source.images)
        if (image.view == kNone)
            image.bytes = readUri(image.uri, folder, source.options.maxFileBytes, image.problem);
}

} // namespace franken::gltf
