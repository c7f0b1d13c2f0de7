// SPDX-License-Identifier: MIT
#include "pbr.h"

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cstddef>

using namespace franken;

namespace {

Float3 toFloat3(const glm::vec3& v) { return {v.x, v.y, v.z}; }
Double3 toDouble3(const glm::vec3& v) { return {v.x, v.y, v.z}; }

template<typename Values, typename Matrix>
void copy(Values& values, const Matrix& matrix) {
    std::copy_n(glm::value_ptr(matrix), values.size(), values.begin());
}

/// Where the engine's vertices keep what the library's attributes are called, by their fixed locations.
struct VertexPart {
    const char* attribute;
    GLint size;
    std::size_t offset;
};
constexpr VertexPart kVertexParts[] = {{"aPosition", 3, offsetof(Vertex, position)},
                                       {"aNormal", 3, offsetof(Vertex, normal)},
                                       {"aTangent", 4, offsetof(Vertex, tangent)},
                                       {"aUv0", 2, offsetof(Vertex, uv)}};

} // namespace

Result<Pbr::Look> Pbr::lookOf(const Paint& paint) {
    Permutation wanted;
    wanted.baseColorTexture = paint.textured;
    wanted.normal = paint.textured ? Normal::Map : Normal::Vertex;
    wanted.ambient = Ambient::Color;
    wanted.suns = 1;
    wanted.punctualLights = 1;
    wanted.toneMap = ToneMap::Neutral;
    const Result<Canonical> canonical = canonicalise(wanted);
    if (!canonical)
        return canonical.error();
    const Result<ProgramHandle> program = m_cache.get(canonical->permutation);
    if (!program)
        return program.error();
    const MaterialFactors factors = {.baseColor = {paint.color.r, paint.color.g, paint.color.b, 1},
                                     .metallic = paint.metallic,
                                     .roughness = paint.roughness};
    Look look{*program, {}, {}};
    look.material.edit() = packMaterial(factors, wanted.brdf, 1);
    return look;
}

void Pbr::beginFrame(const World& world, float aspect) {
    m_viewProjection = glm::perspective(world.yfov, aspect, world.near, world.far) *
                       glm::lookAt(world.eye, world.lookAt, {0, 1, 0});
    m_frame.edit().cameraPosition = toFloat3(world.eye);
    LightsBlock& lights = m_lights.edit();
    lights.ambient = packAmbient({.kind = Ambient::Color, .color = toFloat3(world.ambient)}, 1);
    packSun(lights, 0, {.direction = toFloat3(world.sunDirection), .illuminance = world.sunLux}, 1);
    packPunctualLight(lights, 0,
                      {.position = toDouble3(world.lampPosition),
                       .color = toFloat3(world.lampColor),
                       .intensity = world.lampCandela},
                      toDouble3(world.eye), 1);
}

void Pbr::draw(const Thing& thing, Look& look, const GpuMesh& mesh) const {
    ObjectBlock& object = look.object.edit();
    copy(object.modelViewProjection, m_viewProjection * thing.place);
    copy(object.model, thing.place);
    copy(object.normalMatrix, glm::inverseTranspose(glm::mat3(thing.place)));

    m_engine.UseProgram(look.program->name());
    look.program->feed({m_frame.view(), m_lights.view(), look.material.view(), look.object.view()});
    bindVertices(look.program->attributes(), mesh);
    m_engine.DrawElements(GL_TRIANGLES, mesh.count, GL_UNSIGNED_SHORT, nullptr);
}

void Pbr::bindVertices(unsigned attributes, const GpuMesh& mesh) const {
    m_engine.BindBuffer(GL_ARRAY_BUFFER, mesh.vertices);
    m_engine.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.triangles);
    for (const VertexPart& part : kVertexParts) {
        const auto location = static_cast<GLuint>(attributeLocation(part.attribute));
        if ((attributes >> location & 1u) == 0) {
            m_engine.DisableVertexAttribArray(location);
            continue;
        }
        m_engine.EnableVertexAttribArray(location);
        m_engine.VertexAttribPointer(location, part.size, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                                     reinterpret_cast<const void*>(part.offset));
    }
}
