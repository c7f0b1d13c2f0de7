// SPDX-License-Identifier: MIT
#pragma once

#include "qpu_compiler.h"

#include <string>

namespace franken::cli {

/// What got worse from one cost of a program to another, or nothing: instructions of a shader by more than 3
/// %, which is scheduling; threads lost; more spills; no figures any more. One line.
std::string dearer(const Cost& before, const Cost& after);

} // namespace franken::cli
