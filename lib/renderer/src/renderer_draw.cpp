// SPDX-License-Identifier: MIT
#include "object_block.h"
#include "renderer_state.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace franken {

void Renderer::State::sortOpaque() {
    const auto order = [](const Object& object) {
        const ProgramHandle& program = object.material->program;
        const bool samples = program && !program->interface().samplers.empty();
        return std::tuple(samples, program ? program->name() : 0, object.order);
    };
    std::sort(opaque.begin(), opaque.end(),
              [&](const Object& a, const Object& b) { return order(a) < order(b); });
    seenFrom.reset();
}

void Renderer::State::updateBlocks(const Viewpoint& viewpoint, const DrawTarget& target) {
    FrameBlock values{};
    values.cameraPosition = {0, 0, 0}; // Because objects are placed as seen from it.
    roundTo(values.clipToSky, viewpoint.clipToSky);
    values.skyRange = skyRange * lighting.exposure;
    values.reflectionScale = std::sqrt(mirror->range * lighting.exposure);
    values.dither = packDither(target.bits);
    frame.set(values);
    lights.set(packLighting(lighting, viewpoint.eye));
    if (seenFrom != viewpoint)
        findVisible(viewpoint);
}

bool Renderer::State::place(Object& object, const Frustum& frustum, const Viewpoint& viewpoint) {
    object.visible = object.material->program && frustum.mayShow(object.bounds);
    if (object.visible)
        projectObject(object.block, object.position, viewpoint);
    return object.visible;
}

void Renderer::State::findVisible(const Viewpoint& viewpoint) {
    const Frustum frustum(viewpoint.viewProjection);
    drawn = 0;
    std::uint64_t serial = newSerials(opaque.size() + blended.size());
    for (Object& object : opaque)
        if (place(object, frustum, viewpoint)) {
            object.serial = serial++;
            ++drawn;
        }
    backToFront.clear();
    for (Object& object : blended)
        if (place(object, frustum, viewpoint)) {
            object.serial = serial++;
            backToFront.push_back(&object);
        }
    drawn += backToFront.size();
    const auto depth = [&](const Object* object) {
        return glm::dot(object->bounds.center - viewpoint.eye, viewpoint.forward);
    };
    std::stable_sort(backToFront.begin(), backToFront.end(),
                     [&](const Object* a, const Object* b) { return depth(a) > depth(b); });
    seenFrom = viewpoint;
}

void Renderer::State::beginFrame(const DrawTarget& target) {
    gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    gl.Viewport(0, 0, target.width, target.height);
    glState.begin();
    glState.setBlending(false);
    glState.setDepthTest(true);
    glState.setDepthWrites(true);
    glState.setDepthRange(0, 1);
    bindMirror(glState, *mirror);
    glState.setClearColor(target.background);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    boundMaterial = nullptr;
}

void Renderer::State::use(ShaderProgram& program, const BlockViews& blocks) {
    programs.prepareDraw(glState, program);
    glState.useProgram(program.name());
    program.feed(blocks);
    glState.enableArrays(program.attributes());
}

void Renderer::State::bind(const GpuMaterial& material) {
    use(*material.program, {frame.view(), lights.view(), material.block.view(), {}});
    for (const Sampler& sampler : material.program->interface().samplers)
        if (const auto unit = static_cast<std::size_t>(sampler.unit); unit < kMaterialUnits)
            glState.bindTexture(static_cast<unsigned>(unit), GL_TEXTURE_2D, material.textures[unit]);
    boundMaterial = &material;
}

void Renderer::State::drawOne(const Object& object) {
    const GpuMaterial& material = *object.material;
    if (boundMaterial != &material)
        bind(material);
    ShaderProgram& program = *material.program;
    program.feed(Block::Object, {reinterpret_cast<const float*>(&object.block), object.serial});
    glState.setCulling(!object.doubleSided || object.material->state.blend);
    glState.setFrontFace(object.mirrored ? GL_CW : GL_CCW);
    object.mesh->draw(gl, glState, program.attributes(), material.plan.uvSets);
}

// Through a transparent surface its other side is seen, which therefore comes first.
void Renderer::State::drawSides(const Object& object) {
    if (!object.doubleSided)
        return drawOne(object);
    for (const GLenum culled : {GL_FRONT, GL_BACK}) {
        glState.setCulledFace(culled);
        drawOne(object);
    }
}

void Renderer::State::drawOpaque() {
    for (const Object& object : opaque)
        if (object.visible)
            drawOne(object);
}

void Renderer::State::drawBlended() {
    if (backToFront.empty())
        return;
    glState.setBlending(true);
    glState.setDepthWrites(false);
    boundMaterial = nullptr; // The sky's program may be in use.
    for (const Object* object : backToFront)
        drawSides(*object);
}

} // namespace franken
