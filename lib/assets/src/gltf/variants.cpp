// SPDX-License-Identifier: MIT
#include "gltf/variants.h"

#include <set>

namespace franken::gltf {
namespace {

constexpr const char* kExtension = "KHR_materials_variants";

const tinygltf::Value& extensionOf(const tinygltf::ExtensionMap& extensions) {
    static const tinygltf::Value kNothing;
    const auto found = extensions.find(kExtension);
    return found == extensions.end() ? kNothing : found->second;
}

/// The elements of an array that may be absent.
const tinygltf::Value::Array& elementsOf(const tinygltf::Value& object, const char* array) {
    static const tinygltf::Value::Array kEmpty;
    if (!object.IsObject() || !object.Get(array).IsArray())
        return kEmpty;
    return object.Get(array).Get<tinygltf::Value::Array>();
}

int materialOf(const tinygltf::Value& mapping) {
    return mapping.Has("material") ? mapping.Get("material").GetNumberAsInt() : kNone;
}

} // namespace

void readVariants(Document& source, Scene& scene) {
    std::set<std::string> taken{""};
    for (const tinygltf::Value& variant : elementsOf(extensionOf(source.model.extensions), "variants")) {
        const std::size_t index = scene.variants.size();
        std::string name = variant.Has("name") ? variant.Get("name").Get<std::string>() : std::string();
        if (taken.contains(name)) {
            while (taken.contains(name))
                name += "#" + std::to_string(index);
            source.warn(kMended, pathOf("extensions", kExtension, "variants", index),
                        "a variant has the name of another, or none; it is called \"" + name + "\"");
        }
        taken.insert(name);
        scene.variants.push_back(std::move(name));
    }
}

bool readVariantMaterials(Document& source, const tinygltf::Primitive& from, const std::string& where,
                          std::size_t variants, std::vector<int>& materials) {
    const tinygltf::Value::Array& mappings = elementsOf(extensionOf(from.extensions), "mappings");
    if (mappings.empty())
        return true;
    if (!source.charge(variants, sizeof(int) + sizeof(Material*), where))
        return false;
    materials.assign(variants, kNone);
    for (std::size_t m = 0; m < mappings.size(); ++m) {
        const int material = materialOf(mappings[m]);
        bool faulty = !isIndex(material, source.model.materials.size());
        for (const tinygltf::Value& variant : elementsOf(mappings[m], "variants"))
            if (!isIndex(variant.GetNumberAsInt(), variants))
                faulty = true;
            else if (isIndex(material, source.model.materials.size()))
                materials[at(variant.GetNumberAsInt())] = material;
        if (faulty)
            source.warn(kLeftOut, where + pathOf("extensions", kExtension, "mappings", m),
                        "the mapping names a material or a variant that is not there");
    }
    return true;
}

std::vector<int> possibleMaterials(const tinygltf::Primitive& from, std::size_t materials) {
    std::vector<int> possible;
    if (from.material != kNone)
        possible.push_back(from.material);
    for (const tinygltf::Value& mapping : elementsOf(extensionOf(from.extensions), "mappings"))
        if (isIndex(materialOf(mapping), materials))
            possible.push_back(materialOf(mapping));
    return possible;
}

} // namespace franken::gltf
