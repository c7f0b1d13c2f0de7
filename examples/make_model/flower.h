// SPDX-License-Identifier: MIT
#pragma once

#include "model.h"

namespace make_model {

/// The model that moves: a sunflower in a clay pot, 1.7 m high, that turns after the sun. Its stem, leaves
/// and head are one skin of 16 joints; its blossom opens and closes by two morph targets. The animation "day"
/// takes 8 seconds from midnight to midnight, and ends as it begins; a sun, as a light, goes along. It has a
/// camera, and no images.
Model makeFlower();

} // namespace make_model
