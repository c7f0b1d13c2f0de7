// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/gl.h"

namespace FRANKEN_API franken {

/// What a context can do beyond what every GLES2 context can. A default-constructed one is the least that
/// OpenGL ES 2.0 promises.
struct Capabilities {
    int maxTextureSize = 64; ///< Width and height, texels.
    int maxCubeSize = 16;    ///< Of the faces of cube maps, texels.
    /// Repeat and mipmaps for sizes that are no powers of two: GL_OES_texture_npot.
    bool anyTextureSize = false;
    bool wideIndices = false;     ///< 32-bit indices: GL_OES_element_index_uint.
    bool parallelCompile = false; ///< It tells whether it is still compiling: GL_KHR_parallel_shader_compile.
    bool compilesForStaleTextures = false; ///< Mesa's vc4 and v3d: see texture_reset.h.

    /// Asks the context. To be called once, not in a frame.
    static Capabilities query(const Gl& gl);
};

} // namespace franken
