// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

#include "gltf_internal.h"

namespace franken::gltf {
namespace {

using Json = nlohmann::json;

constexpr int kMaxDepth = 64;
constexpr std::array<std::string_view, 5> kKnownExtensions{
    "KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_materials_unlit", "KHR_mesh_quantization",
    "KHR_texture_transform"};

bool isKnown(const std::string& extension) {
    return std::find(kKnownExtensions.begin(), kKnownExtensions.end(), extension) != kKnownExtensions.end();
}

/// The member, or null where there is none or `object` is not an object.
const Json& member(const Json& object, const char* key) {
    static const Json kNull;
    const auto found = object.find(key); // end() for all but objects
    return found == object.end() ? kNull : *found;
}

// Counted on the text, before anything is built from it, for tinygltf goes down by recursion.
bool isTooDeep(std::span<const std::uint8_t> text) {
    int depth = 0;
    bool inString = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = static_cast<char>(text[i]);
        if (inString && c == '\\')
            ++i; // what is escaped ends no string
        else if (c == '"')
            inString = !inString;
        else if (!inString && (c == '{' || c == '[') && ++depth > kMaxDepth)
            return true;
        else if (!inString && (c == '}' || c == ']'))
            --depth;
    }
    return false;
}

bool parseText(Source& source, Json& root) {
    if (isTooDeep(source.jsonText))
        return source.fail("gltf.limit", "",
                           "the JSON is nested more than " + std::to_string(kMaxDepth) + " deep");
    try {
        root = Json::parse(source.jsonText.begin(), source.jsonText.end());
    } catch (const Json::exception& exception) { // a syntax error, or a number that no double holds
        return source.fail("gltf.json", "",
                           std::string("the file's JSON cannot be read: ") + exception.what(),
                           "check that the file is a .gltf or .glb, and complete");
    }
    return root.is_object() ||
           source.fail("gltf.json", "", "the file's JSON is not an object", std::string(kFixExporter));
}

bool checkVersion(Source& source, const Json& root) {
    const Json& version = member(member(root, "asset"), "version");
    if (!version.is_string())
        return source.fail("gltf.version", "/asset/version", "the file does not say which glTF version it is",
                           "only glTF 2.0 is read");
    return version.get_ref<const std::string&>().starts_with("2.") ||
           source.fail("gltf.version", "/asset/version",
                       "the file is glTF " + version.get_ref<const std::string&>(),
                       "only glTF 2.0 is read: convert the file");
}

bool extensionError(Source& source, const std::string& where, const std::string& name) {
    return source.fail("gltf.extension", where,
                       "the file requires the extension " + name + ", which is not built in",
                       "export the file without " + name);
}

bool checkExtensions(Source& source, const Json& root) {
    const Json& required = member(root, "extensionsRequired");
    for (std::size_t i = 0; required.is_array() && i < required.size(); ++i) {
        const std::string name =
            required[i].is_string() ? required[i].get<std::string>() : required[i].dump();
        if (!isKnown(name))
            return extensionError(source, pathOf("extensionsRequired", i), name);
    }
    const Json& used = member(root, "extensionsUsed");
    for (std::size_t i = 0; used.is_array() && i < used.size(); ++i)
        if (used[i].is_string() && !isKnown(used[i].get<std::string>()))
            source.warn(pathOf("extensionsUsed", i),
                        "the extension " + used[i].get<std::string>() + " is not known and left out");
    return true;
}

// Some exporters declare Draco as optional and leave out what it would be optional to.
bool checkDraco(Source& source, const Json& root) {
    const char* const kDraco = "KHR_draco_mesh_compression";
    const Json &meshes = member(root, "meshes"), &accessors = member(root, "accessors");
    for (std::size_t m = 0; meshes.is_array() && m < meshes.size(); ++m)
        for (const Json& primitive : member(meshes[m], "primitives")) {
            const Json& position = member(member(primitive, "attributes"), "POSITION");
            if (member(member(primitive, "extensions"), kDraco).is_null() || !position.is_number_unsigned() ||
                position.get<std::size_t>() >= accessors.size() || !accessors.is_array())
                continue;
            if (member(accessors[position.get<std::size_t>()], "bufferView").is_null())
                return extensionError(source, pathOf("meshes", m), kDraco);
        }
    return true;
}

// 1.0 is an integer in JSON, but not to tinygltf. The depth was checked.
void makeIntegers(Json& value) {
    if (value.is_structured()) {
        for (Json& child : value)
            makeIntegers(child);
    } else if (value.is_number_float()) {
        const double number = value.get<double>();
        if (std::trunc(number) != number || std::fabs(number) >= 9007199254740992.0) // 2^53: exact below it
            return;
        if (number < 0.0)
            value = static_cast<std::int64_t>(number);
        else
            value = static_cast<std::uint64_t>(number);
    }
}

std::string takeUri(Json& object) {
    const Json uri = member(object, "uri");
    return uri.is_string() ? uri.get<std::string>() : std::string();
}

// Notes where buffers and images come from, and gives tinygltf a byte for each, so that it opens no file,
// decodes no text and looks into no buffer.
bool takeResources(Source& source, Json& root) {
    const char* const kOneByte = "data:application/octet-stream;base64,AA==";
    for (std::size_t i = 0; member(root, "buffers").is_array() && i < root["buffers"].size(); ++i) {
        Json& buffer = root["buffers"][i];
        const Json& length = member(buffer, "byteLength");
        if (!length.is_number_unsigned())
            return source.fail("gltf.type", pathOf("buffers", i, "byteLength"),
                               "a buffer has a length in bytes", std::string(kFixExporter));
        source.buffers.push_back({takeUri(buffer), length.get<std::size_t>(), {}, {}, {}});
        buffer = {{"byteLength", 1}, {"uri", kOneByte}};
    }
    for (std::size_t i = 0; member(root, "images").is_array() && i < root["images"].size(); ++i) {
        Json& image = root["images"][i];
        const Json& view = member(image, "bufferView");
        const std::string uri = takeUri(image);
        if (view.is_number() == !uri.empty())
            return source.fail("gltf.type", pathOf("images", i), "an image has either a buffer view or a URI",
                               std::string(kFixExporter));
        const Json& name = member(image, "name");
        source.images.push_back({name.is_string() ? name.get<std::string>() : "",
                                 uri,
                                 view.is_number() ? view.get<int>() : kNone,
                                 {},
                                 {}});
        image = {{"uri", kOneByte}};
    }
    return true;
}

// tinygltf refuses indices without a view, which glTF allows (they are zero); it gets one that is taken back.
bool addPlaceholderView(Source& source, Json& root) {
    Json& views = root["bufferViews"];
    if (!views.is_array() && !views.is_null())
        return source.fail("gltf.type", "/bufferViews", "an array is expected here",
                           std::string(kFixExporter));
    source.placeholderView = static_cast<int>(views.size());
    for (std::size_t i = 0; member(root, "accessors").is_array() && i < root["accessors"].size(); ++i) {
        Json& accessor = root["accessors"][i];
        if (member(accessor, "bufferView") == source.placeholderView)
            return checkPresent(source, source.placeholderView, views.size(),
                                pathOf("accessors", i, "bufferView"));
        if (accessor.is_object() && !accessor.contains("bufferView"))
            accessor["bufferView"] = source.placeholderView;
    }
    views.push_back({{"buffer", 0}, {"byteLength", 1}});
    return true;
}

} // namespace

bool readJson(Source& source, std::string& text) {
    Json root;
    if (!parseText(source, root) || !checkVersion(source, root) || !checkExtensions(source, root) ||
        !checkDraco(source, root))
        return false;
    makeIntegers(root);
    if (!takeResources(source, root) || !addPlaceholderView(source, root))
        return false;
    text = root.dump(-1, ' ', false, Json::error_handler_t::replace);
    return true;
}

} // namespace franken::gltf
