// SPDX-License-Identifier: MIT
#include "franken/variants.h"

#include <algorithm>

namespace franken {

Result<void> applyVariant(Scene& scene, std::string_view name) {
    const auto found = std::find(scene.variants.begin(), scene.variants.end(), name);
    if (found == scene.variants.end()) {
        std::string known;
        for (const std::string& variant : scene.variants)
            known += (known.empty() ? "" : ", ") + variant;
        return Error{"scene.variant", std::string(name), "the scene has no such variant",
                     known.empty() ? "it has none" : "it has " + known};
    }
    const auto variant = static_cast<std::size_t>(found - scene.variants.begin());
    for (Mesh& mesh : scene.meshes)
        for (Primitive& primitive : mesh.primitives)
            if (variant < primitive.variantMaterials.size() && primitive.variantMaterials[variant] != kNone)
                primitive.material = primitive.variantMaterials[variant];
    return {};
}

} // namespace franken
