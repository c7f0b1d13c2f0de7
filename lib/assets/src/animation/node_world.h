// SPDX-License-Identifier: MIT
#pragma once

#include "franken/pose.h"

namespace franken {

/// Where a node is in the world that is at `local` in its parent.
NodeWorld below(const NodeWorld& parent, const NodeWorld& local);

/// Puts a light where that matrix has its node.
void place(const glm::dmat4& world, Light& light);

} // namespace franken
