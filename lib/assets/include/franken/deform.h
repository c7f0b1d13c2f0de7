// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glm/mat4x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "franken/api.h"
#include "franken/box.h"
#include "franken/index.h"

/// Skins and morph targets: glTF 2.0, 3.7.2.2 (morph targets) and 3.7.3 (skins). Targets first, then the
/// skin. pose.h does this for whole scenes.
namespace FRANKEN_API franken {

struct Primitive;

/// What a pose can change of vertices, as one array for each attribute; each is empty, or has an element for
/// each vertex. A primitive says what its members are.
struct Vertices {
    /// Each is empty, or has an entry for each vertex.
    std::vector<glm::vec3> positions = {};
    std::vector<glm::vec3> normals = {};
    std::vector<glm::vec4> tangents = {};
    std::vector<glm::vec2> uv[2] = {};
    std::vector<glm::vec4> colors = {};
};

/// How much a joint moves a vertex.
struct Influence {
    std::uint32_t joint = 0; ///< Index into Skin::joints, below 65,536.
    float weight = 0; ///< 0 or more; those of a vertex add up to 1, and are 0 where it has fewer than others.
};

/// The joints of a skinned mesh.
struct Skin {
    std::string name = {};        ///< As in the file; not unique.
    int index = kNone;            ///< In the file's array of skins.
    std::vector<int> joints = {}; ///< Indices into Scene::nodes; at least one.
    /// From the mesh to each joint, as they were when the skin was bound; as many as `joints`.
    std::vector<glm::mat4> inverseBinds = {};
};

/// How the vertices of a primitive move: what they are before anything moves them, and what moves them.
struct Deformation {
    Vertices bind; ///< Texture coordinates and colours only where a target changes them.
    /// Differences, which are added to `bind` times the target's weight. An array that is empty changes
    /// nothing; w of a tangent is 0.
    std::vector<Vertices> targets = {};
    std::size_t influencesPerVertex = 0; ///< Any number; 0 without a skin.
    /// influencesPerVertex of each vertex, one vertex after the other.
    std::vector<Influence> influences = {};
    /// The file has no normals: three vertices for each triangle, and normals that are those of the moved
    /// triangles.
    bool flat = false;

    // For bounds without a look at the vertices; measure() fills them in.
    Box box = {};                      ///< Of bind.positions.
    std::vector<Box> jointBoxes = {};  ///< By joint: of the vertices that it moves; empty for none.
    std::vector<Box> targetBoxes = {}; ///< By target: of its differences and 0.
};

/// Fills in the boxes of a deformation whose other members are as they stay.
void measure(Deformation& deformation);

/// A pose as one primitive sees it.
struct Deforming {
    std::span<const float> weights = {};      ///< Of targets; those that are left out are 0.
    std::span<const glm::mat4x3> joints = {}; ///< From `bind` to where the vertices come out.
    bool mirrored = false;                    ///< Instance::mirrored; turns flat normals of a skin round.
};

/// The vertices in that pose. `out` gets positions, normals and tangents, and what targets change besides;
/// other arrays are emptied. Normals and tangents come out in unit length: normals by the inverse transpose
/// of the blended matrix, tangents by the matrix. Pure: any thread, no allocation where `out` was used for
/// the same primitive before. Every joint of `influences` must be in `pose.joints`, unless that is empty:
/// then only targets move vertices. Takes 13 ns for a vertex with a normal and four joints on a desktop's
/// core, 4 ns with one target in their place.
void deform(const Deformation& deformation, const Deforming& pose, Vertices& out);

/// Gives the primitive's arrays and bounds that pose, for good; does nothing where it has no deformation.
void deform(Primitive& primitive, const Deforming& pose);

/// A box that holds all vertices in that pose; seldom much larger than need be, and found without them.
Box boundsOf(const Deformation& deformation, const Deforming& pose);

} // namespace franken
