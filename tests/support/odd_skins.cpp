// SPDX-License-Identifier: MIT
#include "support/odd_skins.h"

#include "support/skin_maker.h"

#include <functional>

namespace {

using Json = GltfBuilder::Json;

/// A chain, a band, and what is odd about its nodes.
OddSkin bent(const char* name, int joints, int each, const std::function<void(SkinMaker&)>& change = {},
             const Form& form = {}, double sum = 1) {
    SkinMaker maker(name, joints);
    Band band = bandOf(joints, each, sum);
    maker.addMesh(band, form);
    if (change)
        change(maker);
    maker.expect(0, maker.rig, band);
    return maker.odd;
}

OddSkin withoutInverseBinds() {
    SkinMaker maker("without inverse bind matrices", 3, false);
    Band band = bandOf(3, 2);
    maker.addMesh(band);
    maker.expect(0, maker.rig, band);
    return maker.odd;
}

// glTF leaves it open; the vertex is where the skin's first joint has it.
OddSkin weightsOfNothing() {
    SkinMaker maker("weights of sum 0", 3);
    Band band = bandOf(3, 2);
    for (Pull& pull : band.pulls[4])
        pull.weight = 0;
    maker.addMesh(band);
    band.pulls[4] = {{0, 1}};
    maker.expect(0, maker.rig, band);
    return maker.odd;
}

OddSkin twoSkinsOfOneMesh() {
    SkinMaker maker("two skins share a mesh", 3);
    Band band = bandOf(3, 2);
    maker.addMesh(band);
    const int other = maker.odd.file.append("nodes", {{"mesh", 0}, {"skin", 1}});
    const Rig second = maker.addChain(3);
    maker.node(second.joints[0])["translation"] = {1.5, -0.5, 0};
    maker.odd.file.json["scenes"][0]["nodes"] = {0, 1, other, second.joints[0]};
    maker.expect(0, maker.rig, band);
    maker.expect(other, second, band);
    return maker.odd;
}

OddSkin partlySkinned(bool morphed) {
    SkinMaker maker(morphed ? "a morphed primitive without joints" : "a primitive without joints", 3);
    Band band = bandOf(3, 2);
    maker.addMesh(band);
    Json bare = bareBand(maker.odd.file, band);
    Json& mesh = maker.odd.file.json["meshes"][0];
    if (morphed) {
        std::vector<float> wider;
        for (std::size_t v = 0; v < band.positions.size(); ++v)
            wider.insert(wider.end(), {0.5f, 0, 0});
        bare["targets"] = {{{"POSITION", maker.odd.file.floats("VEC3", wider)}}};
        mesh["weights"] = {0.5};
    }
    mesh["primitives"].push_back(bare);
    maker.node(0)["translation"] = {-1.5, 0.25, 0.5};
    maker.node(0)["scale"] = {1, 0.5, 1};
    maker.odd.warning = "it stands where its node does";
    maker.expect(0, maker.rig, band);
    maker.expectStill(0, band, morphed ? 0.25 : 0);
    return maker.odd;
}

/// The skin's last joint shows a mesh of its own, and the skinned mesh's node is a joint as well.
OddSkin jointsThatShowMeshes() {
    SkinMaker maker("a node that is joint and mesh", 3);
    Band band = bandOf(4, 2), still = bandOf(1, 1);
    maker.odd.file.json["skins"] = Json::array();
    maker.rig.joints.push_back(0);
    maker.rig.inverseBinds.emplace_back(1);
    maker.odd.file.append("skins", {{"joints", maker.rig.joints},
                                    {"inverseBindMatrices", storeBinds(maker.odd.file, maker.rig)}});
    maker.addMesh(band);
    maker.node(0)["translation"] = {0.25, 0.5, 0};
    maker.odd.file.append("meshes", {{"primitives", Json::array({bareBand(maker.odd.file, still)})}});
    maker.node(3)["mesh"] = 1;
    maker.expect(0, maker.rig, band);
    maker.expectStill(3, still);
    return maker.odd;
}

OddSkin morphed() {
    SkinMaker maker("a morph under a skin", 3);
    Band band = bandOf(3, 2);
    maker.addMesh(band);
    std::vector<float> wider;
    for (std::size_t v = 0; v < band.positions.size(); ++v)
        wider.insert(wider.end(), {0.5f, 0, 0});
    Json& mesh = maker.odd.file.json["meshes"][0];
    mesh["primitives"][0]["targets"] = {{{"POSITION", maker.odd.file.floats("VEC3", wider)}}};
    maker.node(0)["weights"] = {0.75};
    maker.expect(0, maker.rig, band, 0.375);
    return maker.odd;
}

/// Joints say where it is: there is one, wherever the instances are.
OddSkin instanced() {
    OddSkin odd = bent("instances of a skin", 3, 2, [](SkinMaker& maker) {
        const int places = maker.odd.file.floats("VEC3", {3, 0, 0, -3, 0, 0});
        maker.node(0)["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", places}};
        maker.odd.file.json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
    });
    odd.warning = "and not at instances";
    return odd;
}

