// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <tuple>
#include <vector>

#include "gltf/document.h"

namespace franken::gltf {

/// How a node shows its mesh.
struct MeshUse {
    /// Which primitives: those with joints and weights, or those without, of a node that has a skin.
    enum class Part { All, Skinned, Unskinned };

    Part part = Part::All;
    std::size_t joints = 0;           ///< Of its skin; 0 for what none moves.
    std::vector<double> weights = {}; ///< Of morph targets, at rest.
    /// Not <=>: the vectors of clang 14's library have none.
    friend bool operator<(const MeshUse& a, const MeshUse& b) {
        return std::tie(a.part, a.joints, a.weights) < std::tie(b.part, b.joints, b.weights);
    }
};

/// That part of the file's mesh as nothing has moved it yet, with what will (Primitive::deformation). Its
/// primitives' materials are indices into scene.materials, to which a default is added where it is needed; a
/// mesh of which nothing can be drawn comes out without primitives.
bool readMesh(Document& source, int mesh, const MeshUse& use, Scene& scene, Mesh& out);

/// Materials that one primitive can have: its own, and those of variants.
using MaterialChoice = std::vector<const Material*>;

/// Takes out of the primitive what is not read, with a warning where it is faulty, and mends what has only
/// one reading. Fails where something is wrong with an attribute that its materials or its node need.
bool chooseAttributes(Document& source, const MaterialChoice& materials, const MeshUse& use,
                      const std::string& where, tinygltf::Primitive& primitive);

/// Morph targets, of what the primitive has, and joints. Leaves the boxes and Deformation::bind open.
bool readDeformation(Document& source, const tinygltf::Primitive& from, const std::string& where,
                     const MeshUse& use, const Primitive& primitive, Deformation& deformation);

} // namespace franken::gltf
