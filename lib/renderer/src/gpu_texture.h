// SPDX-License-Identifier: MIT
#pragma once

#include "franken/capabilities.h"
#include "franken/environment.h"
#include "franken/gl_object.h"
#include "franken/gpu_memory.h"
#include "franken/log.h"
#include "franken/scene.h"
#include "franken/resample.h"

#include <array>

namespace franken {

/// Where uploads go.
struct Device {
    const Gl& gl;
    const Capabilities& capabilities;
    GpuMemory& memory;
    const Log& log;
};

struct GpuTexture {
    GlTexture texture;
    MemoryLease memory;
};

/// How what is neither tiled nor minified is sampled.
inline constexpr Texture kPlainSampling = {.wrapS = Wrap::ClampToEdge,
                                           .wrapT = Wrap::ClampToEdge,
                                           .magFilter = Filter::Linear,
                                           .minFilter = Filter::Linear};

struct TextureSize {
    int width, height;
    friend bool operator==(const TextureSize&, const TextureSize&) = default;
};

/// The size at which the context takes an image as the texture asks: not above its largest, and powers of
/// two where they must be because the texture repeats or has mipmaps.
TextureSize fittedSize(const Image& image, const Texture& texture, const Capabilities& capabilities);

/// Of an RGBA8 texture.
std::size_t textureBytes(TextureSize size, bool mipmaps);

/// Uploads as RGBA8, with mipmaps where the filter uses them; resampled to its fitted size, with a warning
/// where the GPU's limit is the reason. Fails with "memory.budget". This and the next two leave the texture
/// bound to unit 0.
Result<GpuTexture> uploadTexture(const Device& device, const Image& image, const Texture& texture,
                                 TextureContents contents);

/// One texel.
GlTexture uploadTexel(const Gl& gl, const std::array<std::uint8_t, 4>& rgba);

GlTexture uploadCube(const Gl& gl, const SkyCube& cube);

} // namespace franken
