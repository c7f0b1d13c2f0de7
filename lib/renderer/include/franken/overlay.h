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

/// Loads a picture again that was lost with the context or evicted; see SceneSource. Called from drawOverlay().
using PictureSource = std::function<Result<Image>()>;

/// Right and down from the upper left corner.
struct OverlayRect {
    float x = 0, y = 0;
    float width = 0, height = 0;
};

/// One rectangle. Those of one picture that follow each other are one draw: a text is a list of rectangles
/// that show parts of one picture of all its letters.
struct OverlayQuad {
    PictureId picture{};
    OverlayRect place;            ///< Pixels of the target.
    OverlayRect part{0, 0, 1, 1}; ///< Of the picture: 0-1.
    /// Multiplies the picture, alpha too; 0-1. The picture's codes, as an image program's layers do, where
    /// the shader encodes; its linear light, decoded, on a target that encodes by itself (Output::Linear).
    Float4 color{1, 1, 1, 1};
};

/// The program that overlays need, for Renderer::warmUp(). Fails with "permutation.range" for a look that does not
/// exist.
Result<ProgramUse> overlayUse(const Look& look);

} // namespace franken
