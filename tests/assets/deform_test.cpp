// SPDX-License-Identifier: MIT
// Skins and morph targets of scenes made by code, and what is refused of them; files that mix them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "franken/complete.h"
#include "franken/pose.h"
#include "franken/scene_check.h"
#include "gltf_file.h"

using namespace franken;

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

bool isNear(const glm::vec3& a, const glm::vec3& b) { return glm::distance(a, b) < 1e-6f; }

/// A unit plane of four vertices, moved by two joints and one target.
Deformation twoJoints() {
    Deformation deformation{.bind = {}, .influencesPerVertex = 3};
    for (int vertex = 0; vertex < 4; ++vertex)
        for (const Influence& influence : {Influence{0, 0.5f}, {1, 0}, {1, 0.5f}})
            deformation.influences.push_back(influence);
    Vertices wider;
    wider.positions.assign(4, {2, 0, 0});
    wider.tangents.assign(4, {-1, 1, 0, 0});
    deformation.targets = {wider};
    return deformation;
}

Scene sceneOf(const Deformation& deformation) {
    Scene scene;
    Primitive primitive = plane({1, 1});
    primitive.deformation = std::make_shared<const Deformation>(deformation);
    scene.meshes.emplace_back().primitives = {primitive};
    scene.instances.push_back({.name = "", .mesh = 0, .nodeIndex = 0, .skin = 0});
    scene.nodes = {Node{.rest = {.weights = {0}}}, Node{}, Node{}};
    scene.skins = {{.joints = {1, 2}, .inverseBinds = {glm::mat4(1), glm::mat4(1)}}};
    return scene;
}

Scene completed(const Scene& scene) {
    Result<Scene> done = complete(scene);
    EXPECT_TRUE(done) << toString(done.error());
    return *std::move(done);
}

const Primitive& only(const Scene& scene) { return scene.meshes.at(0).primitives.at(0); }

TEST(Deform, EveryWeightCountsWhereverItStands) {
    Scene scene = completed(sceneOf(twoJoints()));
    const glm::vec3 before = only(scene).positions[0];
    Pose pose = restPose(scene);
    pose.nodes[2].local.translation = {0, 0, 4};
    ASSERT_TRUE(applyPose(scene, pose));
    EXPECT_TRUE(isNear(only(scene).positions[0], before + glm::vec3(0, 0, 2))) << "the third of three";
    EXPECT_NEAR(only(scene).bounds.max.z, 2, 1e-6);
}

TEST(Deform, TargetsMoveTangentsAndLeaveTheirSide) {
    Scene scene = completed(sceneOf(twoJoints()));
    const glm::vec4 before = only(scene).tangents[0];
    ASSERT_TRUE(isNear(glm::vec3(before), {1, 0, 0}));
    Pose pose = restPose(scene);
    pose.nodes[0].weights = {0.5f};
    ASSERT_TRUE(applyPose(scene, pose));
    EXPECT_TRUE(isNear(glm::vec3(only(scene).tangents[0]), glm::normalize(glm::vec3(1, 1, 0))));
    EXPECT_EQ(only(scene).tangents[0].w, before.w);
    EXPECT_NEAR(only(scene).bounds.max.x, 1.5, 1e-6);
}

TEST(Deform, TargetsMoveTextureCoordinatesAndColorsWhichStayInRange) {
    Deformation deformation = twoJoints();
    deformation.targets[0].uv[0].assign(4, {0.25f, 0});
    deformation.targets[0].uv[1].assign(4, {0, 0.5f});
    deformation.targets[0].colors.assign(4, {0.5f, -0.5f, 0.125f, 0});
    Scene scene = sceneOf(deformation);
    Primitive& primitive = scene.meshes[0].primitives[0];
    primitive.uv[1] = primitive.uv[0];
    primitive.colors.assign(4, {0.75f, 0.25f, 0.5f, 1});
    const glm::vec2 before = primitive.uv[0][2];
    scene = completed(scene);
    Pose pose = restPose(scene);
    pose.nodes[0].weights = {1};
    ASSERT_TRUE(applyPose(scene, pose));
    EXPECT_EQ(only(scene).uv[0][2], before + glm::vec2(0.25f, 0));
    EXPECT_EQ(only(scene).uv[1][2], before + glm::vec2(0, 0.5f));
    EXPECT_EQ(only(scene).colors[2], glm::vec4(1, 0, 0.625f, 1));
}

