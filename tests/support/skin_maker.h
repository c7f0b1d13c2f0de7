// SPDX-License-Identifier: MIT
#pragma once

#include "support/odd_skins.h"

#include <glm/ext/matrix_double4x4.hpp>
#include <glm/vec3.hpp>

/// What odd_skins.cpp makes its files of.

/// How joints and weights are stored.
struct Form {
    int joints = GltfBuilder::kUByte;
    int weights = GltfBuilder::kFloat; ///< Integers are normalized.
};

struct Pull {
    int joint;     ///< Index into the skin's joints.
    double weight; ///< As stored: any sum.
};

/// A band of triangles along +Y, from 0 to 2, with the joints of each vertex.
struct Band {
    std::vector<glm::vec3> positions = {};
    std::vector<std::vector<Pull>> pulls = {}; ///< By vertex; as many for each.
};

/// Of so many joints that stand along the band, each vertex is pulled by the nearest `each`, by distance;
/// what is stored adds up to `sum`.
Band bandOf(int joints, int each, double sum = 1);

/// A primitive of triangles that face +Z, without joints.
GltfBuilder::Json bareBand(GltfBuilder& file, const Band& band);

/// A skin of a file in the making.
struct Rig {
    std::vector<int> joints = {};              ///< Nodes.
    std::vector<glm::dmat4> inverseBinds = {}; ///< As stored, or identities where the file has none.
};

/// The inverse bind matrices of a skin, as a file has them; the accessor.
int storeBinds(GltfBuilder& file, const Rig& rig);

/// Makes one file: node 0 shows a band, nodes 1 to `joints` are a chain of joints along it.
class SkinMaker {
public:
    SkinMaker(const char* name, int joints, bool storesInverseBinds = true);

    GltfBuilder::Json& node(int index) { return odd.file.json["nodes"][static_cast<std::size_t>(index)]; }

    /// Joints along a band, bound there, and bent a little since; and a skin of them.
    Rig addChain(int joints);

    /// A mesh of one band with joints; the band becomes what the file says.
    void addMesh(Band& band, const Form& form = {});

    /// Where that skin has a band that the node shows, `wider` metres to the right by a morph target.
    void expect(int node, const Rig& skin, const Band& band, double wider = 0);

    /// The same for a band without joints.
    void expectStill(int node, const Band& band, double wider = 0);

    OddSkin odd; ///< As far as it has come.
    Rig rig;     ///< Of skin 0.

private:
    bool m_storesBinds;
};
