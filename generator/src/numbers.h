// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/light.h"

#include <algorithm>
#include <cmath>
#include <string_view>

/// Small arithmetic on what applications give, and what may be asked of it.
namespace franken {

inline Float3 scaled(const Float3& v, float factor) { return {v[0] * factor, v[1] * factor, v[2] * factor}; }

inline float dot(const Float3& a, const Float3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline Float3 unit(const Float3& v) {
    const float length2 = dot(v, v);
    return length2 > 0 ? scaled(v, 1 / std::sqrt(length2)) : v;
}

/// The most radiance that programs of 16-bit floats sum up.
inline constexpr float kMostRadianceFp16 = 4096;

inline void limit(Float3& color, float most) {
    for (float& channel : color)
        channel = std::clamp(channel, -most, most);
}

template<typename Values>
bool areFinite(const Values& values) {
    return std::all_of(values.begin(), values.end(), [](auto value) { return std::isfinite(value); });
}

inline constexpr std::string_view kAmountRule = "it must be finite, and 0 or more";

inline bool isAmount(float value) { return std::isfinite(value) && value >= 0; }
inline bool isAmount(const Float3& color) {
    return std::all_of(color.begin(), color.end(), [](float value) { return isAmount(value); });
}

} // namespace franken
