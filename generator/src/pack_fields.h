// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/pack.h"

#include <cstddef>
#include <span>
#include <string_view>

namespace franken {

/// Where a uniform's value lies in its block. A '#' in its name stands for the number of a light; `stride` is
/// how far apart two neighbours' values are.
struct PackField {
    Block block;
    std::string_view uniform;
    std::size_t bytes, stride = 0;
};

/// Brings ambient light within what 16-bit floats hold.
void fitToFp16(AmbientBlock& block);

/// Those of ambient light.
std::span<const PackField> ambientFields();

} // namespace franken
