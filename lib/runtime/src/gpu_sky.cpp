// SPDX-License-Identifier: MIT
#include "gpu_sky.h"

#include "franken/generator/interface.h"
#include "gpu_texture.h"

#include <algorithm>

namespace franken {
namespace {

constexpr Texture kClamped = {.wrapS = Wrap::ClampToEdge,
                              .wrapT = Wrap::ClampToEdge,
                              .magFilter = Filter::Linear,
                              .minFilter = Filter::Linear};

void bind(const Gl& gl, const char* sampler, const GlTexture& texture) {
    gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(samplerUnit(sampler)));
    gl.BindTexture(GL_TEXTURE_2D, texture.name());
}

} // namespace

GpuMirror::GpuMirror(const Gl& gl)
    : atlas(uploadTexel(gl, {0, 0, 0, 0})), lookup(uploadTexel(gl, {0, 0, 0, 0})) {}

Result<GpuMirror> uploadMirror(const Gl& gl, const SkyMirror& mirror, const Capabilities& capabilities) {
    const Image& atlas = mirror.atlas.image;
    if (std::max(atlas.width, atlas.height) > capabilities.maxTextureSize)
        return Error{"renderer.sky", "",
                     "the sky's levels are " + std::to_string(atlas.width) + "x" +
                         std::to_string(atlas.height) + ", and the GPU takes up to " +
                         std::to_string(capabilities.maxTextureSize),
                     "filter the sky to a smaller size"};
    GpuMirror gpu(gl);
    gpu.atlas = uploadTexture(gl, atlas, kClamped, Encoding::Linear, capabilities, {});
    gpu.lookup = uploadTexture(gl, mirror.lookup, kClamped, Encoding::Linear, capabilities, {});
    gpu.range = mirror.atlas.range;
    return gpu;
}

void bindMirror(const Gl& gl, const GpuMirror& mirror) {
    bind(gl, "uSpecularSky", mirror.atlas);
    bind(gl, "uSpecularLookup", mirror.lookup);
}

} // namespace franken
