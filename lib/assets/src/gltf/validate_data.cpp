// SPDX-License-Identifier: MIT
#include <algorithm>
#include <initializer_list>

#include "gltf/internal.h"

namespace franken::gltf {
namespace {

constexpr int kByte = TINYGLTF_COMPONENT_TYPE_BYTE, kUByte = TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE,
              kShort = TINYGLTF_COMPONENT_TYPE_SHORT, kUShort = TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
              kUInt = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, kFloat = TINYGLTF_COMPONENT_TYPE_FLOAT;

constexpr std::size_t kMaxElements = 0x7FFFFFFF;

std::size_t componentSize(int type) {
    return at(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(type)));
}

bool isOneOf(int value, std::initializer_list<int> values) {
    return std::find(values.begin(), values.end(), value) != values.end();
}

bool typeError(Source& source, const std::string& where, const std::string& what) {
    return source.fail("gltf.type", where, what);
}

bool checkViews(Source& source) {
    for (std::size_t i = 0; i < source.model.bufferViews.size(); ++i) {
        const tinygltf::BufferView& view = source.model.bufferViews[i];
        const std::string where = pathOf("bufferViews", i);
        if (!checkPresent(source, view.buffer, source.buffers.size(), where + "/buffer"))
            return false;
        const std::size_t size = source.buffers[at(view.buffer)].length;
        if (view.byteOffset > size || view.byteLength > size - view.byteOffset)
            return source.fail("gltf.bounds", where,
                               "the view reaches outside its buffer of " + std::to_string(size) + " bytes");
    }
    return true;
}

// `count` elements of `size` bytes, `stride` apart, inside a view; written so that nothing overflows.
bool checkRange(Source& source, int view, std::size_t offset, std::size_t count, std::size_t size,
                bool strided, const std::string& where) {
    if (!checkPresent(source, view, source.model.bufferViews.size(), where + "/bufferView"))
        return false;
    const tinygltf::BufferView& from = source.model.bufferViews[at(view)];
    const std::size_t stride = strided && from.byteStride ? from.byteStride : size;
    if (stride < size)
        return typeError(source, where,
                         "the stride of " + std::to_string(stride) + " bytes is less than an element");
    const std::size_t length = from.byteLength;
    if (offset > length || size > length - offset || count - 1 > (length - offset - size) / stride)
        return source.fail("gltf.bounds", where,
                           std::to_string(count) + " elements reach outside their view of " +
                               std::to_string(length) + " bytes");
    return true;
}

bool checkSparse(Source& source, const tinygltf::Accessor& accessor, std::size_t elementSize,
                 const std::string& where) {
    const auto& sparse = accessor.sparse;
    if (sparse.count < 1 || at(sparse.count) > accessor.count)
        return typeError(source, where + "/count", "a sparse count is 1 to the accessor's own count");
    if (!isOneOf(sparse.indices.componentType, {kUByte, kUShort, kUInt}))
        return typeError(source, where + "/indices/componentType", "sparse indices are unsigned integers");
    // Signed in tinygltf 2.7, unsigned later; what is negative is out of range as well.
    const auto indexOffset = static_cast<std::size_t>(sparse.indices.byteOffset);
    const auto valueOffset = static_cast<std::size_t>(sparse.values.byteOffset);
    return checkRange(source, sparse.indices.bufferView, indexOffset, at(sparse.count),
                      componentSize(sparse.indices.componentType), false, where + "/indices") &&
           checkRange(source, sparse.values.bufferView, valueOffset, at(sparse.count), elementSize, false,
                      where + "/values");
}

// What `min` and `max` say is not believed, but has to make sense.
bool checkExtent(Source& source, const tinygltf::Accessor& accessor, const std::string& where) {
    const std::vector<double>&least = accessor.minValues, &most = accessor.maxValues;
    for (const std::vector<double>* values : {&least, &most})
        if (!values->empty() && values->size() != at(width(accessor)))
            return typeError(source, where + (values == &least ? "/min" : "/max"),
                             "there is a number for each component, or none");
    if (!checkFinite(source, least, where + "/min") || !checkFinite(source, most, where + "/max"))
        return false;
    for (std::size_t i = 0; i < std::min(least.size(), most.size()); ++i)
        if (least[i] > most[i])
            return source.fail("gltf.value", where + "/min" + pathOf(i), "the minimum is above the maximum");
    return true;
}

bool checkAccessor(Source& source, std::size_t index) {
    const tinygltf::Accessor& accessor = source.model.accessors[index];
    const std::string where = pathOf("accessors", index);
    if (accessor.count < 1)
        return typeError(source, where + "/count", "an accessor has at least one element");
    if (accessor.count > kMaxElements)
        return source.fail("gltf.limit", where + "/count",
                           std::to_string(accessor.count) + " elements are more than 32-bit indices reach",
                           "split the mesh");
    if (!checkExtent(source, accessor, where))
        return false;
    const std::size_t size = componentSize(accessor.componentType) * at(width(accessor));
    if (accessor.bufferView != kNone &&
        !checkRange(source, accessor.bufferView, accessor.byteOffset, accessor.count, size, true, where))
        return false;
    return !accessor.sparse.isSparse || checkSparse(source, accessor, size, where + "/sparse");
}

// What a semantic may be stored as: glTF 2.0, 3.7.2.1, and the tables of KHR_mesh_quantization.
bool isAllowed(const tinygltf::Accessor& accessor, const std::string& name, bool isTarget, bool quantized) {
    const int type = accessor.type, component = accessor.componentType;
    const bool normalized = accessor.normalized;
    const bool isSigned = isOneOf(component, {kByte, kShort}),
               isUnsigned = isOneOf(component, {kUByte, kUShort});
    const bool plainFloat = component == kFloat;
    if (name == "POSITION")
        return type == TINYGLTF_TYPE_VEC3 &&
               (plainFloat || (quantized && (isSigned || (isUnsigned && !isTarget))));
    if (name == "NORMAL")
        return type == TINYGLTF_TYPE_VEC3 && (plainFloat || (quantized && isSigned && normalized));
    if (name == "TANGENT")
        return type == (isTarget ? TINYGLTF_TYPE_VEC3 : TINYGLTF_TYPE_VEC4) &&
               (plainFloat || (quantized && isSigned && normalized));
    if (name.starts_with("TEXCOORD_"))
        return type == TINYGLTF_TYPE_VEC2 &&
               (plainFloat || (isUnsigned && normalized) || (quantized && (isSigned || isUnsigned)));
    if (name.starts_with("COLOR_"))
        return isOneOf(type, {TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC4}) &&
               (plainFloat || (isUnsigned && normalized));
    if (name.starts_with("JOINTS_"))
        return type == TINYGLTF_TYPE_VEC4 && isUnsigned && !normalized;
    if (name.starts_with("WEIGHTS_"))
        return type == TINYGLTF_TYPE_VEC4 && (plainFloat || (isUnsigned && normalized));
    return true; // an application's own
}

bool checkAttributes(Source& source, const std::map<std::string, int>& attributes, std::size_t& count,
                     bool isTarget, const std::string& where) {
    for (const auto& [name, index] : attributes) {
        const std::string path = where + pathOf(name);
        if (!checkPresent(source, index, source.model.accessors.size(), path))
            return false;
        const tinygltf::Accessor& accessor = source.model.accessors[at(index)];
        if (!isAllowed(accessor, name, isTarget, source.uses("KHR_mesh_quantization")))
            return typeError(source, path, "glTF does not allow " + name + " in the accessor's type");
        if (count == 0)
            count = accessor.count;
        if (accessor.count != count)
            return typeError(source, path,
                             "the attribute has " + std::to_string(accessor.count) +
                                 " elements, another one of the primitive " + std::to_string(count));
    }
    return true;
}

bool checkPrimitive(Source& source, const tinygltf::Primitive& primitive, const std::string& where) {
    if (primitive.mode < TINYGLTF_MODE_POINTS || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN)
        return source.fail("gltf.value", where + "/mode",
                           "there is no mode " + std::to_string(primitive.mode));
    if (!checkIndex(source, primitive.material, source.model.materials.size(), where + "/material") ||
        !checkIndex(source, primitive.indices, source.model.accessors.size(), where + "/indices"))
        return false;
    if (primitive.indices >= 0) {
        const tinygltf::Accessor& accessor = source.model.accessors[at(primitive.indices)];
        if (accessor.type != TINYGLTF_TYPE_SCALAR || accessor.normalized ||
            !isOneOf(accessor.componentType, {kUByte, kUShort, kUInt}))
            return typeError(source, where + "/indices", "indices are unsigned integers");
    }
    std::size_t count = 0;
    if (!checkAttributes(source, primitive.attributes, count, false, where + "/attributes"))
        return false;
    for (std::size_t t = 0; t < primitive.targets.size(); ++t)
        if (!checkAttributes(source, primitive.targets[t], count, true, where + pathOf("targets", t)))
            return false;
    return true;
}

} // namespace

bool validateData(Source& source) {
    if (!checkViews(source))
        return false;
    for (std::size_t i = 0; i < source.model.accessors.size(); ++i)
        if (!checkAccessor(source, i))
            return false;
    for (std::size_t m = 0; m < source.model.meshes.size(); ++m) {
        const tinygltf::Mesh& mesh = source.model.meshes[m];
        if (!checkFinite(source, mesh.weights, pathOf("meshes", m, "weights")))
            return false;
        for (std::size_t p = 0; p < mesh.primitives.size(); ++p)
            if (!checkPrimitive(source, mesh.primitives[p], pathOf("meshes", m, "primitives", p)))
                return false;
    }
    return true;
}

} // namespace franken::gltf
