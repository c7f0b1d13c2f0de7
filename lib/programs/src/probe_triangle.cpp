// SPDX-License-Identifier: MIT
#include "probe_triangle.h"

#include "franken/attribute_format.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace franken {
namespace {

struct Vertex {
    std::array<float, 3> position, normal{0, 0, 1};
    std::array<float, 4> tangent{1, 0, 0, 1};
    std::array<float, 2> uv;
    std::array<std::uint16_t, 4> color{65'535, 65'535, 65'535, 65'535};
    std::array<float, 4> joints{0, 3, 6, 9}, weights{0.25f, 0.25f, 0.25f, 0.25f};
};

/// By attribute location; both texture coordinates are the same.
constexpr std::array<std::size_t, kAttributeFormats.size()> kOffsets = {
    offsetof(Vertex, position), offsetof(Vertex, normal), offsetof(Vertex, tangent),
    offsetof(Vertex, uv),       offsetof(Vertex, uv),     offsetof(Vertex, color),
    offsetof(Vertex, joints),   offsetof(Vertex, weights)};

constexpr std::array<Vertex, 3> verticesOf(ProbeTriangle::Extent extent) {
    if (extent == ProbeTriangle::Extent::None)
        return {};
    return {{{.position = {-1, -1, 0}, .uv = {0, 0}},
             {.position = {3, -1, 0}, .uv = {2, 0}},
             {.position = {-1, 3, 0}, .uv = {0, 2}}}};
}

constexpr std::array<std::uint16_t, 3> kIndices = {0, 1, 2};

} // namespace

ProbeTriangle::ProbeTriangle(const Gl& gl, Extent extent)
    : m_gl(&gl), m_vertices(gl, generate(gl.GenBuffers)), m_indices(gl, generate(gl.GenBuffers)) {
    const std::array<Vertex, 3> vertices = verticesOf(extent);
    gl.BindBuffer(GL_ARRAY_BUFFER, m_vertices.name());
    gl.BufferData(GL_ARRAY_BUFFER, sizeof(vertices), vertices.data(), GL_STATIC_DRAW);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_indices.name());
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(kIndices), kIndices.data(), GL_STATIC_DRAW);
}

void ProbeTriangle::draw(GlState& state, unsigned attributes) const {
    state.bindIndices(m_indices.name());
    if (state.changesPointers(m_vertices.name(), attributes)) {
        state.bindVertices(m_vertices.name());
        for (std::size_t location = 0; location < kOffsets.size(); ++location)
            if ((attributes >> location & 1u) != 0)
                state.setPointer(static_cast<GLuint>(location),
                                 {kAttributeFormats[location].size, kAttributeFormats[location].type,
                                  sizeof(Vertex), static_cast<int>(kOffsets[location])});
    }
    m_gl->DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, nullptr);
}

} // namespace franken
