// SPDX-License-Identifier: MIT
#pragma once

#include "franken/draw_target.h"
#include "franken/gl.h"
#include "franken/image.h"
#include "franken/result.h"

namespace franken {

/// Renderer::readPixels(). Leaves the target's framebuffer bound.
Result<Image> readPixels(const Gl& gl, const DrawTarget& target);

} // namespace franken
