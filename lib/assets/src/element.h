// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

namespace franken {

/// The place of an element, as errors name it: "meshes[2]".
inline std::string elementOf(const std::string& array, std::size_t index) {
    return array + "[" + std::to_string(index) + "]";
}

} // namespace franken
