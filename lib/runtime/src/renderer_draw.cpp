// SPDX-License-Identifier: MIT
#include "renderer_state.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <tuple>

namespace franken {
namespace {

Float3 toFloat3(const glm::dvec3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// Rounded to float only here.
template<typename Values, typename Matrix>
void round(Values& values, const Matrix& matrix) {
    std::transform(glm::value_ptr(matrix), glm::value_ptr(matrix) + values.size(), values.begin(),
                   [](double value) { return static_cast<float>(value); });
}

/// The inverse transpose up to a factor; a matrix that squashes to a plane has one as well.
glm::dmat3 cofactors(const glm::dmat3& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

ObjectBlock packObject(const Drawable& drawable, const glm::dmat4& viewProjection) {
    ObjectBlock block{};
    round(block.modelViewProjection, viewProjection * drawable.world);
    round(block.model, drawable.world);
    const double side = drawable.mirrored ? -1 : 1;
    round(block.normalMatrix, side * cofactors(glm::dmat3(drawable.world)));
    return block;
}

} // namespace

void Renderer::State::sortOpaque() {
    const auto order = [this](std::size_t index) {
        const Drawable& drawable = scene.drawables[index];
        return std::tuple(scene.materials[drawable.material].program->name(), drawable.material,
                          drawable.mesh);
    };
    std::sort(opaque.begin(), opaque.end(),
              [&](std::size_t a, std::size_t b) { return order(a) < order(b); });
}

void Renderer::State::updateBlocks(const Viewpoint& viewpoint, const DrawTarget& target) {
    FrameBlock& values = frame.edit();
    values.cameraPosition = toFloat3(viewpoint.eye);
    round(values.clipToSky, viewpoint.clipToSky);
    values.skyRange = skyRange * lighting.exposure;
    values.specularRange = mirror.range * lighting.exposure;
    values.dither = packDither(target.bits);
    lights.edit() = packLighting(lighting, toFloat3(viewpoint.eye));
    for (Drawable& drawable : scene.drawables)
        drawable.block.edit() = packObject(drawable, viewpoint.viewProjection);
}

void Renderer::State::beginFrame(const DrawTarget& target) {
    gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    gl.Viewport(0, 0, target.width, target.height);
    gl.Disable(GL_SCISSOR_TEST);
    gl.Disable(GL_STENCIL_TEST);
    gl.Disable(GL_DITHER);
    gl.Disable(GL_BLEND);
    gl.Disable(GL_POLYGON_OFFSET_FILL);
    gl.Disable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    gl.Disable(GL_SAMPLE_COVERAGE);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_LEQUAL);
    gl.DepthMask(GL_TRUE);
    gl.DepthRangef(0, 1);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.CullFace(GL_BACK);
    gl.BlendEquation(GL_FUNC_ADD);
    gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    constexpr GLuint kAttributes = 8;
    for (GLuint location = 0; location < kAttributes; ++location)
        gl.DisableVertexAttribArray(location);
    enabledAttributes = 0;
    bindMirror(gl, mirror);
    gl.ClearColor(target.background[0], target.background[1], target.background[2], 1);
    gl.ClearDepthf(1);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void Renderer::State::use(ShaderProgram& program, const BlockViews& blocks) {
    gl.UseProgram(program.name());
    program.feed(blocks);
    for (GLuint location = 0, changed = enabledAttributes ^ program.attributes(); changed != 0;
         ++location, changed >>= 1)
        if ((changed & 1u) != 0)
            (program.attributes() >> location & 1u) != 0 ? gl.EnableVertexAttribArray(location)
                                                         : gl.DisableVertexAttribArray(location);
    enabledAttributes = program.attributes();
}

void Renderer::State::drawOne(const Drawable& drawable) {
    const GpuMaterial& material = scene.materials[drawable.material];
    use(*material.program, {frame.view(), lights.view(), material.block.view(), drawable.block.view()});
    for (const Sampler& sampler : material.program->interface().samplers) {
        if (static_cast<std::size_t>(sampler.unit) >= kMaterialUnits)
            continue; // The sky's, bound for the whole frame.
        gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(sampler.unit));
        gl.BindTexture(GL_TEXTURE_2D, material.textures[static_cast<std::size_t>(sampler.unit)]);
    }
    drawable.doubleSided ? gl.Disable(GL_CULL_FACE) : gl.Enable(GL_CULL_FACE);
    gl.FrontFace(drawable.mirrored ? GL_CW : GL_CCW);
    scene.meshes[drawable.mesh].draw(gl, material.program->attributes(), material.plan.uvSets);
}

void Renderer::State::drawBlended(const Viewpoint& viewpoint) {
    const auto depth = [&](std::size_t index) {
        return glm::dot(scene.drawables[index].center - viewpoint.eye, viewpoint.forward);
    };
    std::stable_sort(blended.begin(), blended.end(),
                     [&](std::size_t a, std::size_t b) { return depth(a) > depth(b); });
    gl.Enable(GL_BLEND);
    gl.DepthMask(GL_FALSE);
    for (const std::size_t index : blended)
        drawOne(scene.drawables[index]);
    gl.DepthMask(GL_TRUE);
}

} // namespace franken
