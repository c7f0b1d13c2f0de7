// SPDX-License-Identifier: MIT
#include "gpu_sky.h"

#include "franken/generator/interface.h"

#include <algorithm>

namespace franken {
namespace {

void bind(GlState& state, const char* sampler, const GpuTexture& texture) {
    state.bindTexture(static_cast<unsigned>(samplerUnit(sampler)), GL_TEXTURE_2D, texture.texture.name());
}

} // namespace

GpuMirror::GpuMirror(const Gl& gl)
    : atlas{uploadTexel(gl, {0, 0, 0, 0}), {}}, lookup{uploadTexel(gl, {0, 0, 0, 0}), {}} {}

Result<GpuMirror> uploadMirror(const Device& device, const SkyMirror& mirror) {
    const Image& atlas = mirror.atlas.image;
    if (std::max(atlas.width, atlas.height) > device.capabilities.maxTextureSize)
        return Error{"renderer.sky", "",
                     "the sky's levels are " + std::to_string(atlas.width) + "x" +
                         std::to_string(atlas.height) + ", and the GPU takes up to " +
                         std::to_string(device.capabilities.maxTextureSize),
                     "filter the sky to a smaller size"};
    GpuMirror gpu(device.gl);
    for (const auto& [texture, image] : {std::pair(&gpu.atlas, &atlas), {&gpu.lookup, &mirror.lookup}}) {
        Result<GpuTexture> uploaded = uploadTexture(device, *image, kPlainSampling, TextureContents::Numbers);
        if (!uploaded)
            return uploaded.error();
        *texture = *std::move(uploaded);
    }
    gpu.range = mirror.atlas.range;
    return gpu;
}

void bindMirror(GlState& state, const GpuMirror& mirror) {
    bind(state, "uReflectionTexture", mirror.atlas);
    bind(state, "uReflectionLookup", mirror.lookup);
}

} // namespace franken
