// SPDX-License-Identifier: MIT
#include "object_block.h"
#include "renderer_state.h"

#include <algorithm>
#include <tuple>

namespace franken {

void Renderer::State::sortOpaque() {
    const auto order = [](const Placed& placed) {
        const ProgramHandle& program = placed.material().program;
        return std::tuple(program ? program->name() : 0, placed.scene->number, placed.drawable->material,
                          placed.drawable->mesh);
    };
    std::stable_sort(opaque.begin(), opaque.end(),
                     [&](const Placed& a, const Placed& b) { return order(a) < order(b); });
    seenFrom.reset();
}

void Renderer::State::updateBlocks(const Viewpoint& viewpoint, const DrawTarget& target) {
    FrameBlock values{};
    values.cameraPosition = toFloat3(viewpoint.eye);
    roundTo(values.clipToSky, viewpoint.clipToSky);
    values.skyRange = skyRange * lighting.exposure;
    values.specularRange = mirror->range * lighting.exposure;
    values.dither = packDither(target.bits);
    frame.set(values);
    lights.set(packLighting(lighting, toFloat3(viewpoint.eye)));
    if (seenFrom != viewpoint.viewProjection)
        findVisible(viewpoint);
}

void Renderer::State::findVisible(const Viewpoint& viewpoint) {
    const Frustum frustum(viewpoint.viewProjection);
    const auto keep = [&](const std::vector<Placed>& all, std::vector<Placed>& visible) {
        visible.clear();
        for (const Placed& placed : all)
            if (placed.material().program && frustum.mayShow(placed.drawable->bounds)) {
                projectObject(placed.drawable->block.edit(), viewpoint.viewProjection,
                              placed.drawable->world);
                visible.push_back(placed);
            }
    };
    keep(opaque, visibleOpaque);
    keep(blended, visibleBlended);
    const auto depth = [&](const Placed& placed) {
        return glm::dot(placed.drawable->bounds.center - viewpoint.eye, viewpoint.forward);
    };
    std::stable_sort(visibleBlended.begin(), visibleBlended.end(),
                     [&](const Placed& a, const Placed& b) { return depth(a) > depth(b); });
    seenFrom = viewpoint.viewProjection;
}

void Renderer::State::beginFrame(const DrawTarget& target) {
    gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    gl.Viewport(0, 0, target.width, target.height);
    glState.begin();
    glState.setBlending(false);
    glState.setDepthTest(true);
    glState.setDepthWrites(true);
    bindMirror(glState, *mirror);
    glState.setClearColor(target.background);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    boundMaterial = nullptr;
}

void Renderer::State::use(ShaderProgram& program, const BlockViews& blocks) {
    glState.useProgram(program.name());
    program.feed(blocks);
    glState.enableArrays(program.attributes());
}

void Renderer::State::drawOne(const Placed& placed) {
    const Drawable& drawable = *placed.drawable;
    const GpuMaterial& material = placed.material();
    use(*material.program, {frame.view(), lights.view(), material.block.view(), drawable.block.view()});
    if (boundMaterial != &material) {
        for (const Sampler& sampler : material.program->interface().samplers)
            if (const auto unit = static_cast<std::size_t>(sampler.unit); unit < kMaterialUnits)
                glState.bindTexture(static_cast<unsigned>(unit), GL_TEXTURE_2D, material.textures[unit]);
        boundMaterial = &material;
    }
    glState.setCulling(!drawable.doubleSided);
    glState.setFrontFace(drawable.mirrored ? GL_CW : GL_CCW);
    placed.scene->meshes[drawable.mesh].draw(gl, glState, material.program->attributes(),
                                             material.plan.uvSets);
}

void Renderer::State::drawBlended() {
    if (visibleBlended.empty())
        return;
    glState.setBlending(true);
    glState.setDepthWrites(false);
    for (const Placed& placed : visibleBlended)
        drawOne(placed);
}

} // namespace franken
