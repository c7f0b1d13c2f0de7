// SPDX-License-Identifier: MIT
#pragma once

#include "franken/renderer.h"
#include "gl_owner.h"
#include "gpu_texture.h"

#include <optional>

namespace franken {

/// The textures that surfaces reflect. Without an environment they are single texels that reflect nothing.
class ReflectionTextures final : public GlOwner {
public:
    explicit ReflectionTextures(Device& device) : m_device(device), m_textures(device.gl) {}

    /// Renderer::setReflection()
    Result<void> set(const ReflectionMaps* maps, ReflectionSource source);

    /// To the units that samplerUnit() gives them, which no material uses.
    void bind(GlState& state) const;
    /// The largest radiance that a texel of the atlas can hold; 0 without an environment.
    float range() const { return m_textures ? m_textures->range : 0; }

    void lost() override { m_textures.reset(); }
    Result<void> restore() override;

private:
    struct Textures {
        explicit Textures(const Gl& gl);
        GpuTexture atlas, lookup;
        float range = 0;
    };

    Result<Textures> made(const ReflectionMaps& maps);
    Result<void> upload(const ReflectionMaps& maps);

    Device& m_device;
    std::optional<Textures> m_textures; ///< Nothing while there is no context.
    ReflectionSource m_source;
};

} // namespace franken
