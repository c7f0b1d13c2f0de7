// SPDX-License-Identifier: MIT
#include "pictures.h"

#include "checked_upload.h"
#include "franken/guard.h"
#include "handle.h"

#include <algorithm>

namespace franken {
namespace {

Error noPicture() {
    return {
        "renderer.picture", "", "there is no such picture",
        "use what addPicture() returned, until removePicture(), and give a source that outlives a context"};
}

Error noSource() {
    return {"renderer.no-source", "", "a picture was lost with the context, and it has no source",
            "hand addPicture() a source that reads it again"};
}

} // namespace

const Pictures::Picture* Pictures::find(PictureId id) const {
    const auto found = std::find_if(m_pictures.begin(), m_pictures.end(),
                                    [&](const Picture& picture) { return picture.id == id; });
    return found == m_pictures.end() ? nullptr : &*found;
}

Result<void> Pictures::upload(Picture& picture, const Image& image) {
    return checkedUpload(
               m_device,
               [&] { return uploadTexture(m_device, image, kPlainSampling, TextureContents::Color); })
        .transform([&picture](GpuTexture texture) { picture.texture = std::move(texture); });
}

Result<void> Pictures::makeResident(Picture& picture) {
    if (picture.texture.texture)
        return {};
    const Result<Image> image = guarded("the source of a picture", picture.source);
    return image ? upload(picture, *image) : image.error();
}

Result<PictureId> Pictures::add(const Image& image, PictureSource source) {
    // Not drawn yet: older than all that this frame drew.
    Picture picture{newHandle<PictureId>(), std::move(source), m_device.frameBegan - 1};
    if (Result<void> uploaded = upload(picture, image); !uploaded)
        return uploaded.error();
    m_pictures.push_back(std::move(picture));
    return m_pictures.back().id;
}

void Pictures::remove(PictureId id) {
    std::erase_if(m_pictures, [&](const Picture& picture) { return picture.id == id; });
    m_device.state.invalidate();
}

// All are marked before the first is uploaded: none is evicted for another.
Result<void> Pictures::prepare(std::span<const OverlayQuad> quads) {
    std::vector<Picture*> needed;
    for (const OverlayQuad& quad : quads) {
        Picture* const picture =
            !needed.empty() && needed.back()->id == quad.picture ? needed.back() : find(quad.picture);
        if (picture == nullptr || !(picture->texture.texture || picture->source))
            return noPicture();
        picture->lastDrawn = m_device.clock;
        if (needed.empty() || needed.back() != picture)
            needed.push_back(picture);
    }
    for (Picture* picture : needed)
        if (Result<void> made = makeResident(*picture); !made)
            return made;
    return {};
}

GLuint Pictures::textureOf(PictureId id) const { return find(id)->texture.texture.name(); }

void Pictures::lost() {
    for (Picture& picture : m_pictures)
        picture.texture = {};
}

Result<void> Pictures::restore() {
    const auto hasNoSource = [](const Picture& picture) { return !picture.source; };
    return std::any_of(m_pictures.begin(), m_pictures.end(), hasNoSource) ? noSource() : Result<void>();
}

const Pictures::Picture* Pictures::oldest() const {
    const Picture* oldest = nullptr;
    for (const Picture& picture : m_pictures)
        if (picture.texture.texture && picture.source && picture.lastDrawn < m_device.frameBegan &&
            (oldest == nullptr || picture.lastDrawn < oldest->lastDrawn))
            oldest = &picture;
    return oldest;
}

std::optional<std::uint64_t> Pictures::oldestUse() const {
    const Picture* const picture = oldest();
    return picture == nullptr ? std::nullopt : std::optional(picture->lastDrawn);
}

void Pictures::evictOldest() {
    if (const Picture* const picture = oldest())
        find(picture->id)->texture = {};
}

} // namespace franken