// A joint that makes things wide makes their normals lean the other way: the inverse transpose.
TEST(Deform, NormalsTurnByTheInverseTranspose) {
    Scene scene = sceneOf(twoJoints());
    Primitive primitive = only(scene);
    primitive.normals.assign(4, glm::normalize(glm::vec3(1, 0, 1)));
    primitive.tangents.assign(4, glm::vec4(glm::normalize(glm::vec3(1, 0, -1)), 1));
    scene.meshes[0].primitives = {primitive};
    scene = completed(scene);
    Pose pose = restPose(scene);
    for (const std::size_t joint : {1u, 2u})
        pose.nodes[joint].local.scale = {2, 1, 1};
    ASSERT_TRUE(applyPose(scene, pose));
    EXPECT_TRUE(isNear(only(scene).normals[0], glm::normalize(glm::vec3(1, 0, 2))));
    EXPECT_TRUE(isNear(glm::vec3(only(scene).tangents[0]), glm::normalize(glm::vec3(2, 0, -1))));
}

/// Of what the deformation says without a look at the vertices.
TEST(Deform, BoundsHoldAllVertices) {
    const Scene scene = completed(sceneOf(twoJoints()));
    const Deformation& deformation = *only(scene).deformation;
    const glm::mat4x3 still(1), away(glm::translate(glm::mat4(1), {0, 5, -3}));
    const std::vector<glm::mat4x3> joints = {still, away};
    for (const float weight : {-2.0f, 0.0f, 3.0f}) {
        const Deforming pose{.weights = {&weight, 1}, .joints = joints};
        Vertices moved;
        deform(deformation, pose, moved);
        const Box box = boundsOf(deformation, pose);
        for (const glm::dvec3 position : moved.positions)
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_GE(position[axis], box.min[axis] - 1e-6) << weight;
                EXPECT_LE(position[axis], box.max[axis] + 1e-6) << weight;
            }
        EXPECT_LT(glm::distance(box.min, box.max), 20);
    }
}

struct Fault {
    const char* where;
    void (*change)(Deformation&);
};

const Fault kFaults[] = {
    {"influences", [](Deformation& all) { all.influences[4].joint = 65536; }},
    {"influences",
     [](Deformation& all) { all.influences[4].joint = std::numeric_limits<std::uint32_t>::max(); }},
    {"influences", [](Deformation& all) { all.influences[5].weight = kInfinity; }},
    {"influences", [](Deformation& all) { all.influences[5].weight = std::nanf(""); }},
    {"influences", [](Deformation& all) { all.influences[5].weight = 0.25f; }},
    {"influences",
     [](Deformation& all) {
         all.influences[3].weight = -0.5f;
         all.influences[5].weight = 1.5f;
     }},
    {"influences", [](Deformation& all) { all.influences.pop_back(); }},
    {"influences", [](Deformation& all) { all.influences.clear(); }},
    {"influences", [](Deformation& all) { all.influences.resize(99); }},
    {"influences", [](Deformation& all) { all.influencesPerVertex = 0; }},
    {"influences", [](Deformation& all) { all.influencesPerVertex = std::size_t{1} << 62U; }},
    {"targets[0]", [](Deformation& all) { all.targets[0].positions.pop_back(); }},
    {"targets[0]", [](Deformation& all) { all.targets[0].positions[3].y = kInfinity; }},
    {"targets[0]",
     [](Deformation& all) {
         all.targets[0].colors.assign(4, {0, 0, 0, 0});
     }},
    {"targets[0]",
     [](Deformation& all) {
         all.targets[0].uv[1].assign(4, {0, 0});
     }},
    {"bind",
     [](Deformation& all) {
         all.bind.positions.assign(3, {0, 0, 0});
     }},
    {"bind",
     [](Deformation& all) {
         all.bind.positions.assign(4, {0, 0, 0});
     }},
    {"flat", [](Deformation& all) { all.flat = true; }},
};

