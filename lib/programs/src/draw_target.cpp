// SPDX-License-Identifier: MIT
#include "franken/draw_target.h"

namespace franken {

TargetArea areaOf(const DrawTarget& target) {
    return target.area.value_or(TargetArea{0, 0, target.width, target.height});
}

double aspectOf(const DrawTarget& target) {
    const TargetArea area = areaOf(target);
    const double aspect = static_cast<double>(area.width) / area.height;
    return swapsAxes(target.rotation) ? 1 / aspect : aspect;
}

} // namespace franken
