// SPDX-License-Identifier: MIT
#include "engine_gl.h"

#include "context.h"

EngineGl EngineGl::load() {
    EngineGl gl;
#define ENGINE_GL_LOAD(name)                                                                                 \
    gl.name = reinterpret_cast<decltype(gl.name)>(Context::getProcAddress("gl" #name));
    ENGINE_GL_FUNCTIONS(ENGINE_GL_LOAD)
#undef ENGINE_GL_LOAD
    return gl;
}

GpuMesh upload(const EngineGl& gl, const Mesh& mesh) {
    GpuMesh uploaded;
    gl.GenBuffers(1, &uploaded.vertices);
    gl.BindBuffer(GL_ARRAY_BUFFER, uploaded.vertices);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(Vertex)),
                  mesh.vertices.data(), GL_STATIC_DRAW);
    gl.GenBuffers(1, &uploaded.triangles);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, uploaded.triangles);
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(2 * mesh.triangles.size()),
                  mesh.triangles.data(), GL_STATIC_DRAW);
    uploaded.count = static_cast<GLsizei>(mesh.triangles.size());
    return uploaded;
}

GLuint upload(const EngineGl& gl, const Bitmap& bitmap) {
    GLuint texture = 0;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, bitmap.size, bitmap.size, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  bitmap.texels.data());
    return texture;
}

namespace {

constexpr const char* kVertexShader = "attribute vec2 corner;\n"
                                      "varying vec2 place;\n"
                                      "void main() {\n"
                                      "  place = 0.5 * corner + 0.5;\n"
                                      "  gl_Position = vec4(corner, 0.0, 1.0);\n"
                                      "}\n";
constexpr const char* kFragmentShader =
    "precision mediump float;\n"
    "uniform float seconds;\n"
    "varying vec2 place;\n"
    "void main() {\n"
    "  float wave = 0.02 * sin(12.0 * place.x + seconds);\n"
    "  gl_FragColor = vec4(mix(vec3(0.35, 0.30, 0.30), vec3(0.10, 0.13, 0.20), place.y + wave), 1.0);\n"
    "}\n";

} // namespace

Background::Background(const EngineGl& gl) : m_gl(gl), m_program(gl.CreateProgram()) {
    for (const auto& [stage, source] :
         {std::pair{GL_VERTEX_SHADER, kVertexShader}, std::pair{GL_FRAGMENT_SHADER, kFragmentShader}}) {
        const GLuint shader = gl.CreateShader(static_cast<GLenum>(stage));
        gl.ShaderSource(shader, 1, &source, nullptr);
        gl.CompileShader(shader);
        gl.AttachShader(m_program, shader);
    }
    gl.LinkProgram(m_program);
    constexpr float kCorners[] = {-1, -1, 3, -1, -1, 3};
    gl.GenBuffers(1, &m_corners);
    gl.BindBuffer(GL_ARRAY_BUFFER, m_corners);
    gl.BufferData(GL_ARRAY_BUFFER, sizeof(kCorners), kCorners, GL_STATIC_DRAW);
}

void Background::draw(float seconds) const {
    const auto corner = static_cast<GLuint>(m_gl.GetAttribLocation(m_program, "corner"));
    m_gl.Disable(GL_DEPTH_TEST);
    m_gl.Disable(GL_CULL_FACE);
    m_gl.UseProgram(m_program);
    m_gl.Uniform1f(m_gl.GetUniformLocation(m_program, "seconds"), seconds);
    m_gl.BindBuffer(GL_ARRAY_BUFFER, m_corners);
    m_gl.EnableVertexAttribArray(corner);
    m_gl.VertexAttribPointer(corner, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    m_gl.DrawArrays(GL_TRIANGLES, 0, 3);
    m_gl.DisableVertexAttribArray(corner);
}
