// SPDX-License-Identifier: MIT
#include "urn.h"

namespace make_model {

Profile urnProfile() {
    constexpr int kFlutes = kFlutesPerSector * kUrnTurning.sectors;
    const Piece lid{{{{{0.050, 1.482}, {0.150, 1.475}, {0.235, 1.430}, {0.262, 1.345}}}}, 7, {}};
    const Piece neck{
        {{{{0.215, 1.310}, {0.183, 1.250}, {0.183, 1.200}, {0.215, 1.145}}}}, 8, {kFlutes, 0.05}};
    const Piece shoulder{{{{{0.220, 1.118}, {0.360, 1.100}, {0.500, 1.000}, {0.535, 0.860}}}}, 9, {}};
    const Piece upperBand{{{{{0.535, 0.860}, {0.540, 0.840}, {0.547, 0.820}, {0.545, 0.800}}}}, 2, {}};
    const Piece belly{{{{{0.545, 0.800}, {0.533, 0.680}, {0.490, 0.560}, {0.425, 0.470}}}}, 8, {}};
    const Piece lowerBand{{{{{0.425, 0.470}, {0.414, 0.455}, {0.402, 0.441}, {0.390, 0.425}}}}, 2, {}};
    const Piece cup{
        {{{{0.390, 0.425}, {0.310, 0.320}, {0.160, 0.270}, {0.105, 0.200}}}}, 12, {kFlutes, 0.07}};
    return Profile({lid, neck, shoulder, upperBand, belly, lowerBand, cup});
}

} // namespace make_model
