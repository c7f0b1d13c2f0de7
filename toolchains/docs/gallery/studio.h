// SPDX-License-Identifier: MIT
#pragma once

#include "franken/baked_sky.h"
#include "franken/program_cache.h"
#include "subject.h"

namespace franken::gallery {

/// What a picture needs besides its program.
struct Scenery {
    bool open = false;    ///< The sphere has a hole, through which its inner side is seen.
    bool striped = false; ///< The background has stripes, which are seen through the sphere.
    bool coarse = false;  ///< As a screen of 3 bits a channel shows it.
};

/// Draws any program of the library with everything that it can read: a sphere with its textures, four suns,
/// four punctual lights, a sky, a bent skeleton. GL objects end with the context, which must be current.
class Studio {
public:
    static constexpr int kSize = 192; ///< Of a picture, pixels.

    /// Makes all textures; the table must outlive the studio.
    Studio(const Gl& gl, GLuint framebuffer);

    /// The picture. Fails as ProgramCache::get() does, and with "gallery.gl" where GL reports an error.
    Result<Image> draw(const Permutation& permutation, const Scenery& scenery);

private:
    void clear(const Scenery& scenery) const;
    void bindTextures(const Permutation& permutation) const;
    void feed(ShaderProgram& program, const Permutation& permutation) const;
    void drawMesh(const Mesh& mesh, unsigned attributes) const;
    Image readBack(bool coarse) const;

    const Gl& m_gl;
    GLuint m_framebuffer;
    ProgramCache m_cache;
    BakedSky m_sky;
    std::array<GLuint, std::size(roles::kRows)> m_textures{}; ///< By role.
};

} // namespace franken::gallery
