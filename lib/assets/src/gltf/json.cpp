// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "gltf/gate.h"

namespace franken::gltf {

const Json& member(const Json& object, const char* key) {
    static const Json kNull;
    const auto found = object.find(key); // end() for all but objects
    return found == object.end() ? kNull : *found;
}

namespace {

bool parseText(Source& source, Json& root) {
    if (!checkJson(source))
        return false;
    root = Json::parse(source.jsonText.begin(), source.jsonText.end());
    return root.is_object() || source.fail("gltf.json", "", "the file's JSON is not an object",
                                           "check that the file is a .gltf or .glb");
}

// "2.1" as {2, 1}, and a number as the text that was meant.
std::optional<std::pair<int, int>> parseVersion(const Json& version) {
    const std::string text = version.is_string()   ? version.get<std::string>()
                             : version.is_number() ? version.dump()
                                                   : "";
    std::pair<int, int> numbers{0, 0};
    const char* const end = text.data() + text.size();
    const auto major = std::from_chars(text.data(), end, numbers.first);
    if (major.ec != std::errc())
        return std::nullopt;
    if (major.ptr != end && *major.ptr == '.')
        std::from_chars(major.ptr + 1, end, numbers.second);
    return numbers;
}

bool checkVersion(Source& source, Json& root) {
    const Json& asset = member(root, "asset");
    const auto version = parseVersion(member(asset, "version"));
    if (!version)
        return source.fail("gltf.version", "/asset/version", "the file does not say which glTF version it is",
                           "only glTF 2.0 is read");
    if (version->first != 2)
        return source.fail("gltf.version", "/asset/version",
                           "the file is glTF " + member(asset, "version").dump(),
                           "only glTF 2.0 is read: convert the file");
    if (parseVersion(member(asset, "minVersion")) > std::pair(2, 0))
        return source.fail("gltf.version", "/asset/minVersion",
                           "the file needs a reader of glTF " + member(asset, "minVersion").dump(),
                           "only glTF 2.0 is read: convert the file");
    if (!member(asset, "version").is_string()) {
        source.warn(kMended, "/asset/version", "a version is a string");
        root["asset"]["version"] = "2.0";
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

bool isExtent(const Json& accessor) {
    const Json &least = member(accessor, "min"), &most = member(accessor, "max");
    const auto isNumber = [](const Json& value) { return value.is_number(); };
    for (const Json* values : {&least, &most})
        if (!values->is_null() &&
            (!values->is_array() || !std::all_of(values->begin(), values->end(), isNumber)))
            return false;
    if (least.is_null() || most.is_null())
        return true;
    return least.size() == most.size() &&
           std::equal(least.begin(), least.end(), most.begin(), std::less_equal<>());
}

// Boxes are measured: `min` and `max` are never read.
void warnOfExtents(const Source& source, const Json& root) {
    const Json& accessors = member(root, "accessors");
    for (std::size_t i = 0; accessors.is_array() && i < accessors.size(); ++i)
        if (!isExtent(accessors[i]))
            source.warn(kMended, pathOf("accessors", i), "min and max make no sense; the box is measured");
}

// What an object is, a word in it says, and that it needs a member of that name.
bool checkChoice(Source& source, const Json& object, const std::string& where) {
    const auto& type = object["type"].get_ref<const std::string&>();
    return object.contains(type) || source.fail("gltf.schema", where, "the property " + type + " is missing");
}

bool checkCamera(Source& source, Json& camera, const std::string& where) {
    const bool known = camera["type"] == "perspective" || camera["type"] == "orthographic";
    if (known ? checkChoice(source, camera, where)
              : source.fail("gltf.value", where + "/type", "a camera is perspective or orthographic"))
        return true;
    camera = {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}};
    return source.defer(where);
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
    return std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end() ||
           source.fail("gltf.type", where + "/type", "there is no element type " + type);
}

/// checkAccessor(); a faulty one becomes an empty one.
bool checkOrEmpty(Source& source, Json& accessor, std::size_t views, const std::string& where) {
    if (checkAccessor(source, accessor, views, where))
        return true;
    accessor = {{"componentType", 5121}, {"count", 1}, {"type", "SCALAR"}};
    return source.defer(where);
}

void warnOfStride(Source& source, const Json& view, const std::string& where) {
    const Json& stride = member(view, "byteStride");
    const std::size_t bytes = stride.is_null() ? 4 : stride.get<std::size_t>();
    if (bytes < 4 || bytes > 252 || bytes % 4 != 0)
        source.warn(kMended, where + "/byteStride",
                    bytes == 0 ? "a stride of 0 stands for elements without gaps"
                               : "a stride is a multiple of 4 from 4 to 252");
}

bool checkMesh(Source& source, const Json& mesh, std::size_t accessors, const std::string& where) {
    const Json& primitives = mesh["primitives"];
    for (std::size_t i = 0; i < primitives.size(); ++i)
        if (!checkIndex(source, primitives[i].value("indices", kNone), accessors,
                        where + pathOf("primitives", i, "indices")))
            return false;
    return true;
}

bool checkLight(Source& source, Json& light, const std::string& where) {
    if (light["type"] != "spot" || checkChoice(source, light, where))
        return true;
    light = {{"type", "point"}};
    return source.defer(where);
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
        return checkOrEmpty(source, object, views, where);
    };
    const auto view = [&](const Json& object, const std::string& where) {
        warnOfStride(source, object, where);
        return true;
    };
    const auto mesh = [&](const Json& object, const std::string& where) {
        return checkMesh(source, object, accessors, where);
    };
    const auto camera = [&](Json& object, const std::string& where) {
        return checkCamera(source, object, where);
    };
    const auto light = [&](Json& object, const std::string& where) {
        return checkLight(source, object, where);
    };
    const Json::json_pointer lights(kLights);
    return forEach(root["accessors"], "/accessors", accessor) &&
           forEach(root["bufferViews"], "/bufferViews", view) && forEach(root["meshes"], "/meshes", mesh) &&
           forEach(root["cameras"], "/cameras", camera) &&
           (!root.contains(lights) || forEach(root[lights], kLights, light));
}

} // namespace

bool readJson(Source& source, Json& root) {
    if (!parseText(source, root) || !checkVersion(source, root) || !checkExtensions(source, root))
        return false;
    makeIntegers(root);
    warnOfExtents(source, root);
    return checkSchema(source, root) && checkRest(source, root);
}

} // namespace franken::gltf
