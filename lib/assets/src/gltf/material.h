// SPDX-License-Identifier: MIT
#pragma once

#include "gltf/document.h"

namespace franken::gltf {

/// Decodes the images that are `used`; warns of those that cannot be decoded and marks them as `broken`.
/// These and the unused ones come out as one white pixel. Fails where a buffer that holds one is missing.
bool readImages(Document& source, const std::vector<bool>& used, std::vector<bool>& broken,
                std::vector<Image>& images);

/// Fills materials, textures and images. Of the materials that are not `used`, a default one stands in for
/// each.
bool readMaterials(Document& source, const std::vector<bool>& used, Scene& scene);

} // namespace franken::gltf
