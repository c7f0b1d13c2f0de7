// SPDX-License-Identifier: MIT
#pragma once

#include "franken/capabilities.h"
#include "franken/environment.h"
#include "franken/gl_object.h"
#include "franken/log.h"
#include "franken/scene.h"

#include <array>

namespace franken {

struct TextureSize {
    int width, height;
    friend bool operator==(const TextureSize&, const TextureSize&) = default;
};

/// The size at which the context takes an image as the texture asks: not above its largest, and powers of
/// two where they must be because the texture repeats or has mipmaps.
TextureSize fittedSize(const Image& image, const Texture& texture, const Capabilities& capabilities);

/// What the colour channels of a texture hold. Alpha is always linear.
enum class Encoding { Linear, Srgb };

/// Uploads as RGBA8, with mipmaps where the filter uses them; resampled to its fitted size, with a warning
/// where the GPU's limit is the reason. This and the next two leave the texture bound to unit 0.
GlTexture uploadTexture(const Gl& gl, const Image& image, const Texture& texture, Encoding encoding,
                        const Capabilities& capabilities, const Log& log);

/// One texel.
GlTexture uploadTexel(const Gl& gl, const std::array<std::uint8_t, 4>& rgba);

GlTexture uploadCube(const Gl& gl, const SkyCube& cube);

} // namespace franken
