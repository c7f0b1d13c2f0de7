// SPDX-License-Identifier: MIT
#include <algorithm>
#include <initializer_list>

#include "gltf/accessor.h"

namespace franken::gltf {
namespace {

constexpr int kUByte = TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE,
              kUShort = TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, kUInt = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;

constexpr std::size_t kMaxElements = 0x7FFFFFFF;

std::size_t componentSize(int type) {
    return at(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(type)));
}

bool isOneOf(int value, std::initializer_list<int> values) {
    return std::find(values.begin(), values.end(), value) != values.end();
}

bool typeError(Document& source, const std::string& where, const std::string& what) {
    return source.fail("gltf.type", where, what);
}

bool checkViews(Document& source) {
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
bool fits(std::size_t length, std::size_t offset, std::size_t count, std::size_t size, std::size_t stride) {
    return offset <= length && size <= length - offset && count - 1 <= (length - offset - size) / stride;
}

bool checkRange(Document& source, int view, std::size_t offset, std::size_t count, std::size_t size,
                std::size_t stride, const std::string& where) {
    if (!checkPresent(source, view, source.model.bufferViews.size(), where + "/bufferView"))
        return false;
    const std::size_t length = source.model.bufferViews[at(view)].byteLength;
    if (!fits(length, offset, count, size, stride))
        return source.fail("gltf.bounds", where,
                           std::to_string(count) + " elements reach outside their view of " +
                               std::to_string(length) + " bytes");
    return true;
}

bool checkSparse(Document& source, const tinygltf::Accessor& accessor, std::size_t size,
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
                      componentSize(sparse.indices.componentType),
                      componentSize(sparse.indices.componentType), where + "/indices") &&
           checkRange(source, sparse.values.bufferView, valueOffset, at(sparse.count), size, size,
                      where + "/values");
}

std::size_t elementSize(const tinygltf::Accessor& accessor) {
    return componentSize(accessor.componentType) * at(width(accessor));
}

// The stride of the view, which is for vertices: indices that do not fit it, and fit without it, have none.
bool findStride(Document& source, std::size_t index, bool isIndices, const std::string& where) {
    const tinygltf::Accessor& accessor = source.model.accessors[index];
    const std::size_t size = elementSize(accessor);
    std::size_t& stride = source.accessorStrides[index];
    stride = size;
    if (accessor.bufferView == kNone ||
        !checkPresent(source, accessor.bufferView, source.model.bufferViews.size(), where + "/bufferView"))
        return !source.error;
    const std::size_t declared = source.strides[at(accessor.bufferView)];
    if (declared == 0)
        return true;
    if (isIndices)
        source.warn(kMended, pathOf("bufferViews", accessor.bufferView), "a view of indices has no stride");
    const std::size_t length = source.model.bufferViews[at(accessor.bufferView)].byteLength;
    if (isIndices && (declared < size || !fits(length, accessor.byteOffset, accessor.count, size, declared)))
        return true;
    if (declared < size)
        return typeError(source, where,
                         "the stride of " + std::to_string(declared) + " bytes is less than an element");
    stride = declared;
    return true;
}

bool checkAccessor(Document& source, std::size_t index, bool isIndices) {
    const tinygltf::Accessor& accessor = source.model.accessors[index];
    const std::string where = pathOf("accessors", index);
    if (accessor.count < 1)
        return typeError(source, where + "/count", "an accessor has at least one element");
    if (accessor.count > kMaxElements)
        return source.fail("gltf.limit", where + "/count",
                           std::to_string(accessor.count) + " elements are more than 32-bit indices reach",
                           "split the mesh");
    const std::size_t size = elementSize(accessor);
    if (!findStride(source, index, isIndices, where))
        return false;
    if (accessor.bufferView != kNone &&
        !checkRange(source, accessor.bufferView, accessor.byteOffset, accessor.count, size,
                    source.accessorStrides[index], where))
        return false;
    return !accessor.sparse.isSparse || checkSparse(source, accessor, size, where + "/sparse");
}

bool checkPresent(Document& source, const std::map<std::string, int>& attributes, const std::string& where) {
    for (const auto& [name, index] : attributes)
        if (!checkPresent(source, index, source.model.accessors.size(), where + pathOf(name)))
            return false;
    return true;
}

bool checkPrimitive(Document& source, const tinygltf::Primitive& primitive, const std::string& where) {
    if (!checkIndex(source, primitive.material, source.model.materials.size(), where + "/material") ||
        !checkIndex(source, primitive.indices, source.model.accessors.size(), where + "/indices") ||
        !checkPresent(source, primitive.attributes, where + "/attributes"))
        return false;
    for (std::size_t t = 0; t < primitive.targets.size(); ++t)
        if (!checkPresent(source, primitive.targets[t], where + pathOf("targets", t)))
            return false;
    return true;
}

bool checkMesh(Document& source, std::size_t index) {
    const tinygltf::Mesh& mesh = source.model.meshes[index];
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p)
        if (!checkPrimitive(source, mesh.primitives[p], pathOf("meshes", index, "primitives", p)))
            return false;
    const std::string where = pathOf("meshes", index);
    return checkFinite(source, mesh.weights, where + "/weights") || source.defer(where);
}

std::vector<bool> indicesOf(const tinygltf::Model& model) {
    std::vector<bool> isIndices(model.accessors.size(), false);
    for (const tinygltf::Mesh& mesh : model.meshes)
        for (const tinygltf::Primitive& primitive : mesh.primitives)
            if (primitive.indices >= 0 && at(primitive.indices) < isIndices.size())
                isIndices[at(primitive.indices)] = true;
    return isIndices;
}

} // namespace

bool validateData(Document& source) {
    if (!checkViews(source))
        return false;
    const std::vector<bool> isIndices = indicesOf(source.model);
    source.accessorStrides.assign(source.model.accessors.size(), 0);
    for (std::size_t i = 0; i < source.model.accessors.size(); ++i)
        if (!checkAccessor(source, i, isIndices[i]) && !source.defer(pathOf("accessors", i)))
            return false;
    for (std::size_t m = 0; m < source.model.meshes.size(); ++m)
        if (!checkMesh(source, m))
            return false;
    return true;
}

} // namespace franken::gltf