TEST(Deform, NamesWhatIsWrong) {
    for (const auto& [where, change] : kFaults) {
        Deformation deformation = twoJoints();
        change(deformation);
        const Result<Scene> done = complete(sceneOf(deformation));
        ASSERT_FALSE(done) << where;
        EXPECT_EQ(done.error().code, "scene.data");
        EXPECT_EQ(done.error().where, std::string("meshes[0].primitives[0].deformation.") + where);
    }
}

struct SkinFault {
    const char* where;
    void (*change)(Scene&);
};

const SkinFault kSkinFaults[] = {
    {"skins[0].joints", [](Scene& scene) { scene.skins[0].joints.clear(); }},
    {"skins[0].joints", [](Scene& scene) { scene.skins[0].joints[1] = 3; }},
    {"skins[0].inverseBinds", [](Scene& scene) { scene.skins[0].inverseBinds.pop_back(); }},
    {"skins[0].inverseBinds", [](Scene& scene) { scene.skins[0].inverseBinds[1][2][2] = kInfinity; }},
    {"instances[0].skin", [](Scene& scene) { scene.instances[0].skin = 1; }},
    {"instances[0].skin", [](Scene& scene) { scene.instances[0].nodeIndex = kNone; }},
    {"instances[0].skin",
     [](Scene& scene) {
         scene.skins[0].joints.pop_back();
         scene.skins[0].inverseBinds.pop_back();
     }},
    {"instances[0].skin",
     [](Scene& scene) {
         scene.meshes[0].primitives.push_back(plane({1, 1}));
     }},
};

TEST(Deform, NamesWhatIsWrongWithSkins) {
    for (const auto& [where, change] : kSkinFaults) {
        Scene scene = sceneOf(twoJoints());
        change(scene);
        const Result<Scene> done = complete(scene);
        ASSERT_FALSE(done) << where;
        EXPECT_EQ(done.error().where, where);
    }
}

/// A triangle without normals, whose node mirrors it.
GltfFile mirroredTriangle() {
    GltfFile file;
    file.setTriangle();
    file.json["nodes"] = {{{"mesh", 0}, {"scale", {-1, 1, 1}}}};
    file.json["scenes"][0]["nodes"] = {0};
    return file;
}

TEST(GltfDeform, FlatNormalsOfAMirroredMorphAreThoseWithoutIt) {
    GltfFile file = mirroredTriangle();
    const glm::vec3 still = only(file.loaded()).normals[0];
    const int moves = file.floats("VEC3", {0, 0, 0, 0, 0, 0, 0, 5, 0});
    file.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", moves}}};
    Scene scene = file.loaded();
    ASSERT_TRUE(only(scene).deformation && only(scene).deformation->flat);
    EXPECT_TRUE(scene.instances[0].mirrored);
    EXPECT_EQ(only(scene).normals[0], still);
    Pose pose = restPose(scene);
    pose.nodes[0].weights = {1};
    ASSERT_TRUE(applyPose(scene, pose));
    EXPECT_EQ(only(scene).normals[0], still) << "it stays in its plane";
}

TEST(GltfDeform, WeightsBelowNothingAreNothing) {
    GltfFile file = mirroredTriangle();
    const int joints = file.accessor("VEC4", GltfFile::kUByte,
                                     std::vector<std::uint8_t>{0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0});
    const int weights = file.floats("VEC4", {0.5f, 0.5f, 0, 0, -1, 3, 0, 0, -1, 0, 0, 0});
    GltfFile::Json& attributes = file.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] = joints;
    attributes["WEIGHTS_0"] = weights;
    file.json["skins"] = {{{"joints", {1, 2}}}};
    file.json["nodes"] = {{{"mesh", 0}, {"skin", 0}}, GltfFile::Json::object(), GltfFile::Json::object()};
    file.json["scenes"][0]["nodes"] = {0, 1, 2};
    const Scene scene = file.loaded();
    const std::vector<Influence>& influences = only(scene).deformation->influences;
    ASSERT_EQ(influences.size(), 6u);
    EXPECT_EQ(influences[1].weight, 0.5f);
    EXPECT_EQ(influences[2].joint, 1u);
    EXPECT_EQ(influences[2].weight, 1);
    EXPECT_EQ(influences[4].joint, 0u) << "where none is left, the first joint moves it";
    EXPECT_EQ(influences[4].weight, 1);
    EXPECT_EQ(file.warnings.size(), 1u);
}

} // namespace
