// SPDX-License-Identifier: MIT
#pragma once

// The one place that includes tinygltf: its Model is what the readers hand to each other, and a copy of it in
// types of our own would only double it.
#include <array>

#include <tiny_gltf.h>

#include "gltf/gate.h"

namespace franken::gltf {

/// What the tables of textures' roles and of factors name of a material.
struct MaterialValues {
    std::array<Json, kMaterialRoles> textures; ///< By TextureRole, the glTF textureInfo; null for none.
    /// By row of kMaterialFactors; empty for none.
    std::array<std::vector<double>, std::size(kMaterialFactors)> factors;

    const Json& operator[](TextureRole role) const { return textures[static_cast<std::size_t>(role)]; }
};

/// A file that has passed the gate.
struct Document : Source {
    tinygltf::Model model;                    ///< Its own buffers and images are empty shells.
    Json animations = Json::array();          ///< Which tinygltf does not see.
    std::vector<MaterialValues> materials;    ///< By material
    std::vector<std::size_t> accessorStrides; ///< By accessor; from validateData().

    bool uses(std::string_view extension) const;
};

/// Takes names, URIs, what materials hold and strides out of the checked JSON, and has tinygltf fill
/// Document::model from the rest.
bool parseModel(Document& source, Json& root);

// What has to hold for the model. After these two, every index in it is in range, and every accessor lies
// inside its buffer or has a deferred fault. Only the contents of the buffers are still unknown.
bool validateData(Document& source);
bool validateTree(Document& source);

} // namespace franken::gltf
