// SPDX-License-Identifier: MIT
#include "reflection_textures.h"

#include "checked_upload.h"
#include "checks.h"
#include "franken/generator/texture_role.h"
#include "franken/guard.h"

#include <algorithm>

namespace franken {
namespace {

Error tooLarge(const Image& atlas, int most) {
    return {"renderer.sky", "",
            "the levels of the sky are " + std::to_string(atlas.width) + "x" + std::to_string(atlas.height) +
                ", and the GPU takes up to " + std::to_string(most),
            "filter the sky to a smaller size"};
}

void bindTo(GlState& state, TextureRole role, const GpuTexture& texture) {
    state.bindTexture(static_cast<unsigned>(rowOf(role).unit), GL_TEXTURE_2D, texture.texture.name());
}

} // namespace

ReflectionTextures::Textures::Textures(const Gl& gl)
    : atlas{uploadTexel(gl, rowOf(TextureRole::Reflection).defaultTexel), {}},
      lookup{uploadTexel(gl, rowOf(TextureRole::ReflectionLookup).defaultTexel), {}} {}

Result<ReflectionTextures::Textures> ReflectionTextures::made(const ReflectionMaps& maps) {
    const Image& atlas = maps.atlas.image;
    if (std::max(atlas.width, atlas.height) > m_device.capabilities.maxTextureSize)
        return tooLarge(atlas, m_device.capabilities.maxTextureSize);
    Textures textures(m_device.gl);
    for (const auto& [texture, image] :
         {std::pair(&textures.atlas, &atlas), {&textures.lookup, &maps.lookup}}) {
        Result<GpuTexture> uploaded =
            uploadTexture(m_device, *image, kPlainSampling, TextureContents::Numbers);
        if (!uploaded)
            return uploaded.error();
        *texture = *std::move(uploaded);
    }
    textures.range = maps.atlas.range;
    return textures;
}

Result<void> ReflectionTextures::upload(const ReflectionMaps& maps) {
    if (Result<void> checked = checkRange(maps.atlas.range); !checked)
        return checked;
    return checkedUpload(m_device, [&] { return made(maps); }).transform([this](Textures textures) {
        m_textures = std::move(textures);
    });
}

Result<void> ReflectionTextures::set(const ReflectionMaps* maps, ReflectionSource source) {
    m_device.state.invalidate();
    m_textures.emplace(m_device.gl);
    m_source = std::move(source);
    return maps == nullptr ? Result<void>() : upload(*maps);
}

Result<void> ReflectionTextures::restore() {
    m_textures.emplace(m_device.gl);
    if (!m_source)
        return {};
    const Result<ReflectionMaps> maps = guarded("the source of the reflection", m_source);
    return maps ? upload(*maps) : maps.error();
}

void ReflectionTextures::bind(GlState& state) const {
    bindTo(state, TextureRole::Reflection, m_textures->atlas);
    bindTo(state, TextureRole::ReflectionLookup, m_textures->lookup);
}

} // namespace franken
