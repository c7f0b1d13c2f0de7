// SPDX-License-Identifier: MIT
#pragma once

#include "priced.h"

namespace franken::cli {

/// What the same permutations cost on one of several GPUs.
struct Bill {
    Gpu gpu;
    std::vector<Priced> priced;
};

/// One document, ended by a newline; see json.h.
std::string costJson(const std::vector<Bill>& bills);

} // namespace franken::cli
