// SPDX-License-Identifier: MIT
#pragma once

#include "franken/overlay.h"
#include "gl_owner.h"
#include "gpu_texture.h"

#include <span>
#include <vector>

namespace franken {

/// The pictures that overlays show, on the GPU or not.
class Pictures final : public GlOwner {
public:
    explicit Pictures(Device& device) : m_device(device) {}

    Result<PictureId> add(const Image& image, PictureSource source);
    void remove(PictureId id);
    /// Renderer::updatePicture()
    Result<void> update(PictureId id, const Image& image, int x, int y);

    /// Renderer::addApplicationTexture(), setApplicationTexture()
    Result<PictureId> addOfApplication(GLuint texture);
    Result<void> setOfApplication(PictureId id, GLuint texture);

    /// Brings all pictures of these quads to the GPU, none at the expense of another.
    Result<void> prepare(std::span<const OverlayQuad> quads);
    /// The texture of a picture that was prepared.
    GLuint textureOf(PictureId id) const;

    void lost() override;
    Result<void> restore() override;
    std::optional<std::uint64_t> oldestUse() const override;
    void evictOldest() override;

private:
    struct Picture {
        PictureId id;
        PictureSource source;        ///< May be empty.
        std::uint64_t lastDrawn = 0; ///< By Device::clock.
        TextureSize size{0, 0};      ///< Before it was scaled to what the GPU takes.
        GpuTexture texture = {};
        bool isOfApplication = false;
        GLuint ofApplication = 0; ///< Never deleted; 0 after the context was lost.

        GLuint name() const { return isOfApplication ? ofApplication : texture.texture.name(); }
        bool canBeDrawn() const { return name() != 0 || source; }
    };

    const Picture* find(PictureId id) const;
    Picture* find(PictureId id) { return const_cast<Picture*>(std::as_const(*this).find(id)); }
    const Picture* oldest() const;
    Result<void> upload(Picture& picture, const Image& image);
    Result<void> makeResident(Picture& picture);
    Result<void> checkOfApplication(GLuint texture);

    Device& m_device;
    std::vector<Picture> m_pictures;
    std::vector<Picture*> m_needed; ///< By the running prepare(); a member, so that frames allocate nothing.
};

} // namespace franken
