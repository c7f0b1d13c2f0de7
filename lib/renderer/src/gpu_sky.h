// SPDX-License-Identifier: MIT
#pragma once

#include "franken/gl_state.h"
#include "franken/specular_sky.h"
#include "gpu_texture.h"

namespace franken {

/// A SkyMirror on the GPU. Without one, its textures are single texels that reflect nothing.
struct GpuMirror {
    explicit GpuMirror(const Gl& gl);

    GpuTexture atlas, lookup;
    float range = 0;
};

/// Fails with "renderer.sky" where the context's textures are too small, and with "memory.budget". Leaves
/// textures bound to unit 0.
Result<GpuMirror> uploadMirror(const Device& device, const SkyMirror& mirror);

/// To the units that samplerUnit() gives them, which no material uses.
void bindMirror(GlState& state, const GpuMirror& mirror);

} // namespace franken
