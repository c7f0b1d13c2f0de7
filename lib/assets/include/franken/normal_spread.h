// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "franken/api.h"
#include "franken/image.h"

namespace FRANKEN_API franken {

/// How much the normals of a normal map differ within each texel of its smaller mip levels. A level holds
/// their mean direction; how far they lean from it is lost, and a surface that is rough in the small looks
/// smooth from afar: its highlight is too bright, and flickers. What is lost is put into roughness.
///
/// The mean of unit normals that lean from it with the variance v of their slopes, along each axis, has the
/// length r with v = (1 - r) / r (M. Toksvig, "Mipmapping Normal Maps", 2005). A lobe of width alpha
/// (roughness squared) over such normals is about one of alpha'^2 = alpha^2 + kWidening * v.
class NormalSpread {
public:
    /// Normally distributed slopes add 2 v to Beckmann's alpha^2 (M. Olano and D. Baker, "LEAN Mapping",
    /// 2010), and keep it Beckmann's. GGX has far wider tails than they give it: with 2, a metal of roughness
    /// 0.2 on noise of deviation 0.3 reflects a sky at 77 % of its brightness, 13 codes off; with 0.5 at 96 %
    /// and 4 codes off; without any of it 18 codes. Chosen on noise; sparkle_test holds it on other bumps.
    static constexpr float kWidening = 0.5f;

    /// Of a normal map with its pixels, and a material's scale of X and Y. Costs a square root for each
    /// pixel, and for a while 4 bytes for each; a third of that stays.
    NormalSpread(const Image& normals, float scale);

    /// Whether it changes a level: the level is smaller than the normal map.
    bool widens(const Image& level) const { return level.width < m_width || level.height < m_height; }

    /// Widens one level of a roughness texture, of any size, by what its texels cover: of `channel`, which
    /// holds roughness / factor, and stays at most 1. A level that is as large as the normal map stays as it
    /// is.
    void roughen(Image& level, std::size_t channel, float factor) const;

private:
    /// Of the size of a mip level.
    struct Level {
        int width, height;
        std::vector<float> variance; ///< Of slopes.
    };

    int m_width, m_height;
    std::vector<Level> m_levels; ///< From half the size on.
};

} // namespace franken
