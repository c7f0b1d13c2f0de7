// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "franken/sampling.h"

namespace franken {

/// The texel that a sampler reads for one beyond the edge: 0 to size - 1.
inline int wrapped(int texel, int size, Wrap wrap) {
    const auto modulo = [texel](int period) { return (texel % period + period) % period; };
    switch (wrap) {
    case Wrap::Repeat:
        return modulo(size);
    case Wrap::MirroredRepeat:
        return std::min(modulo(2 * size), 2 * size - 1 - modulo(2 * size));
    case Wrap::ClampToEdge:
        break;
    }
    return std::clamp(texel, 0, size - 1);
}

} // namespace franken
