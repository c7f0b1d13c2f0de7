// SPDX-License-Identifier: MIT
#include "renderer_state.h"

namespace franken {
namespace {

constexpr unsigned kSkyUnit = 6;

} // namespace

Result<void> Renderer::setBackdrop(const SkyCube* cube) {
    State& state = *m_state;
    state.resolved = false;
    state.sky = {};
    return cube == nullptr ? Result<void>() : state.uploadBackdrop(*cube);
}

Result<void> Renderer::State::uploadBackdrop(const SkyCube& cube) {
    skyRange = cube.range;
    sky = uploadCube(gl, cube);
    constexpr float kTriangle[] = {-1, -1, 1, 3, -1, 1, -1, 3, 1};
    skyTriangle = GlBuffer(gl, generate(gl.GenBuffers));
    gl.BindBuffer(GL_ARRAY_BUFFER, skyTriangle.name());
    gl.BufferData(GL_ARRAY_BUFFER, sizeof(kTriangle), kTriangle, GL_STATIC_DRAW);
    return checkMemory(gl);
}

Result<void> Renderer::setMirror(const SkyMirror* mirror) {
    State& state = *m_state;
    state.mirror = GpuMirror(state.gl);
    if (mirror == nullptr)
        return {};
    Result<GpuMirror> uploaded = uploadMirror(state.gl, *mirror, state.capabilities);
    if (!uploaded)
        return uploaded.error();
    state.mirror = *std::move(uploaded);
    return checkMemory(state.gl);
}

void Renderer::State::drawBackdrop() {
    use(*skyProgram, {frame.view(), lights.view(), {}, {}});
    gl.ActiveTexture(GL_TEXTURE0 + kSkyUnit);
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, sky.name());
    gl.BindBuffer(GL_ARRAY_BUFFER, skyTriangle.name());
    gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl.Disable(GL_CULL_FACE);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace franken
