// SPDX-License-Identifier: MIT
#pragma once

#include "canvas.h"
#include "lathe.h"
#include "profile.h"

namespace make_model {

/// The porcelain of the urn, from the lid to the cup above the foot. 1.3 m high, 1.1 m wide; the foot stands
/// on y = 0 and the lid ends at 1.48 m.

/// The pieces of its profile, from the top down.
enum UrnPiece : std::size_t { kLid, kNeck, kShoulder, kUpperBand, kBelly, kLowerBand, kCup };

/// The texture goes around three times: with two windows in each sector the urn has six.
constexpr Turning kUrnTurning{.sectors = 3, .segments = 42};

/// Flutes of the neck and lobes of the cup, in one sector.
constexpr int kFlutesPerSector = 6;

Profile urnProfile();

/// Glaze, enamel, inlaid gold, and windows of coloured glass with a light behind them.
Surface paintUrn(const Spot& spot);

} // namespace make_model
