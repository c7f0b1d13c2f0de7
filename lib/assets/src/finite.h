// SPDX-License-Identifier: MIT
#pragma once

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace franken {

template<typename Numbers>
bool areFinite(const Numbers& numbers) {
    return std::all_of(std::begin(numbers), std::end(numbers),
                       [](auto number) { return std::isfinite(number); });
}

/// Of a vector, a matrix or a quaternion of GLM.
template<typename Vector>
bool isFinite(const Vector& vector) {
    const auto* const first = glm::value_ptr(vector);
    return std::all_of(first, first + sizeof(vector) / sizeof(*first),
                       [](auto number) { return std::isfinite(number); });
}

} // namespace franken
