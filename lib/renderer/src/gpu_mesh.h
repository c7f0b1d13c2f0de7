// SPDX-License-Identifier: MIT
#pragma once

#include "franken/gl_state.h"
#include "franken/scene.h"
#include "gpu_texture.h"

#include <array>
#include <cstdint>
#include <vector>

namespace franken {

/// Where attributes lie in an interleaved vertex, in bytes; -1 for what a mesh lacks. Their types are those
/// of kAttributeFormats.
struct VertexFormat {
    int stride = 0;
    int position = 0, normal = -1, tangent = -1, color = -1;
    std::array<int, 2> uv{-1, -1}; ///< TEXCOORD_0 and TEXCOORD_1
};

/// A primitive, or a part of one, as a vertex and an index buffer hold it.
struct MeshData {
    VertexFormat format;
    std::vector<std::uint8_t> vertices;
    std::vector<std::uint32_t> indices;
};

MeshData interleave(const Primitive& primitive);

/// The same triangles in parts of at most `maxVertices` (3 and up) vertices each.
std::vector<MeshData> split(const MeshData& whole, std::size_t maxVertices);

/// A primitive's buffers. Indices are 16 bits wide where that is enough; beyond kMaxShortVertices they are 32
/// bits wide, or the primitive is split, as the context has it.
class GpuMesh {
public:
    /// 16-bit indices up to 65,534: where primitive restart is always on, as in WebGL 2, 65,535 is no vertex.
    static constexpr std::size_t kMaxShortVertices = 65'535;

    /// Fails with "memory.budget" and with "gl.object".
    static Result<GpuMesh> make(Device& device, const Primitive& primitive);

    /// Draws with the program in use, whose attribute arrays (those and no others) are enabled. uvSets: which
    /// TEXCOORD_n is fed to each UV stream.
    void draw(const Gl& gl, GlState& state, unsigned attributes, const std::array<int, 2>& uvSets) const;

private:
    struct Part {
        GlBuffer vertices, indices;
        MemoryLease memory;
        GLsizei count = 0;
        GLenum indexType = GL_UNSIGNED_SHORT;
    };

    Result<void> addPart(Device& device, const MeshData& data);
    void setPointers(GlState& state, unsigned attributes, const std::array<int, 2>& uvSets) const;

    VertexFormat m_format;
    std::vector<Part> m_parts;
};

} // namespace franken
