// SPDX-License-Identifier: MIT
#include "precision_probe.h"

#include "franken/gl_object.h"

#include <array>
#include <cstdint>
#include <string>

namespace franken {
namespace {

constexpr const char* kVertexShader = "attribute vec2 aPosition;\n"
                                      "void main() { gl_Position = vec4(aPosition, 0.0, 1.0); }\n";

// Uniforms alone, which no compiler can fold. Red: 1 + 2^-13 - 1, times 2^13, is 1 in 32 bits and 0 in 16.
// Green: 300^2 / 300 / 300 is 1, and infinite in 16 bits. Blue says that it is drawn at all.
constexpr const char* kFragmentShader = "uniform vec4 uOne;\n"    // 1, 2^-13, 1, 2^13
                                        "uniform vec2 uLength;\n" // 300, 1 / 300
                                        "void main() {\n"
                                        "  float step = ((uOne.x + uOne.y) - uOne.z) * uOne.w;\n"
                                        "  float square = uLength.x * uLength.x * uLength.y * uLength.y;\n"
                                        "  gl_FragColor = vec4(step, square < 2.0 ? 1.0 : 0.0, 1.0, 1.0);\n"
                                        "}\n";

std::string fragmentShader(std::string_view qualifier) {
    const std::string asked = "precision " + std::string(qualifier) + " float;\n";
    return "#ifdef GL_FRAGMENT_PRECISION_HIGH\n" + asked + "#else\nprecision mediump float;\n#endif\n" +
           kFragmentShader;
}

GlShader compiled(const Gl& gl, GLenum type, const std::string& text) {
    GlShader shader(gl, gl.CreateShader(type));
    const std::string whole = "#version 100\n" + text;
    const char* const source = whole.c_str();
    gl.ShaderSource(shader.name(), 1, &source, nullptr);
    gl.CompileShader(shader.name());
    return shader;
}

GlProgram linked(const Gl& gl, std::string_view qualifier) {
    const GlShader vertex = compiled(gl, GL_VERTEX_SHADER, kVertexShader);
    const GlShader fragment = compiled(gl, GL_FRAGMENT_SHADER, fragmentShader(qualifier));
    GlProgram program(gl, gl.CreateProgram());
    gl.AttachShader(program.name(), vertex.name());
    gl.AttachShader(program.name(), fragment.name());
    gl.BindAttribLocation(program.name(), 0, "aPosition");
    gl.LinkProgram(program.name());
    GLint done = GL_FALSE;
    gl.GetProgramiv(program.name(), GL_LINK_STATUS, &done);
    return done == GL_TRUE ? std::move(program) : GlProgram();
}

void drawPixel(const Gl& gl, const GlProgram& program) {
    constexpr std::array<float, 6> kTriangle = {-1, -1, 3, -1, -1, 3};
    const GlBuffer vertices(gl, generate(gl.GenBuffers));
    gl.BindBuffer(GL_ARRAY_BUFFER, vertices.name());
    gl.BufferData(GL_ARRAY_BUFFER, sizeof(kTriangle), kTriangle.data(), GL_STATIC_DRAW);
    gl.EnableVertexAttribArray(0);
    gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl.UseProgram(program.name());
    constexpr std::array<float, 4> kOne = {1, 1.0f / 8192, 1, 8192};
    constexpr std::array<float, 2> kLength = {300, 1.0f / 300};
    gl.Uniform4fv(gl.GetUniformLocation(program.name(), "uOne"), 1, kOne.data());
    gl.Uniform2fv(gl.GetUniformLocation(program.name(), "uLength"), 1, kLength.data());
    gl.Viewport(0, 0, 1, 1);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.DisableVertexAttribArray(0);
    gl.UseProgram(0);
}

} // namespace

Precision measuredPrecision(const Gl& gl, std::string_view qualifier) {
    const GlProgram program = linked(gl, qualifier);
    const GlTexture texture(gl, generate(gl.GenTextures));
    const GlFramebuffer framebuffer(gl, generate(gl.GenFramebuffers));
    if (!program || !texture || !framebuffer)
        return Precision::Fp32;
    GLint bound = 0;
    std::array<GLint, 4> viewport{};
    gl.GetIntegerv(GL_FRAMEBUFFER_BINDING, &bound);
    gl.GetIntegerv(GL_VIEWPORT, viewport.data());
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, texture.name());
    constexpr std::array<std::uint8_t, 4> kNothing{}; // What memory held before is no measurement.
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, kNothing.data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.name(), 0);
    gl.Disable(GL_BLEND);
    gl.Disable(GL_CULL_FACE);
    gl.Disable(GL_DEPTH_TEST);
    gl.Disable(GL_SCISSOR_TEST);
    gl.Disable(GL_STENCIL_TEST);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    drawPixel(gl, program);
    std::array<std::uint8_t, 4> pixel{};
    gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
    gl.BindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound));
    gl.Viewport(viewport[0], viewport[1], viewport[2], viewport[3]);
    const bool drawn = pixel[2] > 127;
    return drawn && (pixel[0] < 128 || pixel[1] < 128) ? Precision::Fp16 : Precision::Fp32;
}

} // namespace franken
