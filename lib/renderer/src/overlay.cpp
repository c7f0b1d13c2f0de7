// SPDX-License-Identifier: MIT
#include "overlay.h"

#include "checked_upload.h"
#include "franken/generator/interface.h"
#include "gpu_buffer.h"
#include "gpu_mesh.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace franken {
namespace {

constexpr std::size_t kQuadVertices = 4, kQuadIndices = 6;
constexpr std::size_t kMaxQuads = GpuMesh::kMaxShortVertices / kQuadVertices;

const void* at(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes); // NOLINT(performance-no-int-to-ptr)
}

void addVertices(const OverlayQuad& quad, std::vector<OverlayVertex>& vertices) {
    std::array<std::uint16_t, 4> color{};
    std::transform(quad.color.begin(), quad.color.end(), color.begin(), [](float value) {
        return static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 65'535));
    });
    for (const auto& [right, down] : {std::pair(0.0f, 0.0f), {1.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}})
        vertices.push_back(
            {{quad.place.x + right * quad.place.width, quad.place.y + down * quad.place.height, 0},
             {quad.part.x + right * quad.part.width, quad.part.y + down * quad.part.height},
             color});
}

/// For any number of quads one after the other.
std::vector<std::uint16_t> quadIndices() {
    std::vector<std::uint16_t> indices;
    for (std::size_t quad = 0; quad < kMaxQuads; ++quad)
        for (const std::size_t corner : {0, 2, 1, 0, 3, 2})
            indices.push_back(static_cast<std::uint16_t>(quad * kQuadVertices + corner));
    return indices;
}

/// From the pixels that the viewer of a panel sees, right and down from his upper left corner.
Float9 pixelsToClip(const TargetArea& area, Rotation rotation) {
    float width = static_cast<float>(area.width), height = static_cast<float>(area.height);
    if (swapsAxes(rotation))
        std::swap(width, height);
    const std::array<float, 16> turn = clipRotation(rotation);
    const auto turned = [&](float x, float y) {
        return std::array{turn[0] * x + turn[4] * y, turn[1] * x + turn[5] * y};
    };
    const auto right = turned(2 / width, 0), down = turned(0, -2 / height), corner = turned(-1, 1);
    return {right[0], right[1], 0, down[0], down[1], 0, corner[0], corner[1], 1};
}

} // namespace

Result<ProgramUse> overlayUse(const Look& look) {
    Permutation permutation;
    permutation.program = Program::Overlay;
    permutation.baseColorTexture = true;
    permutation.vertexColor = true;
    permutation.alpha = Alpha::Blend;
    permutation.output = look.srgbTarget ? Output::Linear : look.output;
    permutation.target = look.target;
    permutation.precision = look.precision;
    const Result<Canonical> canonical = canonicalise(permutation);
    if (!canonical)
        return canonical.error();
    DrawState state;
    state.wraps[0] = DrawState::kClamped;
    state.blend = true;
    return ProgramUse{canonical->permutation, state};
}

// The buffers are made together with the program, when the first overlay is drawn.
Result<void> Overlay::prepare(const Look& look) {
    if (!m_program) {
        // In a target of the manager's own: this one's picture is to stay.
        const Result<ProgramUse> use = overlayUse(look);
        if (!use)
            return use.error();
        const Result<ProgramManager::Supplied> supplied = m_programs.get(*use, nullptr);
        m_device.state.invalidate();
        if (!supplied)
            return supplied.error();
        m_program = supplied->program;
    }
    if (m_vertices)
        return {};
    const std::vector<std::uint16_t> list = quadIndices();
    Result<GlBuffer> indices = checkedUpload(m_device, [&] {
        return uploadBuffer(m_device.gl, GL_ELEMENT_ARRAY_BUFFER, std::as_bytes(std::span(list)));
    });
    if (!indices)
        return indices.error();
    Result<GlBuffer> vertices =
        checkedUpload(m_device, [&] { return uploadBuffer(m_device.gl, GL_ARRAY_BUFFER, {}); });
    if (!vertices)
        return vertices.error();
    m_indices = *std::move(indices);
    m_vertices = *std::move(vertices);
    return {};
}

void Overlay::begin(const DrawTarget& target) {
    GlState& state = m_device.state;
    m_device.begin(target);
    state.setBlending(true);
    state.setDepthTest(true); // As in all other draws: vc4 compiles a program again without it.
    state.setDepthWrites(false);
    state.setDepthRange(0, 0);
    state.setCulling(false);
    ObjectBlock object{};
    object.overlay = pixelsToClip(areaOf(target), target.rotation);
    m_object.set(object);
    MaterialBlock material{};
    material.baseColor = {1, 1, 1, 1};
    m_material.set(material);
    m_programs.prepareDraw(state, *m_program);
    state.useProgram(m_program->name());
    m_program->feed(BlockViews{BlockView{}, BlockView{}, m_material.view(), m_object.view()});
    state.enableArrays(m_program->attributes());
}

void Overlay::drawQuads(std::span<const OverlayQuad> quads, const Pictures& pictures) {
    GlState& state = m_device.state;
    m_drawn.clear();
    for (const OverlayQuad& quad : quads)
        addVertices(quad, m_drawn);
    state.bindVertices(m_vertices.name());
    m_device.gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(m_drawn.size() * sizeof(OverlayVertex)),
                           m_drawn.data(), GL_STREAM_DRAW);
    if (state.changesPointers(m_vertices.name(), m_program->attributes())) {
        const auto set = [&](const char* name, GLint size, GLenum type, std::size_t offset) {
            state.setPointer(
                static_cast<GLuint>(attributeLocation(name)),
                {size, type, static_cast<GLsizei>(sizeof(OverlayVertex)), static_cast<int>(offset)});
        };
        set("aPosition", 3, GL_FLOAT, offsetof(OverlayVertex, position));
        set("aUv0", 2, GL_FLOAT, offsetof(OverlayVertex, uv));
        set("aColor", 4, GL_UNSIGNED_SHORT, offsetof(OverlayVertex, color));
    }
    state.bindIndices(m_indices.name());
    for (std::size_t first = 0, next = 0; first < quads.size(); first = next) {
        while (next < quads.size() && quads[next].picture == quads[first].picture)
            ++next;
        state.bindTexture(0, GL_TEXTURE_2D, pictures.textureOf(quads[first].picture));
        m_device.gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(kQuadIndices * (next - first)),
                                 GL_UNSIGNED_SHORT, at(kQuadIndices * first * sizeof(std::uint16_t)));
    }
}

Result<void> Overlay::draw(std::span<const OverlayQuad> quads, const Pictures& pictures, const Look& look,
                           const DrawTarget& target) {
    if (Result<void> prepared = prepare(look); !prepared)
        return prepared;
    begin(target);
    for (std::size_t first = 0; first < quads.size(); first += kMaxQuads)
        drawQuads(quads.subspan(first, std::min(kMaxQuads, quads.size() - first)), pictures);
    return {};
}

void Overlay::lost() {
    m_vertices = {};
    m_indices = {};
    m_program.reset();
}

} // namespace franken
