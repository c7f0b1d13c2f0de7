// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/permutation.h"
#include "franken/gl.h"

#include <optional>

namespace FRANKEN_API franken {

/// Limits and extensions of a context. A default-constructed one has the minimum that OpenGL ES 2.0
/// guarantees.
struct Capabilities {
    int maxTextureSize = 64; ///< Width and height, texels.
    int maxCubeSize = 16;    ///< Of the faces of cube maps, texels.
    /// Repeat and mipmaps for sizes that are no powers of two: GL_OES_texture_npot.
    bool anyTextureSize = false;
    bool wideIndices = false;     ///< 32-bit indices: GL_OES_element_index_uint.
    bool parallelCompile = false; ///< Compilation can be polled: GL_KHR_parallel_shader_compile.
    /// The most that Look::anisotropy may be: GL_EXT_texture_filter_anisotropic; 1 without it, as on
    /// VideoCore IV.
    float maxAnisotropy = 1;
    /// Mesa's vc4 and v3d: an untextured program is recompiled for the textures that are left bound.
    bool compilesForStaleTextures = false;

    /// The float format of fragment shaders, measured by drawing a pixel; Fp32 where the measurement fails.
    /// GL's own answer is not used: Mesa's lima reports 23 bits and GL_FRAGMENT_PRECISION_HIGH, and has 10
    /// bits.
    Precision precision = Precision::Fp32;

    /// The largest palette of joints that programs are given; none where the CPU moves the vertices of skins.
    std::optional<Joints> joints = Joints::UpTo32;

    /// Queries the context, and draws a pixel into a target of its own. Call it once, not in a frame. It
    /// leaves GL's state as it was.
    static Capabilities query(const Gl& gl);
};

} // namespace franken
