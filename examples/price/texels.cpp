// SPDX-License-Identifier: MIT
#include "texels.h"

#include <algorithm>
#include <cmath>

using namespace franken;

namespace price {
namespace {

bool mixesLevels(Filter filter) {
    return filter == Filter::LinearMipmapLinear || filter == Filter::NearestMipmapLinear;
}

} // namespace

double texelsPerPixel(double density, Filter filter) {
    if (density <= 1)
        return density;
    if (!usesMipmaps(filter))
        return std::min(density, kLineTexels);
    const double level = 0.5 * std::log2(density); // Each level has a quarter of the texels.
    if (!mixesLevels(filter))
        return density / std::pow(4.0, std::round(level));
    const double sharper = density / std::pow(4.0, std::floor(level));
    return sharper + sharper / 4;
}

int lookupsOf(Filter filter) { return mixesLevels(filter) ? 2 : 1; }

} // namespace price
