// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/pack.h"
#include "franken/rotation.h"

#include <array>
#include <optional>

namespace FRANKEN_API franken {

/// A rectangle of a framebuffer, in its pixels, from its lower left corner as GL counts them.
struct TargetArea {
    /// Pixels.
    int x = 0, y = 0;
    int width = 0, height = 0;
};

/// What a frame erases before it draws. What it does not erase is drawn over.
enum class Clear { ColorAndDepth, Depth, Nothing };

/// Where a picture goes, and what becomes of what is there. All of it may change from frame to frame, at no
/// cost but this: a GPU that draws in tiles (vc4, v3d) reads the whole target back before a frame that clears
/// an area of it, or nothing.
struct DrawTarget {
    unsigned framebuffer = 0;            ///< A GL name; with a depth buffer.
    int width = 0, height = 0;           ///< Of the framebuffer, pixels.
    Float3 background{0, 0, 0};          ///< As it is written: encoded unless the target encodes, 0-1.
    std::array<int, 3> bits = {8, 8, 8}; ///< Of each colour channel: what dithering goes by.

    /// Draws there and nowhere else: for split views, and for stereo (one area for each eye).
    std::optional<TargetArea> area = {};
    Clear clear = Clear::ColorAndDepth;
    /// Of the background, 0-1; below 1, for what is shown below the target (video), `background` is
    /// premultiplied with it. Surfaces write 1, blended ones what covers.
    float backgroundAlpha = 1;
    /// How the panel is mounted: scene, skybox and overlays are turned in it, so that its viewer sees them
    /// upright. Viewpoints and overlays are for what he sees: see aspectOf().
    Rotation rotation = Rotation::None;
};

/// The area that is drawn to: all of the target unless it says otherwise.
TargetArea areaOf(const DrawTarget& target);

/// Width over height of the picture as its viewer sees it.
double aspectOf(const DrawTarget& target);

} // namespace franken
