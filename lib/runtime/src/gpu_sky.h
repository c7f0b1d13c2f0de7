// SPDX-License-Identifier: MIT
#pragma once

#include "franken/capabilities.h"
#include "franken/gl_object.h"
#include "franken/result.h"
#include "franken/specular_sky.h"

namespace franken {

/// A SkyMirror on the GPU. Without one, its textures are single texels that reflect nothing.
struct GpuMirror {
    explicit GpuMirror(const Gl& gl);

    GlTexture atlas, lookup;
    float range = 0;
};

/// Fails with "renderer.sky" where the context's textures are too small. Leaves textures bound to unit 0.
Result<GpuMirror> uploadMirror(const Gl& gl, const SkyMirror& mirror, const Capabilities& capabilities);

/// To the units that samplerUnit() gives them, which no material uses.
void bindMirror(const Gl& gl, const GpuMirror& mirror);

} // namespace franken
