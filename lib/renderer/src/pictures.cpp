// SPDX-License-Identifier: MIT
#include "pictures.h"

#include "checked_upload.h"
#include "checks.h"
#include "franken/guard.h"
#include "handle.h"

#include <algorithm>
#include <string>

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

Error noTexture(GLuint texture) {
    return {"renderer.application-texture", std::to_string(texture),
            "it is not the name of a two-dimensional texture of this context",
            "bind it once to GL_TEXTURE_2D before, and after a lost context make it anew"};
}

std::string sizeText(TextureSize size) {
    return std::to_string(size.width) + "x" + std::to_string(size.height);
}

Error notWithin(const Image& image, int x, int y, TextureSize size) {
    return {"renderer.picture-part", image.name,
            "an image of " + sizeText({image.width, image.height}) + " at " + std::to_string(x) + ", " +
                std::to_string(y) + " does not lie in a picture of " + sizeText(size),
            "add another picture for another size"};
}

Error isScaled(TextureSize size, TextureSize gpu) {
    return {"renderer.picture-part", "",
            "the picture of " + sizeText(size) + " is scaled down to " + sizeText(gpu) +
                ", the GPU's limit, and has no parts",
            "update all of it, or use a picture that the GPU takes"};
}

bool liesWithin(const Image& image, int x, int y, TextureSize size) {
    return x >= 0 && y >= 0 && image.width <= size.width && image.height <= size.height &&
           x <= size.width - image.width && y <= size.height - image.height;
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
        .transform([&](GpuTexture texture) {
            picture.size = {image.width, image.height};
            picture.texture = std::move(texture);
        });
}

Result<void> Pictures::makeResident(Picture& picture) {
    if (picture.name() != 0)
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

// Asks GL for nothing where the picture is on the GPU: it may be called in each frame.
Result<void> Pictures::update(PictureId id, const Image& image, int x, int y) {
    Picture* const picture = find(id);
    if (picture == nullptr || picture->isOfApplication || picture->size.width == 0)
        return noPicture();
    if (Result<void> checked = check(image); !checked)
        return checked;
    if (!liesWithin(image, x, y, picture->size))
        return notWithin(image, x, y, picture->size);
    const bool isWhole = picture->size == TextureSize{image.width, image.height};
    if (!picture->texture.texture && isWhole)
        return upload(*picture, image);
    if (!picture->canBeDrawn())
        return noPicture();
    if (Result<void> made = makeResident(*picture); !made)
        return made;
    GpuTexture& texture = picture->texture;
    if (texture.size != picture->size)
        return isWhole
                   ? checkedUpload(m_device,
                                   [&] { return updateTexture(m_device, texture, image, kPlainSampling); })
                         .transform([](bool) {})
                   : isScaled(picture->size, texture.size);
    m_device.state.bindForUpload(texture.texture.name());
    m_device.gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    m_device.gl.TexSubImage2D(GL_TEXTURE_2D, 0, x, y, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE,
                              image.rgba.data());
    return {};
}

Result<void> Pictures::checkOfApplication(GLuint texture) {
    const Gl& gl = m_device.gl;
    const auto bind = [&]() -> Result<void> {
        if (Result<void> checked = checkErrors(gl); !checked) // The application's own, from before.
            return checked;
        if (gl.IsTexture(texture) == GL_FALSE)
            return noTexture(texture);
        gl.ActiveTexture(GL_TEXTURE0);
        gl.BindTexture(GL_TEXTURE_2D, texture); // An error where it is of another target.
        return gl.GetError() == GL_NO_ERROR ? Result<void>() : noTexture(texture);
    };
    return checkedUpload(m_device, bind);
}

Result<PictureId> Pictures::addOfApplication(GLuint texture) {
    if (Result<void> checked = checkOfApplication(texture); !checked)
        return checked.error();
    m_pictures.push_back(
        {.id = newHandle<PictureId>(), .source = {}, .isOfApplication = true, .ofApplication = texture});
    return m_pictures.back().id;
}

Result<void> Pictures::setOfApplication(PictureId id, GLuint texture) {
    Picture* const picture = find(id);
    if (picture == nullptr || !picture->isOfApplication)
        return noPicture();
    if (picture->ofApplication == texture)
        return {};
    Result<void> checked = checkOfApplication(texture);
    if (checked)
        picture->ofApplication = texture;
    return checked;
}

// All are marked before the first is uploaded: none is evicted for another.
Result<void> Pictures::prepare(std::span<const OverlayQuad> quads) {
    m_needed.clear();
    for (const OverlayQuad& quad : quads) {
        Picture* const picture =
            !m_needed.empty() && m_needed.back()->id == quad.picture ? m_needed.back() : find(quad.picture);
        if (picture == nullptr || !picture->canBeDrawn())
            return noPicture();
        picture->lastDrawn = m_device.clock;
        if (m_needed.empty() || m_needed.back() != picture)
            m_needed.push_back(picture);
    }
    for (Picture* picture : m_needed)
        if (Result<void> made = makeResident(*picture); !made)
            return made;
    return {};
}

GLuint Pictures::textureOf(PictureId id) const { return find(id)->name(); }

void Pictures::lost() {
    for (Picture& picture : m_pictures) {
        picture.texture = {};
        picture.ofApplication = 0;
    }
}

Result<void> Pictures::restore() {
    const auto hasNoSource = [](const Picture& picture) {
        return !picture.source && !picture.isOfApplication;
    };
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
