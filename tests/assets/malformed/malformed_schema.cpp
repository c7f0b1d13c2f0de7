// SPDX-License-Identifier: MIT
#include <algorithm>
#include <functional>
#include <set>

#include "malformed/malformed.h"

namespace {

using Json = GltfBuilder::Json;
using Pointer = Json::json_pointer;

/// Calls visit(pointer, value) for all that is in `value`; of an array only for the first element.
void walk(const Json& value, const Pointer& at,
          const std::function<void(const Pointer&, const Json&)>& visit) {
    if (!at.empty())
        visit(at, value);
    if (value.is_object())
        for (const auto& [key, child] : value.items())
            walk(child, at / key, visit);
    else if (value.is_array() && !value.empty())
        walk(value[0], at / 0, visit);
}

bool isIndex(const Pointer& pointer, const Json& value) {
    static const std::set<std::string> kNames{
        "bufferView", "buffer", "sampler", "source",   "index", "material", "mesh",
        "skin",       "camera", "light",   "skeleton", "scene", "indices",  "inverseBindMatrices"};
    static const std::set<std::string> kArrays{"children", "joints", "nodes", "attributes", "targets"};
    if (!value.is_number_integer())
        return false;
    const Pointer parent = pointer.parent_pointer();
    return kNames.contains(pointer.back()) || (!parent.empty() && kArrays.contains(parent.back())) ||
           (parent.to_string().find("/targets/") != std::string::npos);
}

std::vector<std::string> requiredProperties() {
    std::vector<std::string> pointers{"/accessors/0/componentType",
                                      "/accessors/0/count",
                                      "/accessors/0/type",
                                      "/bufferViews/0/buffer",
                                      "/bufferViews/0/byteLength",
                                      "/buffers/0/byteLength",
                                      "/cameras/0/type",
                                      "/cameras/0/perspective",
                                      "/cameras/0/perspective/yfov",
                                      "/cameras/0/perspective/znear",
                                      "/cameras/1/orthographic",
                                      "/cameras/1/orthographic/xmag",
                                      "/cameras/1/orthographic/ymag",
                                      "/cameras/1/orthographic/zfar",
                                      "/cameras/1/orthographic/znear",
                                      "/extensions/KHR_lights_punctual/lights",
                                      "/extensions/KHR_lights_punctual/lights/0/type",
                                      "/extensions/KHR_lights_punctual/lights/0/spot",
                                      "/nodes/2/extensions/KHR_lights_punctual/light",
                                      "/images/0/uri",
                                      "/meshes/0/primitives",
                                      "/meshes/0/primitives/0/attributes",
                                      "/skins/0/joints",
                                      "/materials/0/normalTexture/index"};
    for (const char* name :
         {"count", "indices", "values", "indices/bufferView", "indices/componentType", "values/bufferView"})
        pointers.push_back(std::string("/accessors/8/sparse/") + name);
    return pointers;
}

/// What nothing that is drawn needs: a fault in it is a warning. (The first camera is missed, not needed.)
bool isUnneeded(const Pointer& pointer) {
    const std::string text = pointer.to_string();
    for (const char* end : {"/name", "/mimeType", "/target", "/skeleton", "/min", "/min/0", "/max", "/max/0"})
        if (text.ends_with(end))
            return true;
    return text.starts_with("/cameras/");
}

/// soundModel(), and each file is it with one value changed.
class Changes {
public:
    Changes() : m_sound(Json::parse(soundModel().bytes(false))) {}

    const Json& sound() const { return m_sound; }
    void set(const std::string& what, const Pointer& at, const Json& value, const char* code) {
        Json json = m_sound;
        json[at] = value;
        m_files.push_back({"schema/" + what + at.to_string(), "gltf", json.dump(), isUnneeded(at) ? "" : code,
                           isUnneeded(at) ? "" : at.to_string()});
    }
    void remove(const Pointer& at) {
        Json json = m_sound;
        json[at.parent_pointer()].erase(at.back());
        m_files.push_back({"schema/missing" + at.to_string(), "gltf", json.dump(),
                           isUnneeded(at) ? "" : "gltf.schema",
                           isUnneeded(at) ? "" : at.parent_pointer().to_string()});
    }
    std::vector<MalformedFile> files() && { return std::move(m_files); }

private:
    Json m_sound;
    std::vector<MalformedFile> m_files;
};

void addWrongTypes(Changes& changes) {
    walk(changes.sound(), Pointer(), [&](const Pointer& at, const Json& value) {
        if (at.to_string().starts_with("/asset") || at.to_string() == "/extensionsRequired/0")
            return; // malformedJson()
        const Json wrong = value.is_string() ? Json(7) : value.is_boolean() ? Json(1) : Json("wrong");
        changes.set("wrong-type", at, wrong, "gltf.schema");
    });
}

void addIndices(Changes& changes) {
    walk(changes.sound(), Pointer(), [&](const Pointer& at, const Json& value) {
        if (!isIndex(at, value))
            return;
        changes.set("index-negative", at, -1, "gltf.index-range");
        changes.set("index-0-in-32-bits", at, 4294967296, "gltf.index-range");
        changes.set("index-with-a-fraction", at, 0.5, "gltf.schema");
        if (at.back() != "skeleton") // which nothing reads
            changes.set("index-past-the-end", at, 1000, "gltf.index-range");
    });
}

} // namespace

std::vector<MalformedFile> malformedSchemas() {
    Changes changes;
    addWrongTypes(changes);
    addIndices(changes);
    for (const std::string& pointer : requiredProperties())
        changes.remove(Pointer(pointer));
    const std::string lengths[]{"/nodes/1/translation",
                                "/nodes/1/rotation",
                                "/nodes/1/scale",
                                "/nodes/2/matrix",
                                "/materials/0/emissiveFactor",
                                "/materials/0/pbrMetallicRoughness/baseColorFactor",
                                "/extensions/KHR_lights_punctual/lights/0/color",
                                "/materials/0/normalTexture/extensions/KHR_texture_transform/offset"};
    for (const std::string& pointer : lengths) {
        changes.set("array-empty", Pointer(pointer), Json::array(), "gltf.schema");
        changes.set("array-too-long", Pointer(pointer), Json(std::vector<int>(17, 1)), "gltf.schema");
    }
    for (const char* pointer :
         {"/accessors/0/count", "/accessors/0/byteOffset", "/bufferViews/0/byteOffset",
          "/bufferViews/0/byteLength", "/bufferViews/0/byteStride", "/buffers/0/byteLength",
          "/accessors/8/sparse/count", "/accessors/8/sparse/indices/byteOffset",
          "/accessors/8/sparse/values/byteOffset"})
        changes.set("size-negative", Pointer(pointer), -4, "gltf.value");
    return std::move(changes).files();
}
