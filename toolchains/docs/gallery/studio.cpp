// SPDX-License-Identifier: MIT
#include "studio.h"

#include "blocks.h"

#include <algorithm>
#include <iterator>

namespace franken::gallery {
namespace {

/// Where vertices keep what an attribute is called.
struct VertexPart {
    const char* attribute;
    GLint size;
    std::size_t offset;
};
constexpr VertexPart kVertexParts[] = {
    {"aPosition", 3, offsetof(Vertex, position)}, {"aNormal", 3, offsetof(Vertex, normal)},
    {"aTangent", 4, offsetof(Vertex, tangent)},   {"aUv0", 2, offsetof(Vertex, uv0)},
    {"aUv1", 2, offsetof(Vertex, uv1)},           {"aColor", 4, offsetof(Vertex, color)},
    {"aJoints", 4, offsetof(Vertex, joints)},     {"aWeights", 4, offsetof(Vertex, weights)}};

void uploadTexels(const Gl& gl, GLenum target, const Image& image) {
    gl.TexImage2D(target, 0, GL_RGBA, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  image.rgba.data());
}

void setSampling(const Gl& gl, GLenum target, bool repeats) {
    gl.TexParameteri(target, GL_TEXTURE_WRAP_S, repeats ? GL_REPEAT : GL_CLAMP_TO_EDGE);
    gl.TexParameteri(target, GL_TEXTURE_WRAP_T, repeats ? GL_REPEAT : GL_CLAMP_TO_EDGE);
    gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, repeats ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    if (repeats)
        gl.GenerateMipmap(target);
}

GLuint upload(const Gl& gl, const Image& image, bool repeats) {
    GLuint name = 0;
    gl.GenTextures(1, &name);
    gl.BindTexture(GL_TEXTURE_2D, name);
    uploadTexels(gl, GL_TEXTURE_2D, image);
    setSampling(gl, GL_TEXTURE_2D, repeats);
    return name;
}

GLuint uploadCube(const Gl& gl, const SkyboxMap& cube) {
    GLuint name = 0;
    gl.GenTextures(1, &name);
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, name);
    for (GLenum face = 0; face < cube.images.size(); ++face)
        uploadTexels(gl, GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, cube.images[face]);
    setSampling(gl, GL_TEXTURE_CUBE_MAP, false);
    return name;
}

/// One triangle over the whole picture.
Mesh screen() {
    Mesh mesh;
    for (const glm::vec3& corner : {glm::vec3(-1, -1, 1), glm::vec3(3, -1, 1), glm::vec3(-1, 3, 1)})
        mesh.vertices.emplace_back().position = corner;
    mesh.indices = {0, 1, 2};
    return mesh;
}

Mesh meshFor(const Permutation& permutation, const Scenery& scenery) {
    switch (permutation.program) {
    case Program::Sky:
        return screen();
    case Program::Overlay:
        return square();
    case Program::Surface:
        break;
    }
    return sphere(scenery.open, permutation.influences);
}

/// Joints as programs read them: where a joint's three rows begin.
void toRows(Mesh& mesh) {
    for (Vertex& vertex : mesh.vertices)
        vertex.joints *= 3.0f;
}

} // namespace

Studio::Studio(const Gl& gl, GLuint framebuffer)
    : m_gl(gl),
      m_framebuffer(framebuffer),
      m_cache(gl),
      m_sky(bakeSky(sky(), {.sun = true, .skyboxSize = 64})) {
    for (const TextureRoleRow& row : textureRoles()) {
        GLuint& name = m_textures[static_cast<std::size_t>(row.role)];
        switch (row.role) {
        case TextureRole::Skybox:
            name = uploadCube(gl, m_sky.skybox);
            break;
        case TextureRole::Reflection:
            name = upload(gl, m_sky.reflection.atlas.image, row.repeats);
            break;
        case TextureRole::ReflectionLookup:
            name = upload(gl, m_sky.reflection.lookup, row.repeats);
            break;
        default:
            name = upload(gl, textureOf(row.role), row.repeats);
        }
    }
}

