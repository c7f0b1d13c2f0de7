// SPDX-License-Identifier: MIT
#pragma once

#include "franken/renderer.h"
#include "gl_owner.h"
#include "gpu_texture.h"

namespace franken {

/// The sky that is drawn behind the scene, or none.
class Skybox final : public GlOwner {
public:
    explicit Skybox(Device& device) : m_device(device) {}

    /// Renderer::setSkybox()
    Result<void> set(const SkyboxMap* cube, SkyboxSource source);

    bool isShown() const { return static_cast<bool>(m_texture.texture); }
    /// The largest radiance that a texel can hold.
    float range() const { return m_range; }
    /// With its program in use and fed.
    void draw(GlState& state) const;

    void lost() override;
    Result<void> restore() override;

private:
    Result<void> upload(const SkyboxMap& cube);

    Device& m_device;
    GpuTexture m_texture;
    GlBuffer m_triangle;
    float m_range = 0;
    SkyboxSource m_source;
};

} // namespace franken
