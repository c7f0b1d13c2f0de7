// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/texture_role.h"
#include "franken/gl.h"

#include <array>
#include <cstdint>
#include <optional>

namespace FRANKEN_API franken {

/// A shadow copy of GL's state, so that nothing is set twice and nothing is queried. GLES2 has no vertex
/// array objects, and drivers check much at each call: a call that changes nothing still costs.
///
/// All drawing of this library goes through a GlState. The library changes this state,
///
/// | state | while the library draws |
/// |---|---|
/// | program, texture bindings of units 0 to 7 (2D and cube), active unit | what the material needs |
/// | array and element array buffer, arrays 0 to 7 and their pointers | what the mesh needs |
/// | blending, depth test, depth writes, face culling, culled face, front face | by pass and material |
/// | blend equation and function | add; source alpha, one minus source alpha (alpha: one, same) |
/// | depth function, depth range, colour mask | less or equal, 0 to 1 (overlays: 0), all |
/// | stencil and dither, polygon offset, alpha to coverage, sample coverage | off |
/// | scissor, its box | off; on while an area of the target is cleared |
/// | framebuffer, viewport, clear colour, clear depth | the target's |
/// | loading and reading alone: unpack and pack alignment | 4 |
/// | compiling alone: render buffer | one of the library's own |
///
/// and no other: other pixel store, hints, line width, generic attribute values and stencil functions stay as
/// they were. After drawing, the state is that of the last draw; Renderer::releaseState() brings back what
/// was there before. An application that calls GL in the same context may change any state; it then calls
/// invalidate(), once, before the library draws again.
///
/// Belongs to the thread of its context. Calls that change state do nothing else.
class GlState {
public:
    /// The table must outlive the object. Nothing is known at first.
    explicit GlState(const Gl& gl) : m_gl(&gl) {}

    /// For when someone else used the context, or GL objects were deleted: every state is set again when
    /// needed.
    void invalidate() { *this = GlState(*m_gl); }

    /// Sets all state that is the same for all draws of the library, unless it is known to be set.
    void setBaseline();

    /// Sets it, unless it is known to be set; so do all functions below.
    void setClearColor(const std::array<float, 4>& color);
    void setScissorTest(bool on) { setCapability(m_scissorTest, GL_SCISSOR_TEST, on); }
    void setBlending(bool on) { setCapability(m_blending, GL_BLEND, on); }
    void setDepthTest(bool on) { setCapability(m_depthTest, GL_DEPTH_TEST, on); }
    void setCulling(bool on) { setCapability(m_culling, GL_CULL_FACE, on); }
    void setDepthWrites(bool on);
    void setDepthRange(float near, float far);
    void setFrontFace(GLenum winding);
    void setCulledFace(GLenum face);

    void useProgram(GLuint program); ///< Program 0 is none.
    /// unit: 0 to 7. target: GL_TEXTURE_2D or GL_TEXTURE_CUBE_MAP.
    void bindTexture(unsigned unit, GLenum target, GLuint texture);
    /// To unit 0, which is active then: glTexSubImage2D() writes to it.
    void bindForUpload(GLuint texture);
    void bindVertices(GLuint buffer);
    void bindIndices(GLuint buffer);
    /// Enables the arrays of those locations (bit n: location n) and no others.
    void enableArrays(unsigned locations);
    /// Whether the pointers of the enabled arrays must be set, because they were last set for another buffer
    /// or another layout of it. `layout` is any number that tells the layouts of one buffer apart.
    bool changesPointers(GLuint buffer, unsigned layout);

    /// Where an array lies in the buffer that bindVertices() bound.
    struct Pointer {
        GLint size;     ///< Numbers of a vertex, 1-4.
        GLenum type;    ///< Types other than GL_FLOAT are normalised.
        GLsizei stride; ///< Bytes from a vertex to the next.
        int offset;     ///< Bytes.
        bool operator==(const Pointer&) const = default;
    };
    /// glVertexAttribPointer(), of the buffer that is bound.
    void setPointer(GLuint location, const Pointer& pointer);

private:
    static constexpr std::size_t kArrays = 8;
    static constexpr GLuint kUnknown = ~GLuint{0};

    template<typename Value>
    struct Of {
        GLuint buffer;
        Value value;
        bool operator==(const Of&) const = default;
    };

    void activate(unsigned unit);
    void setCapability(std::optional<bool>& known, GLenum capability, bool on);

    const Gl* m_gl;
    bool m_hasBaseline = false;
    std::optional<std::array<float, 4>> m_clearColor;
    std::optional<std::array<float, 2>> m_depthRange;
    std::optional<bool> m_scissorTest, m_blending, m_depthTest, m_culling, m_depthWrites;
    GLenum m_frontFace = 0, m_culledFace = 0;
    GLuint m_program = kUnknown, m_vertices = kUnknown, m_indices = kUnknown;
    unsigned m_unit = kUnknown;
    std::array<std::array<GLuint, 2>, kTextureUnits> m_textures = unknownTextures(); ///< 2D, cube
    std::optional<unsigned> m_arrays;
    std::optional<Of<unsigned>> m_layout;
    std::array<std::optional<Of<Pointer>>, kArrays> m_pointers;

    static constexpr std::array<std::array<GLuint, 2>, kTextureUnits> unknownTextures() {
        std::array<std::array<GLuint, 2>, kTextureUnits> textures{};
        for (std::array<GLuint, 2>& unit : textures)
            unit = {kUnknown, kUnknown};
        return textures;
    }
};

} // namespace franken
