// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstring>

#include <nlohmann/json.hpp>

#include "gltf_internal.h"

namespace franken::gltf {
namespace {

using Json = nlohmann::json;

constexpr int kMaxDepth = 64;
constexpr std::uint32_t kMagic = 0x46546C67;     // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A; // "JSON"
constexpr std::size_t kHeaderSize = 12, kChunkHeaderSize = 8;

constexpr std::array<std::string_view, 5> kKnownExtensions{
    "KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_materials_unlit", "KHR_mesh_quantization",
    "KHR_texture_transform"};

std::uint32_t word(std::span<const std::uint8_t> bytes, std::size_t offset) {
    return bytes[offset] | bytes[offset + 1] << 8 | bytes[offset + 2] << 16 |
           static_cast<std::uint32_t>(bytes[offset + 3]) << 24;
}

// glTF 2.0, 4.4: a header of three words, then chunks of length, type and data. Only the first two are used.
bool findJsonChunk(Source& source, std::span<const std::uint8_t> bytes, std::span<const std::uint8_t>& json) {
    const auto fail = [&source](const char* what) {
        return source.fail("gltf.container", "", what, "the file is cut or damaged: copy or export it again");
    };
    if (bytes.size() < kHeaderSize + kChunkHeaderSize)
        return fail("the .glb ends before its first chunk");
    if (word(bytes, 4) != 2)
        return source.fail("gltf.version", "",
                           "the .glb has container version " + std::to_string(word(bytes, 4)),
                           "only glTF 2.0 is read: convert the file");
    const std::size_t length = word(bytes, 8);
    if (length > bytes.size())
        return fail("the .glb is shorter than its header says");
    std::size_t offset = kHeaderSize;
    for (int chunk = 0; chunk < 2 && offset < length; ++chunk) {
        if (length - offset < kChunkHeaderSize)
            return fail("the .glb ends inside a chunk's header");
        const std::size_t size = word(bytes, offset);
        if (size > length - offset - kChunkHeaderSize)
            return fail("a chunk of the .glb is longer than the file");
        if (chunk == 0 && word(bytes, offset + 4) != kJsonChunk)
            return fail("the first chunk of the .glb is not JSON");
        if (chunk == 0)
            json = bytes.subspan(offset + kChunkHeaderSize, size);
        offset += kChunkHeaderSize + size;
    }
    return true;
}

bool checkVersion(Source& source, const Json& root) {
    const auto version = root.value("/asset/version"_json_pointer, Json());
    if (!version.is_string())
        return source.fail("gltf.version", "/asset/version", "the file does not say which glTF version it is",
                           "only glTF 2.0 is read");
    if (!version.get_ref<const std::string&>().starts_with("2."))
        return source.fail("gltf.version", "/asset/version",
                           "the file is glTF " + version.get_ref<const std::string&>(),
                           "only glTF 2.0 is read: convert the file");
    return true;
}

bool isKnown(const std::string& extension) {
    return std::find(kKnownExtensions.begin(), kKnownExtensions.end(), extension) != kKnownExtensions.end();
}

bool checkExtensions(Source& source, const Json& root) {
    const Json required = root.value("extensionsRequired", Json::array());
    for (std::size_t i = 0; i < required.size() && required.is_array(); ++i) {
        if (!required[i].is_string())
            return source.fail("gltf.json", pathOf("extensionsRequired", i),
                               "an extension's name is not a string");
        const std::string& name = required[i].get_ref<const std::string&>();
        if (!isKnown(name))
            return source.fail("gltf.extension", pathOf("extensionsRequired", i),
                               "the file requires the extension " + name + ", which is not built in",
                               "export the file without " + name);
    }
    const Json used = root.value("extensionsUsed", Json::array());
    for (std::size_t i = 0; i < used.size() && used.is_array(); ++i)
        if (used[i].is_string() && !isKnown(used[i].get_ref<const std::string&>()))
            source.warn(pathOf("extensionsUsed", i), "the extension " +
                                                         used[i].get_ref<const std::string&>() +
                                                         " is not known and left out");
    return true;
}

} // namespace

bool isBinary(std::span<const std::uint8_t> bytes) { return bytes.size() >= 4 && word(bytes, 0) == kMagic; }

bool checkContainer(Source& source, std::span<const std::uint8_t> bytes) {
    std::span<const std::uint8_t> text = bytes;
    if (isBinary(bytes) && !findJsonChunk(source, bytes, text))
        return false;
    // What is nested too deeply is dropped while parsing, for tinygltf goes down by recursion.
    int deepest = 0;
    const auto measure = [&deepest](int depth, Json::parse_event_t, Json&) {
        deepest = std::max(deepest, depth);
        return depth <= kMaxDepth;
    };
    const Json root = Json::parse(text.begin(), text.end(), measure, false);
    if (deepest > kMaxDepth)
        return source.fail("gltf.limit", "",
                           "the JSON is nested more than " + std::to_string(kMaxDepth) + " deep");
    if (!root.is_object())
        return source.fail("gltf.json", "", "the file is not glTF: there is no JSON object in it",
                           "check that it is a .gltf or .glb, and complete");
    return checkVersion(source, root) && checkExtensions(source, root);
}

} // namespace franken::gltf
