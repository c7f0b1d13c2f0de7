// SPDX-License-Identifier: MIT
#include "franken/gl_state.h"

#include <cassert>

namespace franken {
namespace {

/// Notes the value; whether it was another one.
template<typename Known, typename Value>
bool changes(Known& known, const Value& value) {
    if (known == value)
        return false;
    known = value;
    return true;
}

} // namespace

void GlState::setBaseline() {
    if (!changes(m_hasBaseline, true))
        return;
    setScissorTest(false);
    for (const GLenum capability : {GL_STENCIL_TEST, GL_DITHER, GL_POLYGON_OFFSET_FILL,
                                    GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_COVERAGE})
        m_gl->Disable(capability);
    m_gl->DepthFunc(GL_LEQUAL);
    setDepthRange(0, 1);
    m_gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    setCulledFace(GL_BACK);
    m_gl->BlendEquation(GL_FUNC_ADD);
    m_gl->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    m_gl->ClearDepthf(1);
}

void GlState::setClearColor(const std::array<float, 4>& color) {
    if (changes(m_clearColor, color))
        m_gl->ClearColor(color[0], color[1], color[2], color[3]);
}

void GlState::setCapability(std::optional<bool>& known, GLenum capability, bool on) {
    if (changes(known, on))
        on ? m_gl->Enable(capability) : m_gl->Disable(capability);
}

void GlState::setDepthWrites(bool on) {
    if (changes(m_depthWrites, on))
        m_gl->DepthMask(on ? GL_TRUE : GL_FALSE);
}

void GlState::setDepthRange(float near, float far) {
    if (changes(m_depthRange, std::array{near, far}))
        m_gl->DepthRangef(near, far);
}

void GlState::setFrontFace(GLenum winding) {
    if (changes(m_frontFace, winding))
        m_gl->FrontFace(winding);
}

void GlState::setCulledFace(GLenum face) {
    if (changes(m_culledFace, face))
        m_gl->CullFace(face);
}

void GlState::useProgram(GLuint program) {
    if (changes(m_program, program))
        m_gl->UseProgram(program);
}

void GlState::bindTexture(unsigned unit, GLenum target, GLuint texture) {
    assert(unit < kTextureUnits);
    if (!changes(m_textures[unit][target == GL_TEXTURE_CUBE_MAP ? 1 : 0], texture))
        return;
    activate(unit);
    m_gl->BindTexture(target, texture);
}

void GlState::bindForUpload(GLuint texture) {
    activate(0);
    bindTexture(0, GL_TEXTURE_2D, texture);
}

void GlState::activate(unsigned unit) {
    if (changes(m_unit, unit))
        m_gl->ActiveTexture(GL_TEXTURE0 + unit);
}

void GlState::bindVertices(GLuint buffer) {
    if (changes(m_vertices, buffer))
        m_gl->BindBuffer(GL_ARRAY_BUFFER, buffer);
}

void GlState::bindIndices(GLuint buffer) {
    if (changes(m_indices, buffer))
        m_gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
}

void GlState::enableArrays(unsigned locations) {
    if (m_arrays == locations)
        return;
    const unsigned all = (1u << kArrays) - 1;
    const unsigned changed = m_arrays ? *m_arrays ^ locations : all;
    for (GLuint location = 0; location < kArrays; ++location)
        if ((changed >> location & 1u) != 0)
            (locations >> location & 1u) != 0 ? m_gl->EnableVertexAttribArray(location)
                                              : m_gl->DisableVertexAttribArray(location);
    m_arrays = locations;
}

bool GlState::changesPointers(GLuint buffer, unsigned layout) {
    return changes(m_layout, Of<unsigned>{buffer, layout});
}

void GlState::setPointer(GLuint location, const Pointer& pointer) {
    if (!changes(m_pointers[location], Of<Pointer>{m_vertices, pointer}))
        return;
    const auto offset = static_cast<std::uintptr_t>(pointer.offset); // In place of an address.
    m_gl->VertexAttribPointer(location, pointer.size, pointer.type,
                              pointer.type == GL_FLOAT ? GL_FALSE : GL_TRUE, pointer.stride,
                              reinterpret_cast<const void*>(offset)); // NOLINT(performance-no-int-to-ptr)
}

} // namespace franken
