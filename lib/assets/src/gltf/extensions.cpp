// SPDX-License-Identifier: MIT
#include <algorithm>

#include "gltf/gate.h"
#include "gltf/schema.h"

namespace franken::gltf {
namespace {

bool extensionError(Source& source, const std::string& where, const std::string& name) {
    return source.fail("gltf.extension", where,
                       "the file requires the extension " + name + ", which is not built in",
                       "export the file without " + name);
}

bool checkRequired(Source& source, const Json& root) {
    const Json& required = member(root, "extensionsRequired");
    for (std::size_t i = 0; required.is_array() && i < required.size(); ++i) {
        const std::string name =
            required[i].is_string() ? required[i].get<std::string>() : required[i].dump();
        if (isHarmless(name))
            source.warn(kLeftOut, pathOf("extensionsRequired", i),
                        "the file requires the extension " + name + "; it is drawn without");
        else if (!isKnown(name))
            return extensionError(source, pathOf("extensionsRequired", i), name);
    }
    return true;
}

void warnOfUsed(const Source& source, const Json& root) {
    const Json &used = member(root, "extensionsUsed"), &required = member(root, "extensionsRequired");
    for (std::size_t i = 0; used.is_array() && i < used.size(); ++i)
        if (used[i].is_string() && !isKnown(used[i].get<std::string>()) &&
            !(required.is_array() && std::find(required.begin(), required.end(), used[i]) != required.end()))
            source.warn(kLeftOut, pathOf("extensionsUsed", i),
                        "the extension " + used[i].get<std::string>() + " is not known and left out");
}

/// The element of a root array that `index` names, or null.
const Json& element(const Json& root, const char* array, const Json& index) {
    static const Json kNull;
    const Json& elements = member(root, array);
    return elements.is_array() && index.is_number_unsigned() && index.get<std::size_t>() < elements.size()
               ? elements[index.get<std::size_t>()]
               : kNull;
}

/// The extension without which the accessor has no bytes: its view is compressed, and the buffer that holds
/// it unpacked is only a promise. Empty for none.
std::string compression(const Json& root, const Json& accessor) {
    const Json& view = element(root, "bufferViews", member(accessor, "bufferView"));
    const Json& buffer = element(root, "buffers", member(view, "buffer"));
    for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
        if (!member(member(view, "extensions"), name).is_null() && member(buffer, "uri").is_null())
            return name;
    return {};
}

/// Likewise for a primitive. Some exporters declare an extension as optional and leave out what it would be
/// optional to.
std::string compressionOf(const Json& root, const Json& primitive) {
    const char* const kDraco = "KHR_draco_mesh_compression";
    const Json& attributes = member(primitive, "attributes");
    const Json& position = element(root, "accessors", member(attributes, "POSITION"));
    if (!member(member(primitive, "extensions"), kDraco).is_null() && position.is_object() &&
        member(position, "bufferView").is_null())
        return kDraco;
    std::string name = compression(root, element(root, "accessors", member(primitive, "indices")));
    if (attributes.is_object())
        for (const Json& accessor : attributes)
            if (name.empty())
                name = compression(root, element(root, "accessors", accessor));
    return name;
}

} // namespace

bool checkExtensions(Source& source, const Json& root) {
    if (!checkRequired(source, root))
        return false;
    warnOfUsed(source, root);
    const Json& meshes = member(root, "meshes");
    for (std::size_t m = 0; meshes.is_array() && m < meshes.size(); ++m)
        for (const Json& primitive : member(meshes[m], "primitives"))
            if (const std::string name = compressionOf(root, primitive); !name.empty())
                return extensionError(source, pathOf("meshes", m), name);
    return true;
}

} // namespace franken::gltf
