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

void bind(const Gl& gl, GLenum target, const GlTexture& texture, const Texture& sampling) {
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(target, texture.name());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    setSampling(gl, target, sampling.wrapS, sampling.wrapT, sampling.magFilter, sampling.minFilter);
}

/// Makes a level of the texture that is bound, or replaces what is in it.
using WriteLevel = void (*)(const Gl& gl, GLenum target, const Image& image, GLint level);

void uploadPixels(const Gl& gl, GLenum target, const Image& image, GLint level = 0) {
    gl.TexImage2D(target, level, GL_RGBA, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  image.rgba.data());
}

void replacePixels(const Gl& gl, GLenum target, const Image& image, GLint level) {
    gl.TexSubImage2D(target, level, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE,
                     image.rgba.data());
}

void writeLevels(const Gl& gl, const Image& image, bool mipmaps, TextureContents contents, WriteLevel write) {
    write(gl, GL_TEXTURE_2D, image, 0);
    if (mipmaps && contents != TextureContents::Color)
        gl.GenerateMipmap(GL_TEXTURE_2D);
    else if (mipmaps)
        for (GLint level = 0; const Image& smaller : srgbMipmaps(image))
            write(gl, GL_TEXTURE_2D, smaller, ++level);
}

void writeFitted(const Gl& gl, const Image& image, TextureSize size, const Texture& texture,
                 TextureContents contents, WriteLevel write) {
    const bool mipmaps = usesMipmaps(texture.minFilter);
    if (size == TextureSize{image.width, image.height})
        writeLevels(gl, image, mipmaps, contents, write);
    else
        writeLevels(gl, resampled(image, size.width, size.height, texture, contents), mipmaps, contents,
                    write);
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

Result<GpuTexture> uploadTexture(Device& device, const Image& image, const Texture& texture,
                                 TextureContents contents) {
    if (Result<void> checked = check(image); !checked)
        return checked.error();
    const Gl& gl = device.gl;
    const TextureSize size = fittedSize(image, texture, device.capabilities);
    const bool mipmaps = usesMipmaps(texture.minFilter);
    Result<MemoryLease> lease = device.memory.reserve(MemoryUse::Textures, textureBytes(size, mipmaps));
    if (!lease)
        return lease.error();
    if (device.log && std::max(image.width, image.height) > device.capabilities.maxTextureSize)
        device.log(LogLevel::Warning, "image \"" + image.name + "\" is scaled down to " +
                                          std::to_string(size.width) + "x" + std::to_string(size.height) +
                                          ", the GPU's limit");
    GlTexture name(gl, generate(gl.GenTextures));
    if (!name)
        return noObject("texture");
    bind(gl, GL_TEXTURE_2D, name, texture);
    writeFitted(gl, image, size, texture, contents, uploadPixels);
    return GpuTexture{std::move(name), *std::move(lease), size, contents};
}

Result<bool> updateTexture(Device& device, GpuTexture& gpu, const Image& image, const Texture& texture) {
    if (Result<void> checked = check(image); !checked)
        return checked.error();
    if (fittedSize(image, texture, device.capabilities) != gpu.size)
        return false;
    bind(device.gl, GL_TEXTURE_2D, gpu.texture, texture);
    writeFitted(device.gl, image, gpu.size, texture, gpu.contents, replacePixels);
    return true;
}

GlTexture uploadTexel(const Gl& gl, const std::array<std::uint8_t, 4>& rgba) {
    GlTexture name(gl, generate(gl.GenTextures));
    bind(gl, GL_TEXTURE_2D, name, kPlainSampling);
    uploadPixels(gl, GL_TEXTURE_2D, {"", 1, 1, {rgba.begin(), rgba.end()}});
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
        uploadPixels(device.gl, GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face),
                     cube.images[face]);
    return GpuTexture{std::move(name), *std::move(lease), {cube.size, cube.size}};
}

} // namespace franken
