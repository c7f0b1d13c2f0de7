// SPDX-License-Identifier: MIT
#pragma once

#include "model.h"

namespace make_model {

/// The gilt mounts of the urn: smooth metal that needs no texture. Their vertex colours darken towards the
/// grooves between mouldings, where gilding wears down to dark bronze.

/// Finial, rim of the lid, collar of the neck, knot and foot, in the urn's coordinates.
Mesh turnMounts();

/// One handle, for the side of +X, in the urn's coordinates; the other one is the same, half a turn around.
Mesh bendHandle();

} // namespace make_model
