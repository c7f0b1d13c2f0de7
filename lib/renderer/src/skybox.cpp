// SPDX-License-Identifier: MIT
#include "skybox.h"

#include "checked_upload.h"
#include "checks.h"
#include "franken/generator/texture_role.h"
#include "franken/guard.h"
#include "gpu_buffer.h"

#include <array>
#include <span>

namespace franken {

Result<void> Skybox::set(const SkyboxMap* cube, SkyboxSource source) {
    lost();
    m_device.state.invalidate();
    m_source = std::move(source);
    return cube == nullptr ? Result<void>() : upload(*cube);
}

Result<void> Skybox::upload(const SkyboxMap& cube) {
    if (Result<void> checked = checkRange(cube.range); !checked)
        return checked;
    Result<GpuTexture> texture = checkedUpload(m_device, [&] { return uploadCube(m_device, cube); });
    if (!texture)
        return texture.error();
    constexpr std::array<float, 9> kTriangle = {-1, -1, 1, 3, -1, 1, -1, 3, 1};
    Result<GlBuffer> triangle = checkedUpload(m_device, [&] {
        return uploadBuffer(m_device.gl, GL_ARRAY_BUFFER, std::as_bytes(std::span(kTriangle)));
    });
    if (!triangle)
        return triangle.error();
    m_texture = *std::move(texture);
    m_triangle = *std::move(triangle);
    m_range = cube.range;
    return {};
}

void Skybox::draw(GlState& state) const {
    state.bindTexture(static_cast<unsigned>(rowOf(TextureRole::Skybox).unit), GL_TEXTURE_CUBE_MAP,
                      m_texture.texture.name());
    if (state.changesPointers(m_triangle.name(), 0)) {
        state.bindVertices(m_triangle.name());
        state.setPointer(0, {3, GL_FLOAT, 0, 0});
    }
    state.setCulling(false);
    m_device.gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

void Skybox::lost() {
    m_texture = {};
    m_triangle = {};
}

Result<void> Skybox::restore() {
    if (!m_source)
        return {};
    const Result<SkyboxMap> cube = guarded("the source of the skybox", m_source);
    return cube ? upload(*cube) : cube.error();
}

} // namespace franken
