// SPDX-License-Identifier: MIT
#include "support/scene.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace franken::test {

namespace {

constexpr const char* kVertex = R"(#version 100
attribute vec4 position;
attribute vec4 colour;
uniform mat4 clip;
varying vec4 passed;
void main() {
    gl_Position = clip * position;
    passed = colour;
}
)";

constexpr const char* kFragment = R"(#version 100
precision highp float;
varying vec4 passed;
void main() { gl_FragColor = passed; }
)";

struct Vertex {
    float x, y, z, r, g, b;
};

constexpr Vertex kVertices[] = {
    {-1, -1, 0, 0.1f, 0.0f, 0.4f},
    {1, -1, 0, 0.9f, 0.1f, 0.2f},
    {-1, 1, 0, 0.0f, 0.8f, 0.3f},
    {-1, 1, 0, 0.0f, 0.8f, 0.3f},
    {1, -1, 0, 0.9f, 0.1f, 0.2f},
    {1, 1, 0, 0.5f, 0.6f, 1.0f},
    {-0.6137f, -0.5113f, -0.4719f, 1, 0.7f, 0},
    {0.7043f, -0.3071f, 0.3733f, 0, 1, 1},
    {0.1019f, 0.8089f, -0.2141f, 1, 0, 1},
    {-0.9511f, 0.7019f, -0.9f, 1, 1, 1},
    {-0.9511f, 0.9533f, -0.9f, 1, 1, 1},
    {-0.7027f, 0.9533f, -0.9f, 1, 1, 1},
};

} // namespace

VmScene::VmScene(const platform::GetProcAddress& getProcAddress) : m_gl(Gl::load(getProcAddress).value()) {
    const auto compile = [&](GLenum stage, const char* source) {
        GlShader shader(m_gl, m_gl.CreateShader(stage));
        m_gl.ShaderSource(shader.name(), 1, &source, nullptr);
        m_gl.CompileShader(shader.name());
        return shader;
    };
    const GlShader vertex = compile(GL_VERTEX_SHADER, kVertex),
                   fragment = compile(GL_FRAGMENT_SHADER, kFragment);
    m_program = GlProgram(m_gl, m_gl.CreateProgram());
    m_gl.AttachShader(m_program.name(), vertex.name());
    m_gl.AttachShader(m_program.name(), fragment.name());
    m_gl.BindAttribLocation(m_program.name(), 0, "position");
    m_gl.BindAttribLocation(m_program.name(), 1, "colour");
    m_gl.LinkProgram(m_program.name());
}

void VmScene::draw(platform::Size size, platform::Rotation rotation, bool upsideDown) const {
    m_gl.Viewport(0, 0, size.width, size.height);
    m_gl.Enable(GL_DEPTH_TEST);
    m_gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    m_gl.UseProgram(m_program.name());
    std::array<float, 16> clip = platform::clipRotation(rotation);
    if (upsideDown)
        for (const std::size_t ofY : {1u, 5u})
            clip[ofY] = -clip[ofY];
    m_gl.UniformMatrix4fv(m_gl.GetUniformLocation(m_program.name(), "clip"), 1, GL_FALSE, clip.data());
    m_gl.BindBuffer(GL_ARRAY_BUFFER, 0);
    for (const GLuint attribute : {0u, 1u}) {
        m_gl.EnableVertexAttribArray(attribute);
        m_gl.VertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                                 attribute == 0 ? &kVertices[0].x : &kVertices[0].r);
    }
    m_gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(std::size(kVertices)));
}

VmPicture readPicture(const Gl& gl, platform::Size size) {
    const auto width = static_cast<std::size_t>(size.width), height = static_cast<std::size_t>(size.height);
    std::vector<std::uint8_t> bytes(width * height * 4);
    gl.ReadPixels(0, 0, size.width, size.height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    VmPicture picture{size, {}};
    for (std::size_t y = height; y-- > 0;)
        for (std::size_t x = 0; x < width; ++x) {
            const std::uint8_t* pixel = &bytes[(y * width + x) * 4];
            picture.pixels.push_back(std::uint32_t{pixel[0]} << 16 | std::uint32_t{pixel[1]} << 8 | pixel[2]);
        }
    return picture;
}

void writePpm(const VmPicture& picture, const std::string& name) {
    const char* folder = std::getenv("GUEST_FOLDER");
    std::ofstream file(std::string(folder == nullptr ? "." : folder) + "/" + name + ".ppm", std::ios::binary);
    file << "P6\n" << picture.size.width << ' ' << picture.size.height << "\n255\n";
    for (const std::uint32_t pixel : picture.pixels)
        file << static_cast<char>(pixel >> 16) << static_cast<char>(pixel >> 8) << static_cast<char>(pixel);
}

std::string difference(const VmPicture& a, const VmPicture& b) {
    if (a.size != b.size)
        return "the sizes differ";
    std::size_t count = 0;
    char first[80] = "";
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        if (a.pixels[i] != b.pixels[i] && count++ == 0)
            std::snprintf(first, sizeof first, ", first at (%zu, %zu): %06x, %06x",
                          i % static_cast<std::size_t>(a.size.width),
                          i / static_cast<std::size_t>(a.size.width), a.pixels[i], b.pixels[i]);
    return std::to_string(count) + " of " + std::to_string(a.pixels.size()) + " differ" + first;
}

} // namespace franken::test
