// SPDX-License-Identifier: MIT
#include "gpu_texture.h"

#include "checks.h"
#include "franken/gl_sampling.h"
#include "franken/mipmap.h"
#include "gpu_buffer.h"

#include <algorithm>
#include <bit>
#include <numbers>
#include <string>

namespace franken {
namespace {

bool needsPowersOfTwo(const Texture& texture) {
    return usesMipmaps(texture.minFilter) || texture.wrapS != Wrap::ClampToEdge ||
           texture.wrapT != Wrap::ClampToEdge;
}

int powerOfTwoBelow(int size) { return static_cast<int>(std::bit_floor(static_cast<unsigned>(size))); }

/// By ratio.
int nearestPowerOfTwo(int size) {
    const int low = powerOfTwoBelow(size);
    return size >= low * std::numbers::sqrt2 ? 2 * low : low;
}

void bind(const Gl& gl, GLenum target, const GlTexture& texture) {
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(target, texture.name());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

void bind(const Gl& gl, GLenum target, const GlTexture& texture, const Texture& sampling) {
    bind(gl, target, texture);
    setSampling(gl, target, sampling.wrapS, sampling.wrapT, sampling.magFilter, sampling.minFilter);
}

/// Makes a level of the texture that is bound; without texels where `rgba` is null.
void makeLevel(const Gl& gl, GLenum target, GLint level, const Image& image, const std::uint8_t* rgba) {
    gl.TexImage2D(target, level, GL_RGBA, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
}

std::size_t rowBytes(const Image& image) { return 4 * static_cast<std::size_t>(image.width); }

/// How many rows from `row` on are written at once. vc4 and v3d keep texels in tiles of four rows: where only
/// a part of a tile is written, they read it back first.
int rowsWithin(const Image& image, int row, std::size_t maxBytes) {
    constexpr int kTileRows = 4;
    const std::size_t most = std::max<std::size_t>(1, maxBytes / rowBytes(image));
    if (most >= static_cast<std::size_t>(image.height - row))
        return image.height - row;
    const int rows = static_cast<int>(most);
    return rows > kTileRows ? rows - rows % kTileRows : rows;
}

} // namespace

TextureSize fittedSize(const Image& image, const Texture& texture, const Capabilities& capabilities) {
    const int longest = std::max(image.width, image.height);
    const double scale = std::min(1.0, static_cast<double>(capabilities.maxTextureSize) / longest);
    const bool powers = !capabilities.anyTextureSize && needsPowersOfTwo(texture);
    const int largest = powerOfTwoBelow(capabilities.maxTextureSize);
    const auto fit = [&](int size) {
        const int scaled = std::max(1, static_cast<int>(size * scale));
        return powers ? std::min(nearestPowerOfTwo(scaled), largest) : scaled;
    };
    return {fit(image.width), fit(image.height)};
}

std::size_t textureBytes(TextureSize size, bool mipmaps) {
    constexpr std::size_t kTexel = 4;
    std::size_t texels = 0;
    for (auto [width, height] = size;; width = std::max(1, width / 2), height = std::max(1, height / 2)) {
        texels += static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
        if (!mipmaps || (width == 1 && height == 1))
            return texels * kTexel;
    }
}

Result<TextureData> TextureData::make(const Image& image, const Texture& texture, TextureContents contents,
                                      const Capabilities& capabilities, const Look& look) {
    if (Result<void> checked = check(image); !checked)
        return checked.error();
    TextureData data(image, texture, contents);
    if (!image.encoded.empty()) {
        Result<Image> decoded = withPixels(image);
        if (!decoded)
            return decoded.error();
        if (decoded->width != image.width || decoded->height != image.height)
            return Error{"renderer.image", image.name,
                         "its width and height are not those of the picture in it, which has " +
                             std::to_string(decoded->width) + "x" + std::to_string(decoded->height),
                         "fill in width and height as the encoded bytes have them"};
        data.m_own = *std::move(decoded);
    }
    if (look)
        look(data.level(0));
    const TextureSize size = fittedSize(data.level(0), texture, capabilities);
    if (std::max(data.level(0).width, data.level(0).height) > capabilities.maxTextureSize)
        data.m_notice = "image \"" + image.name + "\" is scaled down to " + std::to_string(size.width) + "x" +
                        std::to_string(size.height) + ", the GPU's limit";
    if (size != TextureSize{data.level(0).width, data.level(0).height})
        data.m_own = resampled(data.level(0), size.width, size.height, texture, contents);
    if (usesMipmaps(texture.minFilter))
        data.m_smaller = mipmaps(data.level(0), contents);
    return data;
}

TextureData TextureData::texel(const std::array<std::uint8_t, 4>& rgba, const Texture& texture,
                               TextureContents contents) {
    static const Image kEmpty;
    TextureData data(kEmpty, texture, contents);
    data.m_own = Image{"", 1, 1, {rgba.begin(), rgba.end()}};
    return data;
}

void TextureData::roughen(const NormalSpread& spread, TextureSize normals, std::size_t channel,
                          float factor) {
    const Image& whole = level(0);
    if (normals.width <= whole.width && normals.height <= whole.height && spread.widens(whole)) {
        Image widened = whole;
        spread.roughen(widened, channel, factor);
        m_own = std::move(widened);
    }
    for (Image& smaller : m_smaller)
        spread.roughen(smaller, channel, factor);
}

std::size_t TextureData::bytes() const {
    return textureBytes({level(0).width, level(0).height}, !m_smaller.empty());
}

Result<TextureUpload> TextureUpload::begin(Device& device, TextureData data) {
    Result<MemoryLease> lease = device.memory.reserve(MemoryUse::Textures, data.bytes());
    if (!lease)
        return lease.error();
    if (device.log && !data.notice().empty())
        device.log(LogLevel::Warning, data.notice());
    GlTexture name(device.gl, generate(device.gl.GenTextures));
    if (!name)
        return noObject("texture");
    bind(device.gl, GL_TEXTURE_2D, name, data.sampling());
    const Image& whole = data.level(0);
    GpuTexture texture{
        std::move(name), *std::move(lease), {whole.width, whole.height}, data.contents(), data.levels() > 1};
    return TextureUpload(std::move(texture), std::move(data));
}

std::size_t TextureUpload::step(const Gl& gl, std::size_t maxBytes) {
    const Image& image = m_data.level(m_level);
    const auto level = static_cast<GLint>(m_level);
    const int rows = rowsWithin(image, m_row, maxBytes);
    bind(gl, GL_TEXTURE_2D, m_texture.texture);
    if (rows == image.height && !m_replaces) {
        makeLevel(gl, GL_TEXTURE_2D, level, image, image.rgba.data());
    } else {
        if (m_row == 0 && !m_replaces)
            makeLevel(gl, GL_TEXTURE_2D, level, image, nullptr);
        gl.TexSubImage2D(GL_TEXTURE_2D, level, 0, m_row, image.width, rows, GL_RGBA, GL_UNSIGNED_BYTE,
                         image.rgba.data() + static_cast<std::size_t>(m_row) * rowBytes(image));
    }
    m_row += rows;
    if (m_row == image.height) {
        m_row = 0;
        ++m_level;
    }
    return static_cast<std::size_t>(rows) * rowBytes(image);
}

Result<GpuTexture> uploadTexture(Device& device, const Image& image, const Texture& texture,
                                 TextureContents contents) {
    Result<TextureData> data = TextureData::make(image, texture, contents, device.capabilities);
    if (!data)
        return data.error();
    Result<TextureUpload> upload = TextureUpload::begin(device, *std::move(data));
    if (!upload)
        return upload.error();
    while (!upload->isDone())
        upload->step(device.gl);
    return upload->take();
}

Result<bool> updateTexture(Device& device, GpuTexture& gpu, const Image& image, const Texture& texture) {
    if (Result<void> checked = check(image); !checked)
        return checked.error();
    if (fittedSize(image, texture, device.capabilities) != gpu.size)
        return false;
    Result<TextureData> data = TextureData::make(image, texture, gpu.contents, device.capabilities);
    if (!data)
        return data.error();
    TextureUpload upload = TextureUpload::into(std::move(gpu), *std::move(data));
    while (!upload.isDone())
        upload.step(device.gl);
    gpu = upload.take();
    return true;
}

void setAnisotropy(const Gl& gl, const GpuTexture& gpu, float anisotropy) {
    constexpr GLenum kTextureMaxAnisotropy = 0x84FE;
    bind(gl, GL_TEXTURE_2D, gpu.texture);
    gl.TexParameterf(GL_TEXTURE_2D, kTextureMaxAnisotropy, anisotropy);
}

GlTexture uploadTexel(const Gl& gl, const std::array<std::uint8_t, 4>& rgba) {
    GlTexture name(gl, generate(gl.GenTextures));
    bind(gl, GL_TEXTURE_2D, name, kPlainSampling);
    makeLevel(gl, GL_TEXTURE_2D, 0, {"", 1, 1, {}}, rgba.data());
    return name;
}

Result<GpuTexture> uploadCube(Device& device, const SkyboxMap& cube) {
    for (const Image& face : cube.images)
        if (Result<void> checked = check(face); !checked)
            return checked.error();
        else if (face.width != cube.size || face.height != cube.size ||
                 cube.size > device.capabilities.maxCubeSize)
            return Error{"renderer.sky", "",
                         "a face of the sky is " + std::to_string(face.width) + "x" +
                             std::to_string(face.height) + ", of a cube of " + std::to_string(cube.size) +
                             ", and the GPU takes up to " + std::to_string(device.capabilities.maxCubeSize),
                         "make it with encodeSkybox(), in a size that the GPU takes"};
    Result<MemoryLease> lease = device.memory.reserve(
        MemoryUse::Textures, cube.images.size() * textureBytes({cube.size, cube.size}, false));
    if (!lease)
        return lease.error();
    GlTexture name(device.gl, generate(device.gl.GenTextures));
    if (!name)
        return noObject("texture");
    bind(device.gl, GL_TEXTURE_CUBE_MAP, name, kPlainSampling);
    for (std::size_t face = 0; face < cube.images.size(); ++face)
        makeLevel(device.gl, GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face), 0, cube.images[face],
                  cube.images[face].rgba.data());
    return GpuTexture{std::move(name), *std::move(lease), {cube.size, cube.size}};
}

} // namespace franken
