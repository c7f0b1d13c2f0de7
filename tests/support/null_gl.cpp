// SPDX-License-Identifier: MIT
#include "support/null_gl.h"

namespace franken::test {
namespace {

template<typename Function>
struct Nothing;

template<typename Return, typename... Arguments>
struct Nothing<Return(GL_APIENTRY*)(Arguments...)> {
    static Return GL_APIENTRY call(Arguments...) { return Return(); }
};

GLuint lastName = 0;

void GL_APIENTRY generateNames(GLsizei count, GLuint* names) {
    for (GLsizei i = 0; i < count; ++i)
        names[i] = ++lastName;
}

} // namespace

Gl nullGl() {
    Gl gl;
#define FRANKEN_NULL(name) gl.name = Nothing<decltype(gl.name)>::call;
    FRANKEN_GL_FUNCTIONS(FRANKEN_NULL)
#undef FRANKEN_NULL
    gl.GenBuffers = gl.GenFramebuffers = gl.GenRenderbuffers = gl.GenTextures = generateNames;
    gl.CreateProgram = [] { return ++lastName; };
    gl.CreateShader = [](GLenum) { return ++lastName; };
    gl.GetShaderiv = [](GLuint, GLenum, GLint* value) { *value = GL_TRUE; };
    gl.GetProgramiv = [](GLuint, GLenum, GLint* value) { *value = GL_TRUE; };
    gl.GetUniformLocation = [](GLuint, const GLchar*) { return static_cast<GLint>(++lastName); };
    gl.GetString = [](GLenum) { return reinterpret_cast<const GLubyte*>("OpenGL ES 3.0"); };
    gl.GetIntegerv = [](GLenum, GLint* value) { *value = 4096; };
    gl.CheckFramebufferStatus = [](GLenum) -> GLenum { return GL_FRAMEBUFFER_COMPLETE; };
    return gl;
}

} // namespace franken::test
