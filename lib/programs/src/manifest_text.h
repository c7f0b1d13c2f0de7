// SPDX-License-Identifier: MIT
#pragma once

#include "franken/manifest.h"

namespace franken {

/// The lines of these programs alone, for a list that someone wrote by hand.
std::string manifestLinesOf(std::span<const ProgramUse> uses);

} // namespace franken
