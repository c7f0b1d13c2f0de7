// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "gltf/internal.h"

namespace franken::gltf {

using Json = nlohmann::json;

/// Checks that all members that the loader reads are there where glTF requires them, and have the type, the
/// range and the array length that glTF gives them. All others are removed from `root`, extras, animations
/// and unknown extensions among them, so that tinygltf sees nothing that was not checked, and never drops
/// anything in silence. Recursion is bounded by the depth of the schema, not of the file.
bool checkSchema(Source& source, Json& root);

} // namespace franken::gltf
