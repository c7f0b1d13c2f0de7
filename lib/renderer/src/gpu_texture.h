// SPDX-License-Identifier: MIT
#pragma once

#include "device.h"
#include "franken/environment.h"
#include "franken/gl_object.h"
#include "franken/resample.h"
#include "franken/scene.h"

#include <array>

namespace franken {

struct TextureSize {
    int width, height;
    friend bool operator==(const TextureSize&, const TextureSize&) = default;
};

struct GpuTexture {
    GlTexture texture;
    MemoryLease memory;
    TextureSize size{0, 0};
    TextureContents contents = TextureContents::Color;
};

/// How what is neither tiled nor minified is sampled.
inline constexpr Texture kPlainSampling = {.wrapS = Wrap::ClampToEdge,
                                           .wrapT = Wrap::ClampToEdge,
                                           .magFilter = Filter::Linear,
                                           .minFilter = Filter::Linear};

/// The size at which the context takes an image as the texture asks: not above its largest, and powers of
/// two where they must be because the texture repeats or has mipmaps.
TextureSize fittedSize(const Image& image, const Texture& texture, const Capabilities& capabilities);

/// Of an RGBA8 texture.
std::size_t textureBytes(TextureSize size, bool mipmaps);

/// Uploads as RGBA8, with mipmaps where the filter uses them; resampled to its fitted size, with a warning
/// where the GPU's limit is the reason. Fails with "renderer.image" for an image whose size and bytes differ,
/// with "memory.budget" and with "gl.object". This and the next three leave the texture bound to unit 0.
Result<GpuTexture> uploadTexture(Device& device, const Image& image, const Texture& texture,
                                 TextureContents contents);

/// Replaces the texels of what uploadTexture() returned, where the fitted size is the same; whether it is.
Result<bool> updateTexture(Device& device, GpuTexture& gpu, const Image& image, const Texture& texture);

/// One texel.
GlTexture uploadTexel(const Gl& gl, const std::array<std::uint8_t, 4>& rgba);

/// Fails as uploadTexture() does, and with "renderer.sky" for faces of different sizes, or larger than the
/// GPU takes.
Result<GpuTexture> uploadCube(Device& device, const SkyboxMap& cube);

} // namespace franken
