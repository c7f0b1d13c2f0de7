// SPDX-License-Identifier: MIT
#include "malformed/malformed.h"

namespace {

using Json = GltfBuilder::Json;

constexpr std::size_t kJsonLength = 12; ///< Where a .glb says how long its first chunk is.

std::string word(std::uint32_t value) {
    std::string bytes;
    for (int byte = 0; byte < 4; ++byte)
        bytes += static_cast<char>(value >> 8 * byte);
    return bytes;
}

std::string with(std::string file, std::size_t offset, std::uint32_t value) {
    return file.replace(offset, 4, word(value));
}

/// "glTF", version 2, and the right length before `chunks`.
std::string container(const std::string& chunks) {
    return "glTF" + word(2) + word(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

std::string chunk(const std::string& type, const std::string& data) {
    return word(static_cast<std::uint32_t>(data.size())) + type + data;
}

std::string text(const Json& json) { return json.dump(); }

Json changed(const char* pointer, const Json& value) {
    Json json = Json::parse(soundModel().bytes(false));
    json[Json::json_pointer(pointer)] = value;
    return json;
}

} // namespace

std::vector<MalformedFile> malformedContainers() {
    const std::string sound = soundModel().bytes(true), bin("BIN\0", 4);
    const std::size_t jsonLength =
        static_cast<unsigned char>(sound[12]) + 256u * static_cast<unsigned char>(sound[13]);
    const std::size_t binHeader = 20 + jsonLength;
    const std::string json = chunk("JSON", sound.substr(20, jsonLength)),
                      empty = chunk("JSON", R"({"asset":{"version":"2.0"}})");
    const char* const kCode = "gltf.container";
    return {
        {"container/empty-file", "glb", "", "gltf.json"},
        {"container/magic-only", "glb", "glTF", kCode},
        {"container/half-a-magic", "glb", "gl", "gltf.json"},
        {"container/header-cut", "glb", sound.substr(0, 11), kCode},
        {"container/header-only", "glb", sound.substr(0, 12), kCode},
        {"container/version-1", "glb", with(sound, 4, 1), "gltf.version"},
        {"container/version-3", "glb", with(sound, 4, 3), "gltf.version"},
        {"container/length-beyond-the-file", "glb", with(sound, 8, 0x7FFFFFFF), ""},
        {"container/length-of-all-ones", "glb", with(sound, 8, 0xFFFFFFFF), ""},
        {"container/length-zero", "glb", with(sound, 8, 0), kCode},
        {"container/length-ends-in-the-json", "glb", with(sound, 8, 100), kCode},
        {"container/no-chunk", "glb", container(""), kCode},
        {"container/chunk-header-cut", "glb", container("\4\0\0"), kCode},
        {"container/json-longer-than-the-file", "glb", with(sound, kJsonLength, 0x00FFFFFF), kCode},
        {"container/json-length-of-all-ones", "glb", with(sound, kJsonLength, 0xFFFFFFFF), kCode},
        {"container/json-length-too-short", "glb", with(sound, kJsonLength, 64), kCode},
        {"container/json-chunk-empty", "glb", container(chunk("JSON", "")), "gltf.json"},
        {"container/data-before-json", "glb", container(chunk(bin, "data") + empty), kCode},
        {"container/first-chunk-of-unknown-type", "glb", container(chunk("ABCD", "data") + empty), kCode},
        {"container/data-longer-than-the-file", "glb", with(sound, binHeader, 0x7FFFFFFF), kCode},
        {"container/data-header-cut", "glb", container(json + "\4\0\0\0BI"), kCode},
        {"container/data-shorter-than-the-buffer", "glb", container(json + chunk(bin, "data")),
         "gltf.buffer"},
        {"container/data-missing", "glb", container(json), "gltf.buffer"},
        {"container/data-empty", "glb", container(json + chunk(bin, "")), "gltf.buffer"},
        {"container/second-json-chunk", "glb", container(json + empty), "gltf.buffer"},
        {"container/third-chunk-unknown", "glb", container(sound.substr(12) + chunk("ABCD", "data")), ""},
        {"container/bytes-behind-the-end", "glb", sound + "behind", ""},
    };
}

std::vector<MalformedFile> malformedJson() {
    const std::string sound = soundModel().bytes(false);
    const std::string head = R"({"asset":{"version":"2.0"},"extras":)";
    const auto nested = [&](int depth, const char* open, const char* close) {
        std::string json = head;
        for (int i = 0; i < depth; ++i)
            json += open;
        json += "0";
        for (int i = 0; i < depth; ++i)
            json += close;
        return json + "}";
    };
    const auto extras = [&](const std::string& value) { return head + value + "}"; };
    const char* const kCode = "gltf.json";
    return {
        {"json/empty", "gltf", "", kCode},
        {"json/no-json", "gltf", "solid cube\nfacet normal 0 0 1\n", kCode},
        {"json/zeros", "gltf", std::string(1000, '\0'), kCode},
        {"json/cut-in-half", "gltf", sound.substr(0, sound.size() / 2), kCode},
        {"json/last-brace-missing", "gltf", sound.substr(0, sound.size() - 1), kCode},
        {"json/text-behind-the-end", "gltf", sound + "}", kCode},
        {"json/zero-byte-behind-the-end", "gltf", sound + std::string(1, '\0'), ""},
        {"json/string-not-closed", "gltf", extras("\"open"), kCode},
        {"json/string-of-invalid-utf8", "gltf", extras("\"\xC3\x28\""), kCode},
        {"json/string-of-a-lone-surrogate", "gltf", extras(R"("\uD800")"), kCode},
        {"json/string-with-a-line-feed", "gltf", extras("\"a\nb\""), kCode},
        {"json/number-beyond-doubles", "gltf", extras("1e999"), kCode},
        {"json/number-nan", "gltf", extras("NaN"), kCode},
        {"json/number-with-a-leading-zero", "gltf", extras("0123"), kCode},
        {"json/comment", "gltf", "/* made by hand */" + sound, kCode},
        {"json/comma-too-many", "gltf", extras("[1,]"), kCode},
        {"json/byte-order-mark", "gltf", "\xEF\xBB\xBF" + sound, ""},
        {"json/key-twice", "gltf", R"({"asset":{"version":"1.0"},"asset":{"version":"2.0"}})", ""},
        {"json/root-is-an-array", "gltf", "[" + sound + "]", kCode},
        {"json/root-is-a-string", "gltf", "\"glTF\"", kCode},
        {"json/root-is-null", "gltf", "null", kCode},
        {"json/60-deep", "gltf", nested(60, "[", "]"), ""},
        {"json/65-arrays-deep", "gltf", nested(65, "[", "]"), "gltf.limit"},
        {"json/a-million-arrays-deep", "gltf", nested(1000000, "[", "]"), "gltf.limit"},
        {"json/a-million-objects-deep", "gltf", nested(1000000, "{\"a\":", "}"), "gltf.limit"},
        {"json/a-million-brackets-unclosed", "gltf", head + std::string(1000000, '['), "gltf.limit"},
        {"version/asset-missing", "gltf", "{}", "gltf.version"},
        {"version/asset-is-null", "gltf", R"({"asset":null})", "gltf.version"},
        {"version/is-a-number", "gltf", R"({"asset":{"version":2.0}})", ""},
        {"version/needs-2.1", "gltf", R"({"asset":{"version":"2.1","minVersion":"2.1"}})", "gltf.version"},
        {"version/needs-2.1-as-a-number", "gltf", R"({"asset":{"version":"2.1","minVersion":2.1}})",
         "gltf.version"},
        {"version/needs-2.0", "gltf", R"({"asset":{"version":"2.1","minVersion":"2.0"}})", ""},
        {"version/is-1.0", "gltf", R"({"asset":{"version":"1.0"}})", "gltf.version"},
        {"version/is-3.0", "gltf", R"({"asset":{"version":"3.0"}})", "gltf.version"},
        {"version/is-empty", "gltf", R"({"asset":{"version":""}})", "gltf.version"},
        {"extension/required-and-unknown", "gltf", text(changed("/extensionsRequired/0", "VENDOR_odd")),
         "gltf.extension"},
        {"extension/required-is-a-number", "gltf", text(changed("/extensionsRequired/0", 7)),
         "gltf.extension"},
        {"extension/name-steers-a-terminal", "gltf", text(changed("/extensionsRequired/0", "\x1B[2J\nroot")),
         "gltf.extension"},
        {"extension/used-and-unknown", "gltf", text(changed("/extensionsUsed/0", "VENDOR_odd")), ""},
        {"extension/draco-without-fallback", "gltf",
         text(changed("/meshes/0/primitives",
                      {{{"attributes", {{"POSITION", 8}}},
                        {"extensions", {{"KHR_draco_mesh_compression", Json::object()}}}}})),
         "gltf.extension"},
    };
}
