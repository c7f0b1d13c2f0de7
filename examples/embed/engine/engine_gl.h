// SPDX-License-Identifier: MIT
#pragma once

#include "world.h"

#include <GLES2/gl2.h>

/// The engine's own GL loader: the functions that it calls itself.
#define ENGINE_GL_FUNCTIONS(X)                                                                               \
    X(ActiveTexture)                                                                                         \
    X(AttachShader)                                                                                          \
    X(BindBuffer)                                                                                            \
    X(BindTexture) X(BufferData) X(Clear) X(ClearColor) X(CompileShader) X(CreateProgram) X(CreateShader)    \
        X(Disable) X(DisableVertexAttribArray) X(DrawArrays) X(DrawElements) X(Enable)                       \
            X(EnableVertexAttribArray) X(GenBuffers) X(GenTextures) X(GetAttribLocation) X(GetError)         \
                X(GetUniformLocation) X(LinkProgram) X(ReadPixels) X(ShaderSource) X(TexImage2D)             \
                    X(TexParameteri) X(Uniform1f) X(UseProgram) X(VertexAttribPointer) X(Viewport)

struct EngineGl {
#define ENGINE_GL_MEMBER(name) decltype(&::gl##name) name = nullptr;
    ENGINE_GL_FUNCTIONS(ENGINE_GL_MEMBER)
#undef ENGINE_GL_MEMBER

    static EngineGl load();
};

struct GpuMesh {
    GLuint vertices = 0, triangles = 0;
    GLsizei count = 0;
};

GpuMesh upload(const EngineGl& gl, const Mesh& mesh);
GLuint upload(const EngineGl& gl, const Bitmap& bitmap);

/// The engine's own pass: a gradient over the whole screen, by its own program, which leaves its own state.
class Background {
public:
    explicit Background(const EngineGl& gl);
    void draw(float seconds) const;

private:
    const EngineGl& m_gl;
    GLuint m_program = 0, m_corners = 0;
};
