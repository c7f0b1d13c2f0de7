// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/texture_role.h"
#include "franken/gl.h"

#include <array>
#include <optional>

namespace FRANKEN_API franken {

/// A copy of all GL state that this library changes (gl_state.h has the list), which can be restored. Objects
/// are kept by name. In contexts beyond OpenGL ES 2.0 (a toolkit's are, often), the attribute arrays are
/// those of the bound vertex array object, which stays bound; a core profile of desktop GL must have one
/// bound.
struct SavedState {
    /// glGetVertexAttrib's answers.
    struct Array {
        /// See Array.
        GLint enabled = 0, buffer = 0, size = 4, type = GL_FLOAT, normalized = 0, stride = 0;
        void* pointer = nullptr;
    };
    /// What OpenGL ES 3.0 and OpenGL 3.0 have beside it, and what transfers of pixels there depend on.
    struct Newer {
        /// Names of GL objects; 0 for none.
        GLint readFramebuffer = 0, packBuffer = 0, unpackBuffer = 0;
        std::array<GLint, 6> pixelStore{}; ///< Row length, rows and pixels to skip, of packing and unpacking.
    };
    /// What glIsEnabled() is asked.
    static constexpr std::array<GLenum, 9> kCapabilities = {
        GL_BLEND,          GL_DEPTH_TEST, GL_CULL_FACE,           GL_SCISSOR_TEST,
        GL_STENCIL_TEST,   GL_DITHER,     GL_POLYGON_OFFSET_FILL, GL_SAMPLE_ALPHA_TO_COVERAGE,
        GL_SAMPLE_COVERAGE};
    static constexpr std::size_t kUnits = kUsedTextureUnits; ///< Texture units that are kept.
    static constexpr std::size_t kArrays = 8; ///< What every GLES2 implementation has; programs use fewer.

    /// As glIsEnabled() and glGet answer.
    std::array<GLboolean, kCapabilities.size()> capabilities{};
    GLint program = 0, framebuffer = 0, renderbuffer = 0, arrayBuffer = 0, elementBuffer = 0;
    GLint activeTexture = GL_TEXTURE0;
    std::array<std::array<GLint, 2>, kUnits> textures{}; ///< 2D, cube
    std::array<Array, kArrays> arrays{};
    GLint depthFunction = 0, culledFace = 0, frontFace = 0;
    std::array<GLint, 2> blendEquations{}; ///< RGB, alpha
    std::array<GLint, 4> blendFactors{};   ///< Source and destination of RGB, and of alpha
    std::array<GLboolean, 4> colorMask{};
    GLboolean depthMask = 0;
    std::array<GLfloat, 4> clearColor{};
    std::array<GLfloat, 2> depthRange{};
    GLfloat clearDepth = 0;
    std::array<GLint, 4> viewport{}, scissorBox{};
    GLint packAlignment = 0, unpackAlignment = 0;
    std::optional<Newer> newer; ///< Where the context has it.

    /// Queries the state by some 120 GL calls, for which a driver may have to finish pending work.
    static SavedState of(const Gl& gl);

    /// Sets to 0 what the library relies on and OpenGL ES 2.0 does not have: buffers and rows of transfers of
    /// pixels. For whoever has a copy, to be restored.
    void takeOver(const Gl& gl) const;

    /// Restores the state by some 100 GL calls.
    void restore(const Gl& gl) const;
};

/// GL's state is taken over as long as the object lives, and is then what it was before.
class KeptState {
public:
    /// Takes the copy, and what SavedState::takeOver() sets.
    explicit KeptState(const Gl& gl) : m_gl(gl), m_state(SavedState::of(gl)) { m_state.takeOver(gl); }
    ~KeptState() { m_state.restore(m_gl); }
    KeptState(const KeptState&) = delete;
    KeptState& operator=(const KeptState&) = delete;

private:
    const Gl& m_gl;
    SavedState m_state;
};

} // namespace franken
