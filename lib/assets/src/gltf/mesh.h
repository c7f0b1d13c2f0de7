// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <glm/mat4x4.hpp>

#include "gltf/document.h"

namespace franken::gltf {

/// How a node bends its mesh: morph weights, and for a skin what moves a vertex from the mesh into the world.
struct Pose {
    std::vector<double> weights;
    std::vector<glm::mat4> joints; ///< jointWorld * inverseBindMatrix; empty without a skin.
    /// Of a skin: the node's determinant is negative, so that front faces wind clockwise.
    bool mirrored = false;
};

/// The file's mesh in the given pose. Its primitives' materials are indices into scene.materials, to which a
/// default is added where it is needed; a mesh of which nothing can be drawn comes out without primitives.
bool readMesh(Document& source, int mesh, const Pose& pose, Scene& scene, Mesh& out);

/// Materials that one primitive can have: its own, and those of variants.
using MaterialChoice = std::vector<const Material*>;

/// Takes out of the primitive what is not read, with a warning where it is faulty, and mends what has only
/// one reading. Fails where something is wrong with an attribute that its materials or its pose need.
bool chooseAttributes(Document& source, const MaterialChoice& materials, const Pose& pose,
                      const std::string& where, tinygltf::Primitive& primitive);

/// Adds the weighted morph targets to positions, and to normals and tangents where the primitive has them.
bool applyMorph(Document& source, const tinygltf::Primitive& from, const std::string& where,
                const std::vector<double>& weights, Primitive& primitive);
/// Moves positions, normals and tangents by the weighted joints of JOINTS_0 and WEIGHTS_0.
bool applySkin(Document& source, const tinygltf::Primitive& from, const std::string& where,
               const std::vector<glm::mat4>& joints, Primitive& primitive);

} // namespace franken::gltf
