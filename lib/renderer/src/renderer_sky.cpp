// SPDX-License-Identifier: MIT
#include "franken/generator/interface.h"
#include "renderer_state.h"

namespace franken {

Result<void> Renderer::setBackdrop(const SkyCube* cube, SkySource source) {
    State& state = *m_state;
    state.resolved = false;
    state.glState.invalidate();
    state.sky = {};
    state.skyMemory = {};
    state.skySource = std::move(source);
    return cube == nullptr ? Result<void>() : state.uploadBackdrop(*cube);
}

Result<void> Renderer::State::uploadBackdrop(const SkyCube& cube) {
    const TextureSize face = {cube.size, cube.size};
    Result<MemoryLease> lease =
        memory.reserve(MemoryUse::Textures, cube.images.size() * textureBytes(face, false));
    if (!lease)
        return lease.error();
    skyMemory = *std::move(lease);
    skyRange = cube.range;
    sky = uploadCube(gl, cube);
    constexpr float kTriangle[] = {-1, -1, 1, 3, -1, 1, -1, 3, 1};
    skyTriangle = GlBuffer(gl, generate(gl.GenBuffers));
    gl.BindBuffer(GL_ARRAY_BUFFER, skyTriangle.name());
    gl.BufferData(GL_ARRAY_BUFFER, sizeof(kTriangle), kTriangle, GL_STATIC_DRAW);
    return checkMemory(gl);
}

Result<void> Renderer::setMirror(const SkyMirror* mirror, MirrorSource source) {
    State& state = *m_state;
    state.glState.invalidate();
    state.mirror.emplace(state.gl);
    state.mirrorSource = std::move(source);
    return mirror == nullptr ? Result<void>() : state.uploadMirror(*mirror);
}

Result<void> Renderer::State::uploadMirror(const SkyMirror& source) {
    Result<GpuMirror> uploaded = franken::uploadMirror(device(), source);
    if (!uploaded)
        return uploaded.error();
    mirror = *std::move(uploaded);
    return checkMemory(gl);
}

void Renderer::State::drawBackdrop() {
    use(*skyProgram, {frame.view(), lights.view(), {}, {}});
    glState.bindTexture(static_cast<unsigned>(samplerUnit("uSkyTexture")), GL_TEXTURE_CUBE_MAP, sky.name());
    if (glState.changesPointers(skyTriangle.name(), 0)) {
        glState.bindVertices(skyTriangle.name());
        glState.setPointer(0, {3, GL_FLOAT, 0, 0});
    }
    glState.setCulling(false);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace franken
