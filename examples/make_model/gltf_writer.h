// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include <franken/result.h>

#include "model.h"

namespace make_model {

/// Writes a model as glTF 2.0.
///
/// "urn.glb" is one file with everything inside. Any other name is the JSON text, beside which stand the
/// vertices ("urn.bin" for "urn.gltf") and the images ("urn_<image>.png"). Existing files are replaced.
///
/// How the data lies there: one buffer; for each mesh a view of interleaved vertices, so that a vertex is one
/// stretch of memory for the GPU, and a view of indices; every view starts at a multiple of 4 bytes.
/// Positions carry their bounds. Values that glTF defaults to are not written.
///
/// Fails with "model.write" where a file cannot be written.
franken::Result<void> writeGltf(const Model& model, const std::filesystem::path& path);

} // namespace make_model
