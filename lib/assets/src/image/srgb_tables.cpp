// SPDX-License-Identifier: MIT
#include "image/srgb_tables.h"

#include <algorithm>
#include <cmath>

namespace franken {

const SrgbTables& SrgbTables::get() {
    static const SrgbTables tables;
    return tables;
}

SrgbTables::SrgbTables() {
    for (std::size_t i = 0; i < m_light.size(); ++i) {
        const double c = static_cast<double>(i) / 255;
        m_light[i] = static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
    }
    for (std::size_t i = 0; i < m_code.size(); ++i) {
        const double l = static_cast<double>(i) / kSteps;
        const double c = l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055;
        m_code[i] = static_cast<std::uint8_t>(std::lround(255 * c));
    }
}

std::uint8_t SrgbTables::codeOf(float light) const {
    return m_code[static_cast<std::size_t>(std::lround(std::min(light, 1.0f) * kSteps))];
}

} // namespace franken
