// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/gl.h"
#include "franken/sampling.h"

namespace FRANKEN_API franken {

/// Sets wraps and filters of the texture that is bound to `target` (GL_TEXTURE_2D or GL_TEXTURE_CUBE_MAP) of
/// the active unit. `magFilter` is Filter::Nearest or Filter::Linear.
void setSampling(const Gl& gl, GLenum target, Wrap wrapS, Wrap wrapT, Filter magFilter, Filter minFilter);

} // namespace franken
