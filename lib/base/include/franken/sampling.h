// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"

namespace FRANKEN_API franken {

/// How texture coordinates outside 0-1 are mapped.
enum class Wrap { Repeat, ClampToEdge, MirroredRepeat };

/// How texels, and for minification mip levels, are filtered.
enum class Filter {
    Nearest,
    Linear,
    NearestMipmapNearest,
    LinearMipmapNearest,
    NearestMipmapLinear,
    LinearMipmapLinear,
};

/// Of a minifying filter: whether it reads smaller levels.
inline bool usesMipmaps(Filter filter) { return filter != Filter::Nearest && filter != Filter::Linear; }

} // namespace franken
