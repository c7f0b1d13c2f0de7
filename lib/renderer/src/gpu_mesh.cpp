// SPDX-License-Identifier: MIT
#include "gpu_mesh.h"

#include "franken/attribute_format.h"
#include "franken/deform.h"
#include "franken/generator/pack.h"
#include "franken/material.h"
#include "gpu_buffer.h"
#include "joint_influences.h"

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

/// An interleaved array that is written attribute by attribute.
struct Interleaving {
    const VertexFormat& format;
    std::vector<std::uint8_t>& vertices;
    const std::vector<std::uint32_t>& sources; ///< As those of MeshData.

    template<typename Value, typename Convert>
    void write(int offset, const std::vector<Value>& values, Convert convert) {
        if (offset < 0 || values.empty())
            return;
        std::uint8_t* out = vertices.data() + offset;
        const std::size_t count = sources.empty() ? values.size() : sources.size();
        for (std::size_t i = 0; i < count; ++i) {
            const auto converted = convert(values[sources.empty() ? i : sources[i]]);
            std::memcpy(out, &converted, sizeof(converted));
            out += format.stride;
        }
    }

    /// Of a Primitive or of Vertices, those arrays that it has.
    template<typename Arrays>
    void write(const Arrays& arrays) {
        const auto asItIs = [](const auto& value) { return value; };
        write(format.position, arrays.positions, asItIs);
        write(format.normal, arrays.normals, asItIs);
        write(format.tangent, arrays.tangents, asItIs);
        for (std::size_t set = 0; set < format.uv.size(); ++set)
            write(format.uv[set], arrays.uv[set], asItIs);
        write(format.color, arrays.colors, toColor);
    }
};

/// By their index in the skin.
void writeJoints(const Deformation& deformation, MeshData& data) {
    const std::size_t each = deformation.influencesPerVertex;
    std::uint8_t* to = data.vertices.data();
    for (std::size_t first = 0; first < deformation.influences.size(); first += each) {
        JointInfluences influences;
        for (std::size_t i = 0; i < each; ++i) {
            influences.joints[i] = static_cast<float>(deformation.influences[first + i].joint);
            influences.weights[i] = deformation.influences[first + i].weight;
        }
        store(influences, data.format, to);
        to += data.format.stride;
    }
}

} // namespace

MeshData interleave(const Primitive& primitive, bool skinned) {
    MeshData data;
    VertexFormat& format = data.format;
    format.position = reserve(format, true, sizeof(glm::vec3));
    format.normal = reserve(format, !primitive.normals.empty(), sizeof(glm::vec3));
    format.tangent = reserve(format, !primitive.tangents.empty(), sizeof(glm::vec4));
    for (std::size_t set = 0; set < format.uv.size(); ++set)
        format.uv[set] = reserve(format, !primitive.uv[set].empty(), sizeof(glm::vec2));
    format.color = reserve(format, !primitive.colors.empty(), sizeof(Color));
    format.joints = reserve(format, skinned, sizeof(JointInfluences::joints));
    format.weights = reserve(format, skinned, sizeof(JointInfluences::weights));

    data.vertices.resize(primitive.positions.size() * static_cast<std::size_t>(format.stride));
    Interleaving out{format, data.vertices, data.sources};
    out.write(primitive);
    if (skinned) {
        out.write(primitive.deformation->bind);
        writeJoints(*primitive.deformation, data);
    }
    data.indices = primitive.indices;
    return data;
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
            .indexType = static_cast<GLenum>(wide ? GL_UNSIGNED_INT : GL_UNSIGNED_SHORT),
            .sources = std::move(data.sources),
            .joints = std::move(data.joints)};
}

} // namespace

std::vector<MeshPart> partsOf(const Primitive& primitive, const Capabilities& capabilities) {
    const bool skinned = capabilities.joints && isForVertexShader(primitive);
    const std::size_t vertices =
        capabilities.wideIndices ? primitive.positions.size() + 3 : GpuMesh::kMaxShortVertices;
    MeshData whole = interleave(primitive, skinned);
    std::vector<MeshPart> parts;
    if (skinned || primitive.positions.size() > vertices)
        for (MeshData& part : split(whole, {vertices, skinned ? roomFor(*capabilities.joints) : kMaxJoints}))
            parts.push_back(partOf(std::move(part)));
    else
        parts.push_back(partOf(std::move(whole)));
    for (MeshPart& part : parts)
        part.deforms = primitive.deformation != nullptr;
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
                                  .indexType = part.indexType,
                                  .staging = part.deforms ? part.vertices : std::vector<std::uint8_t>(),
                                  .sources = std::move(part.sources),
                                  .joints = std::move(part.joints)});
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
        m_format.joints,
        m_format.weights,
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

void GpuMesh::draw(std::size_t part, const Gl& gl, GlState& state, unsigned attributes,
                   const std::array<int, 2>& uvSets, const PosedMesh* posed) const {
    const unsigned layout =
        attributes | static_cast<unsigned>(uvSets[0]) << 8 | static_cast<unsigned>(uvSets[1]) << 9;
    const GLuint vertices = (posed == nullptr ? m_parts[part].vertices : posed->vertices[part]).name();
    state.bindIndices(m_parts[part].indices.name());
    if (state.changesPointers(vertices, layout)) {
        state.bindVertices(vertices);
        setPointers(state, attributes, uvSets);
    }
    gl.DrawElements(GL_TRIANGLES, m_parts[part].count, m_parts[part].indexType, nullptr);
}

Result<PosedMesh> GpuMesh::makePosed(Device& device) const {
    PosedMesh posed;
    for (const Part& part : m_parts) {
        assert(!part.staging.empty() && "only what deforms has other poses");
        Result<MemoryLease> lease = device.memory.reserve(MemoryUse::Meshes, part.staging.size());
        if (!lease)
            return lease.error();
        Result<GlBuffer> buffer =
            uploadBuffer(device.gl, GL_ARRAY_BUFFER, std::as_bytes(std::span(part.staging)));
        if (!buffer)
            return buffer.error();
        posed.memory.push_back(*std::move(lease));
        posed.vertices.push_back(*std::move(buffer));
    }
    return posed;
}

// All of a buffer at once: a driver need not wait for the frame before, which may still read the old bytes.
void GpuMesh::upload(Device& device, const Vertices& vertices, const PosedMesh& posed) {
    for (std::size_t i = 0; i < m_parts.size(); ++i) {
        Part& part = m_parts[i];
        Interleaving{m_format, part.staging, part.sources}.write(vertices);
        device.state.bindVertices(posed.vertices[i].name());
        device.gl.BufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(part.staging.size()),
                                part.staging.data());
    }
}

} // namespace franken
