// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/gl.h"

#include <array>

namespace FRANKEN_API franken {

/// All of GL's state that this library touches (gl_state.h has the list), as plain data, to be set again.
/// Objects are kept by name. Of contexts beyond OpenGL ES 2.0: attribute arrays are those of the vertex array
/// object that is bound, which stays bound.
struct SavedState {
    struct Array {
        GLint enabled = 0, buffer = 0, size = 4, type = GL_FLOAT, normalized = 0, stride = 0;
        void* pointer = nullptr;
    };
    static constexpr std::array<GLenum, 9> kCapabilities = {
        GL_BLEND,  GL_DEPTH_TEST,          GL_CULL_FACE,                GL_SCISSOR_TEST,   GL_STENCIL_TEST,
        GL_DITHER, GL_POLYGON_OFFSET_FILL, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_COVERAGE};
    static constexpr std::size_t kUnits = 8, kArrays = 8;

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

    /// Asks for it: some 110 calls, for which a driver may have to finish what it was given.
    static SavedState of(const Gl& gl);

    /// Sets it: some 90 calls.
    void restore(const Gl& gl) const;
};

} // namespace franken
