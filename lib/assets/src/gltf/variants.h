// SPDX-License-Identifier: MIT
#pragma once

#include "gltf/document.h"

// KHR_materials_variants.
namespace franken::gltf {

/// The names, in the file's order. One that another bears already is told apart by a number.
void readVariants(Document& source, Scene& scene);

/// Primitive::variantMaterials. A mapping that points at nothing is left out, with a warning. Fails where it
/// would be too much.
bool readVariantMaterials(Document& source, const tinygltf::Primitive& from, const std::string& where,
                          std::size_t variants, std::vector<int>& materials);

/// All materials that the primitive can have; indices into the file's array.
std::vector<int> possibleMaterials(const tinygltf::Primitive& from, std::size_t materials);

} // namespace franken::gltf
