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
        GpuTexture texture = {};
    };

    const Picture* find(PictureId id) const;
    Picture* find(PictureId id) { return const_cast<Picture*>(std::as_const(*this).find(id)); }
    const Picture* oldest() const;
    Result<void> upload(Picture& picture, const Image& image);
    Result<void> makeResident(Picture& picture);

    Device& m_device;
    std::vector<Picture> m_pictures;
};

} // namespace franken
