// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/compose.h"

#include <string>

namespace franken::cli {

/// The program as a file that piglit's shader_runner and shader-db's run understand: both stages, and a test
/// that they link.
std::string toShaderTest(const Composed& program);

} // namespace franken::cli
