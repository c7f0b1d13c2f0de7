// SPDX-License-Identifier: MIT
#include <algorithm>

#include "gltf/gate.h"

namespace franken::gltf {
namespace {

/// Reads what a URI names; where it cannot be had, says why.
bool fetch(Source& source, std::string& uri, const std::filesystem::path* folder, const std::string& where,
           std::vector<std::uint8_t>& bytes, std::string& problem) {
    Result<UriContents> read = readUri(uri, folder, std::min(source.options.maxFileBytes, source.room()));
    if (read) {
        bytes = std::move(read->bytes);
        if (!read->file.empty())
            source.files.push_back(std::move(read->file));
        if (isDataUri(uri))
            uri = {}; // gives its memory back
        else if (uri.find('\\') != std::string::npos)
            source.warn(kMended, where, "the URI has a backslash, which is read as a slash");
        return source.charge(bytes.size(), 1, where);
    }
    problem = read.error().what;
    return read.error().code != "file.size" ||
           source.fail("gltf.limit", where, problem,
                       "make the file smaller, or raise the limits of LoadOptions");
}

// glTF 2.0, 4.4.3.3: the binary chunk is the first buffer, if that has no URI.
bool loadBuffer(Source& source, std::size_t index, const std::filesystem::path* folder) {
    Buffer& buffer = source.buffers[index];
    std::span<const std::uint8_t> bytes;
    if (!buffer.uri.empty()) {
        if (!fetch(source, buffer.uri, folder, pathOf("buffers", index), buffer.storage, buffer.problem))
            return false;
        bytes = buffer.storage;
    } else if (index == 0) {
        bytes = source.binaryChunk;
    }
    if (!buffer.problem.empty())
        return true;
    if (bytes.size() < buffer.length || bytes.empty())
        buffer.problem = "only " + std::to_string(bytes.size()) + " of its " + std::to_string(buffer.length) +
                         " bytes are there";
    else
        buffer.bytes = bytes.first(buffer.length);
    return true;
}

} // namespace

bool loadResources(Source& source, const std::filesystem::path* folder) {
    for (std::size_t i = 0; i < source.buffers.size(); ++i)
        if (!loadBuffer(source, i, folder))
            return false;
    for (std::size_t i = 0; i < source.images.size(); ++i) {
        EncodedImage& image = source.images[i];
        if (image.view == kNone &&
            !fetch(source, image.uri, folder, pathOf("images", i), image.bytes, image.problem))
            return false;
    }
    return true;
}

} // namespace franken::gltf
