// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace franken {

/// The sRGB curve (IEC 61966-2-1) of 8-bit codes, both ways. Each code comes back as it was.
class SrgbTables {
public:
    /// Made once; safe on any thread.
    static const SrgbTables& get();

    /// Linear light, 0 to 1.
    float lightOf(std::uint8_t code) const { return m_light[code]; }

    /// The nearest code, to an eighth of a code where the curve is steepest. light: 0 and up; 1 is white.
    std::uint8_t codeOf(float light) const;

private:
    SrgbTables();

    static constexpr std::size_t kSteps = 16'384; ///< A quarter of a code apart where the curve is steepest.
    std::array<float, 256> m_light;
    std::array<std::uint8_t, kSteps + 1> m_code;
};

} // namespace franken
