// SPDX-License-Identifier: MIT
#pragma once

#include "device.h"
#include "franken/environment.h"
#include "franken/gl_object.h"
#include "franken/normal_spread.h"
#include "franken/resample.h"
#include "franken/scene.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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
    bool hasMips = false;
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

/// A texture's texels as GL takes them: decoded, resampled to the size that the GPU takes, and with mip
/// levels where the filter uses them. Needs no GL.
class TextureData {
public:
    /// What looks at an image's pixels as they are before they are resampled.
    using Look = std::function<void(const Image&)>;

    /// The image must outlive the data, unless it is encoded. Fails with "renderer.image" for an image whose
    /// size and bytes differ, and as decodeImage() does. Safe on any thread.
    static Result<TextureData> make(const Image& image, const Texture& texture, TextureContents contents,
                                    const Capabilities& capabilities, const Look& look = {});

    /// One texel, in place of an image that cannot be decoded.
    static TextureData texel(const std::array<std::uint8_t, 4>& rgba, const Texture& texture,
                             TextureContents contents);

    /// Of a roughness texture: its mips hold what those of a normal map lose, which is on the GPU in that
    /// size. The whole image does where the normal map had to be scaled down to no more than its size: as a
    /// mip does, it stands for several normals then. `factor`: of roughness, which `channel` holds.
    void roughen(const NormalSpread& spread, TextureSize normals, std::size_t channel, float factor);

    std::size_t levels() const { return 1 + m_smaller.size(); }
    const Image& level(std::size_t i) const { return i > 0 ? m_smaller[i - 1] : m_own ? *m_own : *m_image; }
    const Texture& sampling() const { return m_sampling; }
    TextureContents contents() const { return m_contents; }
    /// For the log; empty where there is nothing to say.
    const std::string& notice() const { return m_notice; }
    /// Of all levels.
    std::size_t bytes() const;

private:
    TextureData(const Image& image, const Texture& sampling, TextureContents contents)
        : m_image(&image), m_sampling(sampling), m_contents(contents) {}

    const Image* m_image;
    std::optional<Image> m_own; ///< In place of m_image.
    std::vector<Image> m_smaller;
    Texture m_sampling;
    TextureContents m_contents;
    std::string m_notice;
};

/// A texture that is uploaded in parts.
class TextureUpload {
public:
    /// Fails with "memory.budget" and "gl.object".
    static Result<TextureUpload> begin(Device& device, TextureData data);
    /// Into a texture that is there, of the same size and contents.
    static TextureUpload into(GpuTexture texture, TextureData data) {
        TextureUpload upload(std::move(texture), std::move(data));
        upload.m_replaces = true;
        return upload;
    }

    bool isDone() const { return m_level == m_data.levels(); }
    /// Uploads rows of one level, as many as there are bytes for and at least one; how many bytes these are.
    /// Leaves the texture bound to unit 0.
    std::size_t step(const Gl& gl, std::size_t maxBytes = ~std::size_t{0});
    GpuTexture take() { return std::move(m_texture); }

private:
    TextureUpload(GpuTexture texture, TextureData data)
        : m_texture(std::move(texture)), m_data(std::move(data)) {}

    GpuTexture m_texture;
    TextureData m_data;
    std::size_t m_level = 0;
    int m_row = 0;
    bool m_replaces = false; ///< The levels are there already.
};

/// Uploads as RGBA8, all at once, with a warning where the GPU's limit made it smaller. Fails as TextureData
/// and TextureUpload do. This and the next three leave the texture bound to unit 0.
Result<GpuTexture> uploadTexture(Device& device, const Image& image, const Texture& texture,
                                 TextureContents contents);

/// Replaces the texels of what uploadTexture() returned, where the fitted size is the same; whether it is.
Result<bool> updateTexture(Device& device, GpuTexture& gpu, const Image& image, const Texture& texture);

/// Of a context that has the extension. Leaves the texture bound to unit 0.
void setAnisotropy(const Gl& gl, const GpuTexture& gpu, float anisotropy);

/// One texel.
GlTexture uploadTexel(const Gl& gl, const std::array<std::uint8_t, 4>& rgba);

/// Fails as uploadTexture() does, and with "renderer.sky" for faces of different sizes, or larger than the
/// GPU takes.
Result<GpuTexture> uploadCube(Device& device, const SkyboxMap& cube);

} // namespace franken
