// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "gltf/schema.h"

namespace franken::gltf {
namespace {

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

bool parseText(Source& source, Json& root) {
    if (!checkJson(source))
        return false;
    root = Json::parse(source.jsonText.begin(), source.jsonText.end());
    return root.is_object() || source.fail("gltf.json", "", "the file's JSON is not an object",
                                           "check that the file is a .gltf or .glb");
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

// What an object is, a word in it says, and that it needs a member of that name.
bool checkChoice(Source& source, const Json& object, const std::string& where) {
    const auto& type = object["type"].get_ref<const std::string&>();
    return object.contains(type) || source.fail("gltf.schema", where, "the property " + type + " is missing");
}

bool checkCamera(Source& source, const Json& camera, const std::string& where) {
    if (camera["type"] == "perspective" || camera["type"] == "orthographic")
        return checkChoice(source, camera, where);
    return source.fail("gltf.value", where + "/type", "a camera is perspective or orthographic");
}

bool checkAccessor(Source& source, Json& accessor, std::size_t views, const std::string& where) {
    if (!checkIndex(source, accessor.value("bufferView", kNone), views, where + "/bufferView"))
        return false;
    constexpr std::array<int, 6> kComponents{5120, 5121, 5122, 5123, 5125, 5126};
    const int component = accessor["componentType"].get<int>();
    if (std::find(kComponents.begin(), kComponents.end(), component) == kComponents.end())
        return source.fail("gltf.type", where + "/componentType",
                           "there is no component type " + std::to_string(component));
    constexpr std::array<std::string_view, 7> kTypes{"SCALAR", "VEC2", "VEC3", "VEC4",
                                                     "MAT2",   "MAT3", "MAT4"};
    const auto& type = accessor["type"].get_ref<const std::string&>();
    if (std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end())
        return true;
    source.warn(where + "/type", "the element type " + type + " is not known; nothing can use it");
    accessor = {{"componentType", component}, {"count", 1}, {"type", "MAT2"}}; // which nothing takes
    return true;
}

bool checkStride(Source& source, const Json& view, const std::string& where) {
    const Json& stride = member(view, "byteStride");
    const std::size_t bytes = stride.is_null() ? 4 : stride.get<std::size_t>();
    return (bytes >= 4 && bytes <= 252 && bytes % 4 == 0) ||
           source.fail("gltf.value", where + "/byteStride", "a stride is a multiple of 4 from 4 to 252");
}

bool checkMesh(Source& source, const Json& mesh, std::size_t accessors, const std::string& where) {
    const Json& primitives = mesh["primitives"];
    for (std::size_t i = 0; i < primitives.size(); ++i)
        if (!checkIndex(source, primitives[i].value("indices", kNone), accessors,
                        where + pathOf("primitives", i, "indices")))
            return false;
    return true;
}

bool checkLight(Source& source, const Json& light, const std::string& where) {
    return light["type"] != "spot" || checkChoice(source, light, where);
}

// The rest of what tinygltf refuses, because it says nowhere of which object it speaks.
bool checkRest(Source& source, Json& root) {
    const auto forEach = [](Json& array, const std::string& where, const auto& check) {
        for (std::size_t i = 0; i < array.size(); ++i)
            if (!check(array[i], where + pathOf(i)))
                return false;
        return true;
    };
    const std::size_t views = root["bufferViews"].size(), accessors = root["accessors"].size();
    const char* const kLights = "/extensions/KHR_lights_punctual/lights";
    const auto accessor = [&](Json& object, const std::string& where) {
        return checkAccessor(source, object, views, where);
    };
    const auto view = [&](const Json& object, const std::string& where) {
        return checkStride(source, object, where);
    };
    const auto mesh = [&](const Json& object, const std::string& where) {
        return checkMesh(source, object, accessors, where);
    };
    const auto camera = [&](const Json& object, const std::string& where) {
        return checkCamera(source, object, where);
    };
    const auto light = [&](const Json& object, const std::string& where) {
        return checkLight(source, object, where);
    };
    const Json::json_pointer lights(kLights);
    return forEach(root["accessors"], "/accessors", accessor) &&
           forEach(root["bufferViews"], "/bufferViews", view) && forEach(root["meshes"], "/meshes", mesh) &&
           forEach(root["cameras"], "/cameras", camera) &&
           (!root.contains(lights) || forEach(root[lights], kLights, light));
}

std::string takeString(Json& object, const char* key) {
    return object.contains(key) ? std::move(object[key].get_ref<std::string&>()) : std::string();
}

// Notes where buffers and images come from, and gives tinygltf a byte for each, so that it opens no file,
// decodes no text and looks into no buffer.
bool takeResources(Source& source, Json& root) {
    const char* const kOneByte = "data:application/octet-stream;base64,AA==";
    for (Json& buffer : root["buffers"]) {
        const auto length = buffer["byteLength"].get<std::size_t>();
        const bool hasUri = buffer.contains("uri");
        source.buffers.push_back({takeString(buffer, "uri"), hasUri, length, {}, {}, {}});
        buffer = {{"byteLength", 1}, {"uri", kOneByte}};
    }
    for (Json& image : root["images"]) {
        if (image.contains("bufferView") == image.contains("uri"))
            return source.fail("gltf.schema", pathOf("images", source.images.size()),
                               "an image has either a buffer view or a URI");
        source.images.push_back(
            {takeString(image, "name"), takeString(image, "uri"), image.value("bufferView", kNone), {}, {}});
        image = {{"uri", kOneByte}};
    }
    return true;
}

// tinygltf refuses indices without a view, which glTF allows (they are zero); it gets one that is taken back.
void addPlaceholderView(Source& source, Json& root) {
    source.placeholderView = static_cast<int>(root["bufferViews"].size());
    for (Json& accessor : root["accessors"])
        if (!accessor.contains("bufferView"))
            accessor["bufferView"] = source.placeholderView;
    root["bufferViews"].push_back({{"buffer", 0}, {"byteLength", 1}});
}

// tinygltf's objects are much larger than what JSON says of them, and its arrays grow by doubling: for a
// moment there are up to three places for each element.
bool chargeObjects(Source& source, const Json& root) {
    const auto charge = [&](const Json& array, std::size_t bytes, const std::string& where) {
        return source.charge(array.size(), 3 * bytes, where);
    };
    const Json& lights = member(member(member(root, "extensions"), "KHR_lights_punctual"), "lights");
    for (const Json& mesh : member(root, "meshes"))
        if (!charge(mesh["primitives"], sizeof(tinygltf::Primitive), "/meshes"))
            return false;
    return charge(member(root, "buffers"), sizeof(tinygltf::Buffer) + sizeof(Buffer), "/buffers") &&
           charge(member(root, "bufferViews"), sizeof(tinygltf::BufferView), "/bufferViews") &&
           charge(member(root, "accessors"), sizeof(tinygltf::Accessor), "/accessors") &&
           charge(member(root, "images"), sizeof(tinygltf::Image) + sizeof(EncodedImage), "/images") &&
           charge(member(root, "samplers"), sizeof(tinygltf::Sampler), "/samplers") &&
           charge(member(root, "textures"), sizeof(tinygltf::Texture), "/textures") &&
           charge(member(root, "materials"), sizeof(tinygltf::Material) + sizeof(Material), "/materials") &&
           charge(member(root, "meshes"), sizeof(tinygltf::Mesh), "/meshes") &&
           charge(member(root, "skins"), sizeof(tinygltf::Skin), "/skins") &&
           charge(member(root, "cameras"), sizeof(tinygltf::Camera), "/cameras") &&
           charge(member(root, "nodes"), sizeof(tinygltf::Node), "/nodes") &&
           source.charge(member(root, "nodes").size(), sizeof(Instance), "/nodes") && // reserved
           charge(member(root, "scenes"), sizeof(tinygltf::Scene), "/scenes") &&
           charge(lights, sizeof(tinygltf::Light), "/extensions/KHR_lights_punctual/lights");
}

} // namespace

bool readJson(Source& source, std::string& text) {
    Json root;
    if (!parseText(source, root) || !checkVersion(source, root) || !checkExtensions(source, root) ||
        !checkDraco(source, root))
        return false;
    makeIntegers(root);
    if (!member(root, "animations").empty())
        source.warn("/animations", "animations are not played; the file is shown at rest");
    if (!checkSchema(source, root) || !checkRest(source, root) || !chargeObjects(source, root) ||
        !takeResources(source, root))
        return false;
    addPlaceholderView(source, root);
    text = root.dump(-1, ' ', false, Json::error_handler_t::replace);
    return true;
}

} // namespace franken::gltf
