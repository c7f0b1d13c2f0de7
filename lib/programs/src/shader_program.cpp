// SPDX-License-Identifier: MIT
#include "franken/shader_program.h"

#include "franken/generator/pack.h"

#include <atomic>
#include <cassert>

namespace franken {

std::uint64_t newSerials(std::uint64_t count) {
    static std::atomic<std::uint64_t> next{1};
    return next.fetch_add(count);
}

ShaderProgram::ShaderProgram(const Gl& gl, GLuint program, Interface interface)
    : m_gl(&gl), m_name(program), m_interface(std::move(interface)) {
    for (const Attribute& attribute : m_interface.attributes)
        m_attributes |= 1u << attribute.location;
    for (const Uniform& uniform : m_interface.uniforms)
        addSlot(uniform);
    m_gl->UseProgram(name());
    for (const Sampler& sampler : m_interface.samplers)
        m_gl->Uniform1i(m_gl->GetUniformLocation(name(), sampler.name.c_str()), sampler.unit);
}

ShaderProgram::~ShaderProgram() {
    if (m_name != 0)
        m_gl->DeleteProgram(m_name);
}

void ShaderProgram::addSlot(const Uniform& uniform) {
    const GLint location = m_gl->GetUniformLocation(name(), uniform.name.c_str());
    const int offset = fieldOffset(uniform);
    assert(offset >= 0);
    if (location >= 0)
        m_slots[static_cast<std::size_t>(uniform.block)].push_back(
            {location, uniform.type, uniform.count, offset});
}

void ShaderProgram::feed(const BlockViews& blocks) {
    for (std::size_t block = 0; block < blocks.size(); ++block)
        feed(static_cast<Block>(block), blocks[block]);
}

void ShaderProgram::feed(Block block, const BlockView& view) {
    const auto index = static_cast<std::size_t>(block);
    if (view.values == nullptr || m_seen[index] == view.serial)
        return;
    m_seen[index] = view.serial;
    for (const Slot& slot : m_slots[index])
        upload(slot, view.values + slot.offset);
}

void ShaderProgram::upload(const Slot& slot, const float* values) const {
    switch (slot.type) {
    case Type::Float:
        return m_gl->Uniform1fv(slot.location, slot.count, values);
    case Type::Vec2:
        return m_gl->Uniform2fv(slot.location, slot.count, values);
    case Type::Vec3:
        return m_gl->Uniform3fv(slot.location, slot.count, values);
    case Type::Vec4:
        return m_gl->Uniform4fv(slot.location, slot.count, values);
    case Type::Mat3:
        return m_gl->UniformMatrix3fv(slot.location, slot.count, GL_FALSE, values);
    case Type::Mat4:
        return m_gl->UniformMatrix4fv(slot.location, slot.count, GL_FALSE, values);
    case Type::Sampler2D:
    case Type::SamplerCube:
        break;
    }
    assert(false && "a sampler is no uniform of a block");
}

} // namespace franken
