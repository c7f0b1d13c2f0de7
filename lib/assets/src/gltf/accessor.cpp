// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "gltf/accessor.h"

namespace franken::gltf {
namespace {

template<typename T>
T load(const std::uint8_t* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value); // a file may align as it likes
    return value;
}

// glTF 2.0, 3.11 (animations) and 3.6.2.2: signed numbers are clamped, so that -128 is -1 as well.
template<typename T>
float toFloat(const std::uint8_t* bytes, bool normalized) {
    const float value = static_cast<float>(load<T>(bytes));
    if (!normalized)
        return value;
    return std::fmax(value / static_cast<float>(std::numeric_limits<T>::max()), -1.0f);
}

float component(const std::uint8_t* bytes, int type, bool normalized) {
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return toFloat<std::int8_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return toFloat<std::uint8_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return toFloat<std::int16_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return toFloat<std::uint16_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return toFloat<std::uint32_t>(bytes, normalized);
    default:
        return load<float>(bytes);
    }
}

std::uint32_t integer(const std::uint8_t* bytes, int type) {
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return *bytes;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return load<std::uint16_t>(bytes);
    default:
        return load<std::uint32_t>(bytes);
    }
}

// Exporters are known that write joints as floats.
std::uint32_t joint(const std::uint8_t* bytes, int type) {
    if (type != TINYGLTF_COMPONENT_TYPE_FLOAT)
        return integer(bytes, type);
    const float number = load<float>(bytes);
    constexpr float kLimit = 65536.0f;
    return number >= 0.0f && number < kLimit ? static_cast<std::uint32_t>(number + 0.5f) : UINT32_MAX;
}

const std::uint8_t* viewData(Document& source, int view, std::size_t offset) {
    const std::span<const std::uint8_t> bytes = viewBytes(source, view);
    return bytes.empty() ? nullptr : bytes.data() + offset;
}

// Calls store(element, bytes) for all elements of the base view, then for the sparse ones over them.
template<typename Store>
bool forEachElement(Document& source, int index, Store store) {
    if (!source.need(pathOf("accessors", index)))
        return false;
    const tinygltf::Model& model = source.model;
    const tinygltf::Accessor& accessor = model.accessors[at(index)];
    const auto componentSize =
        at(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType)));
    const std::size_t packed = componentSize * at(width(accessor));
    if (accessor.bufferView >= 0) {
        const std::size_t stride = source.accessorStrides[at(index)];
        const std::uint8_t* bytes = viewData(source, accessor.bufferView, accessor.byteOffset);
        if (!bytes)
            return false;
        for (std::size_t i = 0; i < accessor.count; ++i)
            store(i, bytes + i * stride);
    }
    if (!accessor.sparse.isSparse)
        return true;
    const auto& indices = accessor.sparse.indices;
    const auto indexSize =
        at(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(indices.componentType)));
    const std::uint8_t* indexBytes =
        viewData(source, indices.bufferView, static_cast<std::size_t>(indices.byteOffset));
    const std::uint8_t* values = viewData(source, accessor.sparse.values.bufferView,
                                          static_cast<std::size_t>(accessor.sparse.values.byteOffset));
    if (!indexBytes || !values)
        return false;
    for (std::size_t i = 0; i < at(accessor.sparse.count); ++i) {
        const std::uint32_t element = integer(indexBytes + i * indexSize, indices.componentType);
        if (element >= accessor.count)
            return source.fail("gltf.index-range", pathOf("accessors", index, "sparse/indices"),
                               "sparse index " + std::to_string(element) +
                                   " is not below the accessor's count of " + std::to_string(accessor.count));
        store(element, values + i * packed);
    }
    return true;
}

} // namespace

std::span<const std::uint8_t> viewBytes(Document& source, int view) {
    const tinygltf::BufferView& from = source.model.bufferViews[at(view)];
    const Buffer& buffer = source.buffers[at(from.buffer)];
    if (buffer.bytes.empty()) {
        source.fail("gltf.buffer", pathOf("buffers", from.buffer),
                    "the buffer is needed, but " + buffer.problem,
                    "put the file where the URI says, next to the model");
        return {};
    }
    return buffer.bytes.subspan(from.byteOffset, from.byteLength);
}

int width(const tinygltf::Accessor& accessor) {
    return tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
}

bool readFloats(Document& source, int index, std::span<float> out) {
    const tinygltf::Accessor& accessor = source.model.accessors[at(index)];
    const std::size_t n = at(width(accessor));
    const int type = accessor.componentType;
    const bool isFloat = type == TINYGLTF_COMPONENT_TYPE_FLOAT;
    const auto size = at(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(type)));
    const auto store = [&](std::size_t element, const std::uint8_t* bytes) {
        float* to = out.data() + element * n;
        if (isFloat)
            std::memcpy(to, bytes, n * sizeof(float));
        else
            for (std::size_t c = 0; c < n; ++c)
                to[c] = component(bytes + c * size, type, accessor.normalized);
    };
    std::fill(out.begin(), out.end(), 0.0f);
    if (!forEachElement(source, index, store))
        return false;
    for (std::size_t i = 0; i < out.size(); ++i)
        if (!std::isfinite(out[i]))
            return source.fail("gltf.value", pathOf("accessors", index),
                               "element " + std::to_string(i / n) + " is not finite");
    return true;
}

bool readIndices(Document& source, int index, std::vector<std::uint32_t>& out) {
    const int type = source.model.accessors[at(index)].componentType;
    out.assign(source.model.accessors[at(index)].count, 0);
    return forEachElement(source, index,
                          [&](std::size_t i, const std::uint8_t* bytes) { out[i] = integer(bytes, type); });
}

bool readJoints(Document& source, int index, std::vector<glm::uvec4>& out) {
    const int type = source.model.accessors[at(index)].componentType;
    const auto size = at(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(type)));
    out.assign(source.model.accessors[at(index)].count, glm::uvec4(0));
    return forEachElement(source, index, [&](std::size_t i, const std::uint8_t* bytes) {
        for (int c = 0; c < 4; ++c)
            out[i][c] = joint(bytes + at(c) * size, type);
    });
}

} // namespace franken::gltf