Result<Image> Studio::draw(const Permutation& permutation, const Scenery& scenery) {
    const Result<ProgramHandle> program = m_cache.get(permutation);
    if (!program)
        return program.error();
    clear(scenery);
    bindTextures(permutation);
    const auto set = [&](GLenum capability, bool on) {
        on ? m_gl.Enable(capability) : m_gl.Disable(capability);
    };
    const bool isSurface = permutation.program == Program::Surface;
    set(GL_DEPTH_TEST, isSurface);
    set(GL_CULL_FACE, isSurface && permutation.sides == Sides::Single);
    set(GL_BLEND, permutation.alpha == Alpha::Blend);
    m_gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    m_gl.UseProgram((*program)->name());
    feed(**program, permutation);
    Mesh mesh = meshFor(permutation, scenery);
    toRows(mesh);
    drawMesh(mesh, (*program)->attributes());
    Image image = readBack(scenery.coarse);
    if (const GLenum error = m_gl.GetError(); error != GL_NO_ERROR)
        return Error{"gallery.gl", toName(permutation), "GL error " + std::to_string(error),
                     "see what the program reads and the studio does not have"};
    return image;
}

void Studio::clear(const Scenery& scenery) const {
    constexpr int kStripes = 8;
    m_gl.BindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    m_gl.Viewport(0, 0, kSize, kSize);
    m_gl.Disable(GL_DITHER);
    m_gl.ClearColor(0.17f, 0.19f, 0.22f, 1);
    m_gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (!scenery.striped)
        return;
    m_gl.Enable(GL_SCISSOR_TEST);
    m_gl.ClearColor(0.85f, 0.83f, 0.78f, 1);
    for (int stripe = 0; stripe < kStripes; stripe += 2) {
        m_gl.Scissor(0, stripe * kSize / kStripes, kSize, kSize / kStripes);
        m_gl.Clear(GL_COLOR_BUFFER_BIT);
    }
    m_gl.Disable(GL_SCISSOR_TEST);
}

void Studio::bindTextures(const Permutation& permutation) const {
    for (const TextureRoleRow& row : textureRoles()) {
        if (!row.there(permutation))
            continue;
        m_gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(row.unit));
        m_gl.BindTexture(row.role == TextureRole::Skybox ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D,
                         m_textures[static_cast<std::size_t>(row.role)]);
    }
}

void Studio::feed(ShaderProgram& program, const Permutation& permutation) const {
    const Blocks blocks = blocksFor(permutation, m_sky);
    const auto give = [&](Block block, const auto& values) {
        program.feed(block, {reinterpret_cast<const float*>(&values), newSerial()});
    };
    give(Block::Frame, blocks.frame);
    give(Block::Lights, blocks.lights);
    give(Block::Material, blocks.material);
    give(Block::Object, blocks.object);
    give(Block::Skin, blocks.skin);
}

void Studio::drawMesh(const Mesh& mesh, unsigned attributes) const {
    for (const VertexPart& part : kVertexParts) {
        const auto location = static_cast<GLuint>(attributeLocation(part.attribute));
        if ((attributes >> location & 1u) == 0) {
            m_gl.DisableVertexAttribArray(location);
            continue;
        }
        m_gl.EnableVertexAttribArray(location);
        m_gl.VertexAttribPointer(location, part.size, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                                 reinterpret_cast<const char*>(mesh.vertices.data()) + part.offset);
    }
    m_gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.indices.size()), GL_UNSIGNED_SHORT,
                      mesh.indices.data());
}

Image Studio::readBack(bool coarse) const {
    constexpr auto kRow = 4 * static_cast<std::size_t>(kSize);
    Image image{"", kSize, kSize, std::vector<std::uint8_t>(kRow * kSize)};
    m_gl.ReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    for (std::size_t low = 0, high = kSize - 1; low < high; ++low, --high)
        std::swap_ranges(&image.rgba[kRow * low], &image.rgba[kRow * low] + kRow, &image.rgba[kRow * high]);
    if (coarse)
        for (std::uint8_t& value : image.rgba)
            value = static_cast<std::uint8_t>((value * 7 + 127) / 255 * 255 / 7);
    return image;
}

} // namespace franken::gallery
