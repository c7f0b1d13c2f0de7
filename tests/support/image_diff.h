// SPDX-License-Identifier: MIT
#pragma once

#include "franken/image.h"

#include <array>
#include <cstddef>
#include <functional>
#include <ostream>
#include <string>

namespace franken::test {

/// As the library loads them, row 0 at the top.
using Picture = franken::Image;

/// Whether a pixel counts; x from the left, y from the top.
using Mask = std::function<bool(int x, int y)>;

/// How two pictures of the same size differ, in codes of 0 to 255. Alpha is not looked at.
///
/// Codes are counted instead of asking an image library whether two pictures look alike: such a threshold
/// lets a wrong gamma over the whole picture pass. Its mean is what gives it away.
struct Difference {
    std::size_t pixels = 0;               ///< That the mask let through.
    double mean = 0;                      ///< Of all channels of these pixels.
    double bias = 0;                      ///< Likewise, but signed: actual minus expected.
    std::array<std::size_t, 256> worst{}; ///< By code: pixels whose worst channel is off by as much.

    int max() const;
    double shareAbove(int codes) const; ///< Of the pixels; 0 to 1.
};

std::ostream& operator<<(std::ostream& out, const Difference& difference);

/// The pictures must have the same size.
Difference compare(const Picture& actual, const Picture& expected, const Mask& mask);

/// Every pixel that is not black in one of them.
Difference compareLit(const Picture& actual, const Picture& expected);

/// Writes NAME.actual.png, NAME.expected.png and NAME.diff.png (differences times 16; mid grey is none) to
/// the folder `diffs` of the build tree, and says so: for the message of a test that fails.
std::string writeDifference(const std::string& name, const Picture& actual, const Picture& expected);

} // namespace franken::test
