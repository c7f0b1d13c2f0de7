// SPDX-License-Identifier: MIT
#include "texture_reset.h"

#include "franken/draw_state.h"

namespace franken {
namespace {

Primitive triangleWithoutArea() {
    Primitive triangle;
    triangle.positions.assign(3, glm::vec3(0));
    triangle.uv[0].assign(3, glm::vec2(0));
    triangle.indices = {0, 1, 2};
    return triangle;
}

} // namespace

Permutation resetPermutation() {
    return {.baseColorTexture = true,
            .shading = Shading::Unlit,
            .decode = Decode::None,
            .output = Output::Linear};
}

void TextureReset::setProgram(ProgramHandle program) {
    m_program = std::move(program);
    m_triangle = *GpuMesh::make({*m_gl, Capabilities{}, m_memory, Log{}}, triangleWithoutArea());
    m_texture = uploadTexel(*m_gl, {255, 255, 255, 255});
    m_done = false;
}

void TextureReset::prepareFor(GlState& state, const ShaderProgram& next) {
    const bool samples = !next.interface().samplers.empty();
    if (samples || m_done || !m_program) {
        m_done = m_done && !samples;
        return;
    }
    state.useProgram(m_program->name());
    state.enableArrays(m_program->attributes());
    state.bindTexture(0, GL_TEXTURE_2D, m_texture.name());
    m_triangle->draw(*m_gl, state, m_program->attributes(), {0, 1});
    m_done = true;
}

} // namespace franken
