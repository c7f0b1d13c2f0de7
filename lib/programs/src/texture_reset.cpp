// SPDX-License-Identifier: MIT
#include "texture_reset.h"

#include "franken/gl_sampling.h"

#include <array>
#include <cstdint>

namespace franken {
namespace {

GlTexture whiteTexel(const Gl& gl) {
    constexpr std::array<std::uint8_t, 4> kWhite = {255, 255, 255, 255};
    GlTexture texture(gl, generate(gl.GenTextures));
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, texture.name());
    setSampling(gl, GL_TEXTURE_2D, Wrap::ClampToEdge, Wrap::ClampToEdge, Filter::Linear, Filter::Linear);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, kWhite.data());
    return texture;
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
    m_triangle.emplace(*m_gl, ProbeTriangle::Extent::None);
    m_texture = whiteTexel(*m_gl);
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
    m_triangle->draw(state, m_program->attributes());
    m_done = true;
}

} // namespace franken
