// SPDX-License-Identifier: MIT
#pragma once

#include "franken/gl_state.h"
#include "franken/scene.h"
#include "gpu_buffer.h"
#include "gpu_texture.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace franken {

/// Where attributes lie in an interleaved vertex, in bytes; -1 for what a mesh lacks. Their types are those
/// of kAttributeFormats.
struct VertexFormat {
    int stride = 0;
    int position = 0, normal = -1, tangent = -1, color = -1;
    std::array<int, 2> uv{-1, -1}; ///< TEXCOORD_0 and TEXCOORD_1
    int joints = -1, weights = -1; ///< What has them is as it was bound, and else as it is at rest.
};

/// A primitive, or a part of one, as a vertex and an index buffer hold it.
struct MeshData {
    VertexFormat format;
    std::vector<std::uint8_t> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<std::uint32_t> sources = {}; ///< Of a part: its vertices, by their index in the primitive.
    std::vector<std::uint32_t> joints = {};  ///< Of a part: its palette, by their index in the skin.
};

/// `skinned`: with joints, for isForVertexShader().
MeshData interleave(const Primitive& primitive, bool skinned = false);

/// What a part has room for.
struct PartLimits {
    std::size_t vertices;    ///< 3 and up
    std::size_t joints = 12; ///< As many as move a triangle, and up
};

/// The same triangles in parts, in whose vertices joints are those of the part's own palette: where in it
/// their rows begin.
std::vector<MeshData> split(const MeshData& whole, PartLimits limits);

/// What one draw takes, as buffers hold it. Needs no GL.
struct MeshPart {
    VertexFormat format;
    std::vector<std::uint8_t> vertices, indices;
    GLsizei count = 0;
    GLenum indexType = GL_UNSIGNED_SHORT;
    bool deforms = false;                    ///< Its vertices will be needed again.
    std::vector<std::uint32_t> sources = {}; ///< As those of MeshData; empty for a whole primitive.
    std::vector<std::uint32_t> joints = {};  ///< As those of MeshData; empty where no joint moves it.

    std::size_t bytes() const { return vertices.size() + indices.size(); }
};

/// A primitive as one part, or several. Indices are 16 bits wide where that is enough; beyond
/// kMaxShortVertices they are 32 bits wide, or the primitive is split, as the context has it; so it is where
/// it has more joints than a palette of the context.
std::vector<MeshPart> partsOf(const Primitive& primitive, const Capabilities& capabilities);

/// What posed vertices are of. Morph targets alone: where a program moves them on to their joints.
struct PoseSource {
    unsigned pose = 0; ///< Place::poses
    bool withJoints = false;
    std::vector<float> weights = {};
};

/// The vertices of a primitive in the pose of one place, part by part.
struct PosedMesh {
    std::vector<GlBuffer> vertices = {};
    std::vector<MemoryLease> memory = {};
    std::optional<PoseSource> source = {}; ///< None yet.
};

/// A primitive's buffers.
class GpuMesh {
public:
    /// 16-bit indices up to 65,534: where primitive restart is always on, as in WebGL 2, 65,535 is no vertex.
    static constexpr std::size_t kMaxShortVertices = 65'535;

    std::size_t parts() const { return m_parts.size(); }
    /// Whether its vertices are as they were bound, and have joints.
    bool isSkinned() const { return m_format.joints >= 0; }
    /// The palette of a part: indices into the skin's joints.
    std::span<const std::uint32_t> jointsOf(std::size_t part) const { return m_parts[part].joints; }

    /// Draws a part with the program in use, whose attribute arrays (those and no others) are enabled.
    /// uvSets: which TEXCOORD_n is fed to each UV stream. `posed`: the vertices to draw in place of the
    /// mesh's own; may be null.
    void draw(std::size_t part, const Gl& gl, GlState& state, unsigned attributes,
              const std::array<int, 2>& uvSets, const PosedMesh* posed) const;

    /// Room for the vertices in another pose; only of a primitive that deforms. Fails with "memory.budget"
    /// and "gl.object".
    Result<PosedMesh> makePosed(Device& device) const;
    /// Fills it. Allocates nothing.
    void upload(Device& device, const Vertices& vertices, const PosedMesh& posed);

private:
    friend class MeshUpload;
    struct Part {
        GlBuffer vertices, indices;
        MemoryLease memory;
        GLsizei count = 0;
        GLenum indexType = GL_UNSIGNED_SHORT;
        std::vector<std::uint8_t> staging = {};  ///< Vertices, of what deforms: those of the last upload().
        std::vector<std::uint32_t> sources = {}; ///< As those of MeshData.
        std::vector<std::uint32_t> joints = {};  ///< As those of MeshData.
    };

    void setPointers(GlState& state, unsigned attributes, const std::array<int, 2>& uvSets) const;

    VertexFormat m_format;
    std::vector<Part> m_parts;
};

/// A mesh that is uploaded in parts.
class MeshUpload {
public:
    explicit MeshUpload(std::vector<MeshPart> parts);

    bool isDone() const { return m_next == m_parts.size() && !m_buffer; }
    /// Uploads a piece of one buffer; how many bytes it has. Fails with "memory.budget" and "gl.object".
    /// Leaves GL's buffers bound.
    Result<std::size_t> step(Device& device, std::size_t maxBytes);
    GpuMesh take() { return std::move(m_mesh); }

private:
    Result<void> beginBuffer(Device& device);
    void endBuffer();

    std::vector<MeshPart> m_parts;
    std::size_t m_next = 0; ///< The part whose buffers come next, or are being filled.
    bool m_ofIndices = false;
    std::optional<BufferUpload> m_buffer;
    GpuMesh m_mesh;
};

} // namespace franken
