// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "franken/api.h"

namespace FRANKEN_API franken {

/// The index of a thing that is absent.
inline constexpr int kNone = -1;

/// Whether a number is an index into an array of that size.
constexpr bool isIndex(int index, std::size_t size) {
    return index >= 0 && static_cast<std::size_t>(index) < size;
}

} // namespace franken
