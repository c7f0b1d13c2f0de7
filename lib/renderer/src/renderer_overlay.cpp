// SPDX-License-Identifier: MIT
#include "franken/generator/interface.h"
#include "renderer_state.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace franken {
namespace {

struct Vertex {
    std::array<float, 3> position;
    std::array<float, 2> uv;
    std::array<std::uint16_t, 4> color;
};

constexpr std::size_t kQuadVertices = 4, kQuadIndices = 6;
constexpr std::size_t kMaxQuads = GpuMesh::kMaxShortVertices / kQuadVertices;

const void* at(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes); // NOLINT(performance-no-int-to-ptr)
}

void addVertices(const OverlayQuad& quad, std::vector<Vertex>& vertices) {
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

Error noPicture() {
    return {
        "renderer.picture", "", "there is no such picture",
        "use what addPicture() returned, until removePicture(), and give a source that outlives a context"};
}

} // namespace

ProgramUse overlayUse(const Look& look) {
    Permutation permutation;
    permutation.program = Program::Overlay;
    permutation.baseColorTexture = true;
    permutation.vertexColor = true;
    permutation.alpha = Alpha::Blend;
    permutation.output = look.srgbTarget ? Output::Linear : look.output;
    permutation.target = look.target;
    const Result<Canonical> canonical = canonicalise(permutation);
    assert(canonical && "nothing here contradicts itself");
    DrawState state;
    state.wraps[0] = DrawState::kClamped;
    state.blend = true;
    return {canonical->permutation, state};
}

Result<PictureId> Renderer::addPicture(const Image& image, PictureSource source) {
    State& state = *m_state;
    // Not drawn yet: older than all that this frame drew.
    Picture picture{PictureId{++state.lastId}, std::move(source), state.frameBegan - 1};
    if (Result<void> uploaded = state.uploadPicture(picture, image); !uploaded)
        return uploaded.error();
    state.pictures.push_back(std::move(picture));
    return state.pictures.back().id;
}

void Renderer::removePicture(PictureId id) {
    std::erase_if(m_state->pictures, [&](const Picture& picture) { return picture.id == id; });
    m_state->glState.invalidate();
}

Result<void> Renderer::State::uploadPicture(Picture& picture, const Image& image) {
    if (lost)
        return noContext();
    glState.invalidate();
    Result<GpuTexture> uploaded = uploadTexture(device(), image, kPlainSampling, TextureContents::Color);
    if (!uploaded)
        return uploaded.error();
    if (Result<void> checked = checkMemory(gl); !checked)
        return checked;
    picture.texture = *std::move(uploaded);
    return {};
}

Picture* Renderer::State::find(PictureId id) {
    const auto found = std::find_if(pictures.begin(), pictures.end(),
                                    [&](const Picture& picture) { return picture.id == id; });
    return found == pictures.end() ? nullptr : &*found;
}

Result<void> Renderer::State::makeResident(Picture& picture) {
    if (picture.texture.texture)
        return {};
    const Result<Image> image = picture.source();
    return image ? uploadPicture(picture, *image) : image.error();
}

// All are marked before the first is uploaded: none makes room for another.
Result<void> Renderer::State::prepareOverlay(std::span<const OverlayQuad> quads) {
    std::vector<Picture*> needed;
    for (const OverlayQuad& quad : quads) {
        Picture* const picture =
            !needed.empty() && needed.back()->id == quad.picture ? needed.back() : find(quad.picture);
        if (picture == nullptr || !(picture->texture.texture || picture->source))
            return noPicture();
        picture->lastDrawn = clock;
        if (needed.empty() || needed.back() != picture)
            needed.push_back(picture);
    }
    for (Picture* picture : needed)
        if (Result<void> made = makeResident(*picture); !made)
            return made;
    return {};
}

void Renderer::State::makeOverlayBuffers() {
    if (overlayVertices)
        return;
    overlayVertices = GlBuffer(gl, generate(gl.GenBuffers));
    overlayIndices = GlBuffer(gl, generate(gl.GenBuffers));
    const std::vector<std::uint16_t> indices = quadIndices();
    glState.bindIndices(overlayIndices.name());
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint16_t)),
                  indices.data(), GL_STATIC_DRAW);
}

void Renderer::State::beginOverlay(ShaderProgram& program, const DrawTarget& target) {
    gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    gl.Viewport(0, 0, target.width, target.height);
    glState.begin();
    glState.setBlending(true);
    glState.setDepthTest(true); // As in all other draws: vc4 compiles a program again without it.
    glState.setDepthWrites(false);
    glState.setDepthRange(0, 0);
    glState.setCulling(false);
    const auto width = static_cast<float>(target.width), height = static_cast<float>(target.height);
    ObjectBlock object{};
    object.overlay = {2 / width, 0, 0, 0, -2 / height, 0, -1, 1, 1};
    overlayObject.set(object);
    MaterialBlock material{};
    material.baseColor = {1, 1, 1, 1};
    overlayMaterial.set(material);
    use(program, {frame.view(), lights.view(), overlayMaterial.view(), overlayObject.view()});
}

void Renderer::State::drawQuads(std::span<const OverlayQuad> quads, unsigned attributes) {
    std::vector<Vertex> vertices;
    for (const OverlayQuad& quad : quads)
        addVertices(quad, vertices);
    glState.bindVertices(overlayVertices.name());
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)), vertices.data(),
                  GL_STREAM_DRAW);
    if (glState.changesPointers(overlayVertices.name(), attributes)) {
        const auto set = [&](const char* name, GLint size, GLenum type, std::size_t offset) {
            glState.setPointer(static_cast<GLuint>(attributeLocation(name)),
                               {size, type, static_cast<GLsizei>(sizeof(Vertex)), static_cast<int>(offset)});
        };
        set("aPosition", 3, GL_FLOAT, offsetof(Vertex, position));
        set("aUv0", 2, GL_FLOAT, offsetof(Vertex, uv));
        set("aColor", 4, GL_UNSIGNED_SHORT, offsetof(Vertex, color));
    }
    glState.bindIndices(overlayIndices.name());
    for (std::size_t first = 0, next = 0; first < quads.size(); first = next) {
        while (next < quads.size() && quads[next].picture == quads[first].picture)
            ++next;
        glState.bindTexture(0, GL_TEXTURE_2D, find(quads[first].picture)->texture.texture.name());
        gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(kQuadIndices * (next - first)), GL_UNSIGNED_SHORT,
                        at(kQuadIndices * first * sizeof(std::uint16_t)));
    }
}

Result<void> Renderer::drawOverlay(std::span<const OverlayQuad> quads, const DrawTarget& target) {
    State& state = *m_state;
    if (state.lost)
        return noContext();
    if (quads.empty())
        return {};
    if (Result<void> prepared = state.prepareOverlay(quads); !prepared)
        return prepared;
    if (!state.overlayProgram) {
        // In a target of the supply's own: this one's picture is to stay.
        const Result<ProgramSupply::Supplied> supplied = state.programs.get(overlayUse(state.look), nullptr);
        state.glState.invalidate();
        if (!supplied)
            return supplied.error();
        state.overlayProgram = supplied->program;
    }
    state.makeOverlayBuffers();
    state.beginOverlay(*state.overlayProgram, target);
    for (std::size_t first = 0; first < quads.size(); first += kMaxQuads)
        state.drawQuads(quads.subspan(first, std::min(kMaxQuads, quads.size() - first)),
                        state.overlayProgram->attributes());
    return {};
}

} // namespace franken
