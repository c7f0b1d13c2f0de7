// SPDX-License-Identifier: MIT
#pragma once

#include "canvas.h"
#include "lathe.h"
#include "profile.h"

namespace make_model {

/// The round stone plinth: its top is at y = 0, its underside at -0.345 m, its greatest radius 0.60 m. The
/// middle of the top, which the urn's foot hides, is left open.

constexpr Turning kPlinthTurning{.sectors = 4, .segments = 22};

Profile plinthProfile();

/// Veined stone, and a Greek key around the drum, engraved and filled with teal paint.
Surface paintPlinth(const Spot& spot);

} // namespace make_model
