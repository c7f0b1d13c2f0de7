// SPDX-License-Identifier: MIT
#include "program.h"

#include <array>

using namespace franken;

namespace {

Result<GLuint> compileShader(GLenum stage, const ComposedStage& text) {
    const GLuint shader = glCreateShader(stage);
    const char* const source = text.text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE)
        return shader;
    std::array<char, 4096> log{};
    glGetShaderInfoLog(shader, log.size(), nullptr, log.data());
    return Error{"shader", "", annotateLog(log.data(), text), ""};
}

const float* blockOf(const Values& values, Block block) {
    switch (block) {
    case Block::Frame:
        return reinterpret_cast<const float*>(&values.frame);
    case Block::Lights:
        return reinterpret_cast<const float*>(&values.lights);
    case Block::Material:
        return reinterpret_cast<const float*>(&values.material);
    case Block::Object:
    case Block::Skin: // Of skins and effects, which this program has none of.
    case Block::User:
        break;
    }
    return reinterpret_cast<const float*>(&values.object);
}

void setUniform(GLint location, const Uniform& uniform, const float* value) {
    switch (uniform.type) {
    case Type::Float:
        return glUniform1fv(location, uniform.count, value);
    case Type::Vec2:
        return glUniform2fv(location, uniform.count, value);
    case Type::Vec3:
        return glUniform3fv(location, uniform.count, value);
    case Type::Vec4:
        return glUniform4fv(location, uniform.count, value);
    case Type::Mat3:
        return glUniformMatrix3fv(location, uniform.count, GL_FALSE, value);
    case Type::Mat4:
        return glUniformMatrix4fv(location, uniform.count, GL_FALSE, value);
    case Type::Sampler2D:
    case Type::SamplerCube:
        break; // In Interface::samplers, not among the uniforms.
    }
}

} // namespace

Result<GLuint> makeProgram(const Composed& composed) {
    const Result<GLuint> vertex = compileShader(GL_VERTEX_SHADER, composed.vertex);
    if (!vertex)
        return vertex;
    const Result<GLuint> fragment = compileShader(GL_FRAGMENT_SHADER, composed.fragment);
    if (!fragment)
        return fragment;
    const GLuint program = glCreateProgram();
    glAttachShader(program, *vertex);
    glAttachShader(program, *fragment);
    for (const Attribute& attribute : composed.interface.attributes)
        glBindAttribLocation(program, static_cast<GLuint>(attribute.location), attribute.name.c_str());
    glLinkProgram(program);
    GLint linked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE)
        return Error{"link", "", "the program does not link", ""};
    glUseProgram(program);
    return program;
}

void setUniforms(GLuint program, const Interface& interface, const Values& values) {
    for (const Uniform& uniform : interface.uniforms)
        setUniform(glGetUniformLocation(program, uniform.name.c_str()), uniform,
                   blockOf(values, uniform.block) + fieldOffset(uniform.block, uniform.name));
    for (const Sampler& sampler : interface.samplers)
        glUniform1i(glGetUniformLocation(program, sampler.name.c_str()), sampler.unit);
}
