// SPDX-License-Identifier: MIT
#pragma once

#include "support/gltf_builder.h"

#include <glm/ext/vector_double3.hpp>

#include <cstddef>
#include <string>
#include <vector>

/// Skins as exporters write them and a loader may get them wrong, each in a small file, with where its
/// vertices are: worked out in double from the numbers that the file was made of, by glTF 2.0, 3.7.3, and by
/// no code of the library's.

/// Where a vertex is in the world.
struct ExpectedVertex {
    int node;           ///< In the file.
    bool skinned;       ///< Of a primitive that joints move.
    std::size_t vertex; ///< Of that primitive.
    glm::dvec3 atRest;  ///< As the file has it.
    glm::dvec3 turned;  ///< With OddSkin::turned turned.
};

/// About +Z, radians, in place of the rotation that the node has in the file.
inline constexpr double kTurn = 0.9;

/// A file, and what is expected of it.
struct OddSkin {
    std::string name;                          ///< For messages.
    GltfBuilder file = {};                     ///< In which nothing is animated.
    int turned = 0;                            ///< A node of the file: a joint.
    std::string warning = {};                  ///< A part of it; empty for none.
    std::vector<ExpectedVertex> expected = {}; ///< Of each node that shows something, and each vertex.
};

/// All of them.
std::vector<OddSkin> oddSkins();

/// A file whose vertex names a joint that its skin does not have, with that weight.
GltfBuilder skinWithAJointTooMany(float weight);
