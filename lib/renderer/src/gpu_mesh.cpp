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

namespace {

template<typename Index>
std::vector<std::uint8_t> bytesAs(const std::vector<std::uint32_t>& indices) {
    std::vector<std::uint8_t> bytes(indices.size() * sizeof(Index));
    std::uint8_t* out = bytes.data();
    for (const std::uint32_t each : indices) {
        const auto index = static_cast<Index>(each);
        std::memcpy(out, &index, sizeof(Index));
        out += sizeof(Index);
    }
    return bytes;
}

MeshPart partOf(MeshData data) {
    const std::size_t vertexCount = data.vertices.size() / static_cast<std::size_t>(data.format.stride);
    const bool wide = vertexCount > GpuMesh::kMaxShortVertices;
    return {.format = data.format,
            .vertices = std::move(data.vertices),
            .indices = wide ? bytesAs<std::uint32_t>(data.indices) : bytesAs<std::uint16_t>(data.indices),
            .count = static_cast<GLsizei>(data.indices.size()),
            .indexType = static_cast<GLenum>(wide ? GL_UNSIGNED_INT : GL_UNSIGNED_SHORT)};
}

} // namespace

std::vector<MeshPart> partsOf(const Primitive& primitive, const Capabilities& capabilities) {
    MeshData whole = interleave(primitive);
    std::vector<MeshPart> parts;
    if (primitive.positions.size() > GpuMesh::kMaxShortVertices && !capabilities.wideIndices)
        for (MeshData& part : split(whole, GpuMesh::kMaxShortVertices))
            parts.push_back(partOf(std::move(part)));
    else
        parts.push_back(partOf(std::move(whole)));
    return parts;
}

MeshUpload::MeshUpload(std::vector<MeshPart> parts) : m_parts(std::move(parts)) {
    if (!m_parts.empty())
        m_mesh.m_format = m_parts.front().format;
}

Result<void> MeshUpload::beginBuffer(Device& device) {
    MeshPart& part = m_parts[m_next];
    if (!m_ofIndices) {
        Result<MemoryLease> lease = device.memory.reserve(MemoryUse::Meshes, part.bytes());
        if (!lease)
            return lease.error();
        m_mesh.m_parts.push_back({.vertices = {},
                                  .indices = {},
                                  .memory = *std::move(lease),
                                  .count = part.count,
                                  .indexType = part.indexType});
    }
    Result<BufferUpload> begun =
        BufferUpload::begin(device.gl, m_ofIndices ? GL_ELEMENT_ARRAY_BUFFER : GL_ARRAY_BUFFER,
                            std::move(m_ofIndices ? part.indices : part.vertices));
    if (!begun)
        return begun.error();
    m_buffer = *std::move(begun);
    return {};
}

void MeshUpload::endBuffer() {
    GpuMesh::Part& part = m_mesh.m_parts.back();
    (m_ofIndices ? part.indices : part.vertices) = m_buffer->take();
    m_buffer.reset();
    m_next += m_ofIndices ? 1 : 0;
    m_ofIndices = !m_ofIndices;
}

Result<std::size_t> MeshUpload::step(Device& device, std::size_t maxBytes) {
    if (!m_buffer)
        if (Result<void> begun = beginBuffer(device); !begun)
            return begun.error();
    const std::size_t bytes = m_buffer->step(device.gl, maxBytes);
    if (m_buffer->isDone())
        endBuffer();
    return bytes;
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
