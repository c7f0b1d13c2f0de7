// SPDX-License-Identifier: MIT
#pragma once

#include "franken/capabilities.h"
#include "franken/gl_object.h"
#include "franken/scene.h"

#include <array>
#include <cstdint>
#include <vector>

namespace franken {

/// Where attributes lie in an interleaved vertex, in bytes; -1 for what a mesh lacks. Every attribute has one
/// format in all meshes, because the Pi's drivers compile a program again for another: floats, and colours
/// as four normalised unsigned shorts.
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

/// A primitive's buffers. Indices are 16 bits wide where that is enough; beyond 65,536 vertices they are 32
/// bits wide, or the primitive is split, as the context has it.
class GpuMesh {
public:
    GpuMesh(const Gl& gl, const Primitive& primitive, const Capabilities& capabilities);

    /// Draws with the program in use, whose attribute arrays (those and no others) are enabled. uvSets: which
    /// TEXCOORD_n is fed to each UV stream.
    void draw(const Gl& gl, unsigned attributes, const std::array<int, 2>& uvSets) const;

private:
    struct Part {
        GlBuffer vertices, indices;
        GLsizei count = 0;
        GLenum indexType = GL_UNSIGNED_SHORT;
    };

    void addPart(const Gl& gl, const MeshData& data);
    void setPointers(const Gl& gl, unsigned attributes, const std::array<int, 2>& uvSets) const;

    VertexFormat m_format;
    std::vector<Part> m_parts;
};

} // namespace franken
