// SPDX-License-Identifier: MIT
#include "gpu_mesh.h"

#include "franken/attribute_format.h"
#include "gpu_buffer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

namespace franken {
namespace {

int reserve(VertexFormat& format, bool present, std::size_t bytes) {
    if (!present)
        return -1;
    const int offset = format.stride;
    format.stride += static_cast<int>(bytes);
    return offset;
}

using Color = std::array<std::uint16_t, 4>;

Color toColor(const glm::vec4& color) {
    Color result;
    for (int i = 0; i < 4; ++i)
        result[static_cast<std::size_t>(i)] =
            static_cast<std::uint16_t>(std::lround(std::clamp(color[i], 0.0f, 1.0f) * 65'535.0f));
    return result;
}

template<typename Value, typename Convert>
void place(MeshData& data, int offset, const std::vector<Value>& values, Convert convert) {
    if (offset < 0)
        return;
    std::uint8_t* out = data.vertices.data() + offset;
    for (const Value& value : values) {
        const auto converted = convert(value);
        std::memcpy(out, &converted, sizeof(converted));
        out += data.format.stride;
    }
}

template<typename Value>
void place(MeshData& data, int offset, const std::vector<Value>& values) {
    place(data, offset, values, [](const Value& value) { return value; });
}

} // namespace

MeshData interleave(const Primitive& primitive) {
    MeshData data;
    VertexFormat& format = data.format;
    format.position = reserve(format, true, sizeof(glm::vec3));
    format.normal = reserve(format, !primitive.normals.empty(), sizeof(glm::vec3));
    format.tangent = reserve(format, !primitive.tangents.empty(), sizeof(glm::vec4));
    for (std::size_t set = 0; set < format.uv.size(); ++set)
        format.uv[set] = reserve(format, !primitive.uv[set].empty(), sizeof(glm::vec2));
    format.color = reserve(format, !primitive.colors.empty(), sizeof(Color));

    data.vertices.resize(primitive.positions.size() * static_cast<std::size_t>(format.stride));
    place(data, format.position, primitive.positions);
    place(data, format.normal, primitive.normals);
    place(data, format.tangent, primitive.tangents);
    for (std::size_t set = 0; set < format.uv.size(); ++set)
        place(data, format.uv[set], primitive.uv[set]);
    place(data, format.color, primitive.colors, toColor);
    data.indices = primitive.indices;
    return data;
}

std::vector<MeshData> split(const MeshData& whole, std::size_t maxVertices) {
    assert(maxVertices >= 3);
    const auto stride = static_cast<std::size_t>(whole.format.stride);
    constexpr std::uint32_t kUnseen = ~std::uint32_t{0};
    std::vector<std::uint32_t> place(whole.vertices.size() / stride, kUnseen);
    std::vector<MeshData> parts;
    std::vector<std::uint32_t> taken; // The vertices of the last part, by their index in the whole.
    for (std::size_t triangle = 0; triangle + 2 < whole.indices.size(); triangle += 3) {
        if (parts.empty() || taken.size() + 3 > maxVertices) {
            for (const std::uint32_t vertex : taken)
                place[vertex] = kUnseen;
            taken.clear();
            parts.push_back({whole.format, {}, {}});
        }
        MeshData& part = parts.back();
        for (std::size_t corner = triangle; corner < triangle + 3; ++corner) {
            const std::uint32_t vertex = whole.indices[corner];
            if (place[vertex] == kUnseen) {
                place[vertex] = static_cast<std::uint32_t>(taken.size());
                taken.push_back(vertex);
                const auto from = whole.vertices.begin() + static_cast<std::ptrdiff_t>(vertex * stride);
                part.vertices.insert(part.vertices.end(), from, from + static_cast<std::ptrdiff_t>(stride));
            }
            part.indices.push_back(place[vertex]);
        }
    }
    return parts;
}

Result<GpuMesh> GpuMesh::make(Device& device, const Primitive& primitive) {
    GpuMesh mesh;
    std::vector<MeshData> parts;
    parts.push_back(interleave(primitive));
    mesh.m_format = parts.front().format;
    if (primitive.positions.size() > kMaxShortVertices && !device.capabilities.wideIndices)
        parts = split(parts.front(), kMaxShortVertices);
    for (const MeshData& part : parts)
        if (Result<void> added = mesh.addPart(device, part); !added)
            return added.error();
    return mesh;
}

Result<void> GpuMesh::addPart(Device& device, const MeshData& data) {
    const std::size_t vertexCount = data.vertices.size() / static_cast<std::size_t>(data.format.stride);
    const bool wide = vertexCount > kMaxShortVertices;
    const std::size_t indexBytes =
        data.indices.size() * (wide ? sizeof(std::uint32_t) : sizeof(std::uint16_t));
    Result<MemoryLease> lease = device.memory.reserve(MemoryUse::Meshes, data.vertices.size() + indexBytes);
    if (!lease)
        return lease.error();
    Result<GlBuffer> vertices =
        uploadBuffer(device.gl, GL_ARRAY_BUFFER, std::as_bytes(std::span(data.vertices)));
    if (!vertices)
        return vertices.error();
    const std::vector<std::uint16_t> narrow(data.indices.begin(),
                                            wide ? data.indices.begin() : data.indices.end());
    Result<GlBuffer> indices =
        uploadBuffer(device.gl, GL_ELEMENT_ARRAY_BUFFER,
                     wide ? std::as_bytes(std::span(data.indices)) : std::as_bytes(std::span(narrow)));
    if (!indices)
        return indices.error();
    m_parts.push_back({.vertices = *std::move(vertices),
                       .indices = *std::move(indices),
                       .memory = *std::move(lease),
                       .count = static_cast<GLsizei>(data.indices.size()),
                       .indexType = static_cast<GLenum>(wide ? GL_UNSIGNED_INT : GL_UNSIGNED_SHORT)});
    return {};
}

void GpuMesh::setPointers(GlState& state, unsigned attributes, const std::array<int, 2>& uvSets) const {
    const std::array<int, kAttributeFormats.size()> offsets = {
        m_format.position,
        m_format.normal,
        m_format.tangent,
        m_format.uv[static_cast<std::size_t>(uvSets[0])],
        m_format.uv[static_cast<std::size_t>(uvSets[1])],
        m_format.color,
    };
    for (std::size_t location = 0; location < offsets.size(); ++location) {
        if ((attributes >> location & 1u) == 0)
            continue;
        assert(offsets[location] >= 0 && "the plan of the material asks for no more than the mesh has");
        state.setPointer(static_cast<GLuint>(location),
                         {kAttributeFormats[location].size, kAttributeFormats[location].type, m_format.stride,
                          offsets[location]});
    }
}

void GpuMesh::draw(const Gl& gl, GlState& state, unsigned attributes,
                   const std::array<int, 2>& uvSets) const {
    const unsigned layout =
        attributes | static_cast<unsigned>(uvSets[0]) << 8 | static_cast<unsigned>(uvSets[1]) << 9;
    for (const Part& part : m_parts) {
        state.bindIndices(part.indices.name());
        if (state.changesPointers(part.vertices.name(), layout)) {
            state.bindVertices(part.vertices.name());
            setPointers(state, attributes, uvSets);
        }
        gl.DrawElements(GL_TRIANGLES, part.count, part.indexType, nullptr);
    }
}

} // namespace franken
