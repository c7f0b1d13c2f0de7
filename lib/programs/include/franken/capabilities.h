// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/permutation.h"
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

    /// What fragments compute in, measured by a pixel that is drawn: where that fails, Fp32. Mesa's lima says
    /// 23 bits and GL_FRAGMENT_PRECISION_HIGH, and has 10 bits.
    Precision precision = Precision::Fp32;

    /// Asks the context, and draws a pixel in a target of its own. To be called once, not in a frame: state
    /// is changed afterwards, but not the framebuffer that is bound and the viewport.
    static Capabilities query(const Gl& gl);
};

} // namespace franken
