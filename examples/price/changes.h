// SPDX-License-Identifier: MIT
#pragma once

#include "frame_bill.h"

namespace price {

/// A cheaper form of a frame.
struct Offer {
    std::string words; ///< An option of the viewer's, or what to do.
    Terms terms;
};

/// What can be left out or made simpler of these terms, one thing at a time, whether it brings anything or
/// not.
std::vector<Offer> offersFor(const Terms& terms);

} // namespace price
