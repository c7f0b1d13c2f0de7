// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_double4.hpp>

namespace price {

/// The edge of a tile of VideoCore IV, VI and VII: a target of 32 bits a pixel without multisampling
/// (Broadcom, VideoCore IV 3D Architecture Reference Guide, 2013, "Tile Binning Mode Configuration").
inline constexpr int kTile = 64;

/// Pixels that a fragment shader runs for, and the blocks of 2x2 that they lie in: a QPU shades whole blocks.
struct Shaded {
    std::size_t pixels = 0, quads = 0;

    Shaded& operator+=(const Shaded& other) {
        pixels += other.pixels;
        quads += other.quads;
        return *this;
    }
};

/// Which sides of a triangle are drawn. Front faces are counter-clockwise.
enum class Faces { Front, Back, Both };

/// What a triangle leaves behind where it is drawn.
enum class Hides {
    Behind,  ///< Its depth, before it is shaded.
    Nothing, ///< No depth (blended), or none early enough (pixels of it may be discarded).
};

/// What one triangle costs.
struct Footprint {
    Shaded shaded;   ///< Not hidden by what was drawn before.
    Shaded covered;  ///< All of it: what is shaded where no depth is tested early.
    double area = 0; ///< On the screen, after clipping, pixels.
};

/// Counts the pixels that are shaded, by GL's rules: pixels whose centre is inside (of a common edge, one
/// triangle has it), near and far clipping planes, LEQUAL on a depth of 24 bits, corners at 1/256 pixel.
/// Draws nothing.
class Raster {
public:
    /// 1 to 16384 pixels each.
    Raster(int width, int height);

    /// Corners in clip space, before the division. Those of one triangle after the other, in order of
    /// drawing.
    Footprint draw(const std::array<glm::dvec4, 3>& corners, Faces faces, Hides hides);

    /// What fills the target behind everything, as a skybox does.
    Shaded drawBackground();

    /// The tiles that the last triangle reaches, by number, row by row; valid until the next one.
    std::span<const int> tiles() const { return m_tiles; }

private:
    struct Window { ///< Corners in the window: x and y in 1/256 pixel, depth 0 to 1.
        std::array<std::int64_t, 2> a, b, c;
        glm::dvec4 depth; ///< Of the corners.
    };
    void drawWindow(const Window& triangle, Hides hides, Footprint& footprint);
    void addTiles(const Window& triangle);

    int m_width, m_height;
    std::vector<std::uint32_t> m_depth; ///< What is known early, 24 bits.
    std::vector<int> m_tiles;
};

} // namespace price
