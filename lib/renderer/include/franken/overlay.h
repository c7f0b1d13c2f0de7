// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/draw_state.h"
#include "franken/generator/pack.h"
#include "franken/image.h"
#include "franken/material.h"
#include "franken/result.h"

#include <functional>

/// Text and pictures on top of a frame: textured rectangles. See Renderer::addPicture() and drawOverlay().
namespace FRANKEN_API franken {

/// A picture that a renderer holds for overlays; no other handle of the process has its value.
enum class PictureId : unsigned {};

/// Loads a picture again after it was evicted or lost with the context; see SceneSource. Called from
/// drawOverlay().
using PictureSource = std::function<Result<Image>()>;

/// A rectangle; x to the right and y down from the upper left corner.
struct OverlayRect {
    /// Pixels, or shares of a picture: the member says which.
    float x = 0, y = 0;
    float width = 0, height = 0;
};

/// One rectangle. Consecutive rectangles of the same picture are one draw call: a text is a list of
/// rectangles that show parts of one picture of all letters.
struct OverlayQuad {
    PictureId picture{};          ///< Of addPicture() or addApplicationTexture().
    OverlayRect place;            ///< Position on the target's area, as its viewer sees it; pixels.
    OverlayRect part{0, 0, 1, 1}; ///< Part of the picture, 0-1.
    /// Multiplies the picture, alpha included; 0-1. Where the shader encodes, the picture's 8-bit values are
    /// multiplied, as in an image editor's layers; on a target that encodes by itself (Output::Linear), its
    /// decoded, linear values.
    Float4 color{1, 1, 1, 1};
};

/// The program that overlays need, for Renderer::warmUp(). Fails with "permutation.range" where a member of
/// the look has no value of its enumeration.
Result<ProgramUse> overlayUse(const Look& look);

} // namespace franken