void putBelow(SkinMaker& maker, const Json& parent) {
    const int root = maker.odd.file.append("nodes", parent);
    maker.node(root)["children"] = {1};
    maker.odd.file.json["scenes"][0]["nodes"] = {0, root};
}

void mirrorTheArmature(SkinMaker& maker) {
    const int root = maker.odd.file.append("nodes", {{"scale", {-1, 1, 1}}, {"translation", {0.5, 0, 0}}});
    maker.node(root)["children"] = {0, 1};
    maker.odd.file.json["scenes"][0]["nodes"] = {root};
}

} // namespace

GltfBuilder skinWithAJointTooMany(float weight) {
    SkinMaker maker("", 2);
    Band band = bandOf(2, 2);
    band.pulls[5] = {{1, 1.0 - static_cast<double>(weight)}, {2, static_cast<double>(weight)}};
    maker.addMesh(band);
    return maker.odd.file;
}

std::vector<OddSkin> oddSkins() {
    const int u8 = GltfBuilder::kUByte, u16 = GltfBuilder::kUShort;
    return {
        bent("plain", 3, 2),
        withoutInverseBinds(),
        bent("a mirrored armature", 3, 2, mirrorTheArmature),
        bent("joints of negative scale", 3, 2,
             [](SkinMaker& maker) {
                 maker.node(2)["scale"] = {1, -1, 1};
                 maker.node(3)["scale"] = {-1, -1, -1};
             }),
        bent("a joint of no scale", 3, 2,
             [](SkinMaker& maker) {
                 maker.node(3)["scale"] = {0, 0, 0};
             }),
        bent("joints below a matrix that shears", 3, 2,
             [](SkinMaker& maker) {
                 putBelow(maker, {{"matrix", {1, 0.25, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 0.5, 0, 0, 1}}});
             }),
        weightsOfNothing(),
        bent("weights of sum 2", 3, 3, {}, {}, 2),
        bent("a transform of the skinned mesh's own", 3, 2,
             [](SkinMaker& maker) {
                 maker.node(0)["translation"] = {100, -50, 3};
                 maker.node(0)["scale"] = {5, 0.1, 7};
             }),
        twoSkinsOfOneMesh(),
        bent("a skeleton root elsewhere, and joints in no scene", 3, 2,
             [](SkinMaker& maker) {
                 maker.odd.file.json["skins"][0]["skeleton"] =
                     maker.odd.file.append("nodes", {{"translation", {9, 9, 9}}});
                 maker.odd.file.json["scenes"][0]["nodes"] = {0};
             }),
        bent("seven joints of a vertex", 9, 7),
        partlySkinned(false),
        partlySkinned(true),
        bent("joints of 16 bits", 3, 2, {}, {u16}),
        bent("weights of 8 bits", 5, 3, {}, {u8, u8}),
        bent("weights of 16 bits", 5, 4, {}, {u16, u16}),
        jointsThatShowMeshes(),
        bent("300 joints", 300, 4, {}, {u16}),
        bent("one joint", 1, 1),
        morphed(),
        instanced(),
    };
}
