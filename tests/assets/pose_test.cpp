// SPDX-License-Identifier: MIT
// Animations of small files, sampled; and files whose animations are at fault.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "franken/pose.h"
#include "franken/scene_check.h"
#include "gltf_file.h"

using namespace franken;

namespace {

using Json = GltfFile::Json;

/// A triangle whose node is moved by one channel.
GltfFile animated(const char* path, const char* type, const std::vector<float>& times,
                  const std::vector<float>& values, const char* interpolation = "LINEAR") {
    GltfFile file;
    file.setTriangle();
    const int input = file.floats("SCALAR", times), output = file.floats(type, values);
    file.json["animations"] = {
        {{"samplers", {{{"input", input}, {"output", output}, {"interpolation", interpolation}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}}}};
    return file;
}

glm::dvec3 translationAt(const Scene& scene, double seconds, Ends ends = Ends::Hold) {
    Pose pose;
    const Result<void> sampled = sample(scene, 0, seconds, pose, ends);
    EXPECT_TRUE(sampled) << toString(sampled.error());
    return pose.nodes.at(0).local.translation;
}

bool isWarned(const GltfFile& file, const std::string& text) {
    return std::any_of(file.warnings.begin(), file.warnings.end(),
                       [&](const std::string& warning) { return warning.find(text) != std::string::npos; });
}

TEST(Sample, HoldsItsEndsOrLoops) {
    const Scene scene = animated("translation", "VEC3", {1, 2}, {1, 0, 0, 3, 0, 0}).loaded();
    EXPECT_EQ(translationAt(scene, 0).x, 1);
    EXPECT_EQ(translationAt(scene, 1.5).x, 2);
    EXPECT_EQ(translationAt(scene, 9).x, 3);
    EXPECT_EQ(translationAt(scene, 3.5, Ends::Loop).x, 2);
    EXPECT_EQ(translationAt(scene, -0.5, Ends::Loop).x, 2);
}

TEST(Sample, HasAKeysOwnValueOnTheKey) {
    const Scene scene =
        animated("translation", "VEC3", {0, 0.1f, 0.7f}, {0, 0, 0, 1, 0, 0, 2, 0, 0}, "STEP").loaded();
    EXPECT_EQ(translationAt(scene, 0.1).x, 1); // the double below the float
    EXPECT_EQ(translationAt(scene, 0.0999).x, 0);
    EXPECT_EQ(translationAt(scene, 0.7).x, 2);
}

TEST(Sample, BetweenKeysAKeyIsMetToTheFloat) {
    const Scene scene = animated("translation", "VEC3", {0, 0.7f, 2}, {0, 0, 0, 1, 0, 0, 2, 0, 0}).loaded();
    EXPECT_EQ(translationAt(scene, 0.7).x, 1); // the double above the float
}

TEST(Sample, MovesWeightsAndHides) {
    GltfFile file = animated("weights", "SCALAR", {0, 1}, {0, 1});
    file.json["meshes"][0]["primitives"][0]["targets"] = {
        {{"POSITION", file.floats("VEC3", {1, 0, 0, 1, 0, 0, 1, 0, 0})}}};
    Pose pose;
    ASSERT_TRUE(sample(file.loaded(), 0, 0.25, pose));
    EXPECT_EQ(pose.nodes.at(0).weights, std::vector<float>{0.25f});

    GltfFile hiding = animated("pointer", "SCALAR", {0, 1}, {1, 0}, "STEP");
    hiding.json["animations"][0]["channels"][0]["target"] = {
        {"path", "pointer"},
        {"extensions",
         {{"KHR_animation_pointer", {{"pointer", "/nodes/0/extensions/KHR_node_visibility/visible"}}}}}};
    const Scene scene = hiding.loaded();
    pose = {};
    ASSERT_TRUE(sample(scene, 0, 1, pose));
    EXPECT_FALSE(pose.nodes.at(0).visible);
    ASSERT_TRUE(sample(scene, 0, 0.5, pose));
    EXPECT_TRUE(pose.nodes.at(0).visible);
}

TEST(Sample, SplinesUseBothTangents) {
    // In-tangent, value, out-tangent of two keys, 2 s apart.
    const Scene scene = animated("translation", "VEC3", {0, 2},
                                 {0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 4, 0, 0, 0, 0, 0}, "CUBICSPLINE")
                            .loaded();
    // Half way: (p0 + p1) / 2 + distance * (out - in) / 8.
    EXPECT_DOUBLE_EQ(translationAt(scene, 1).x, 2 + 2 * (1.0 - 1.0) / 8);
    EXPECT_EQ(translationAt(scene, 2).x, 4);
}

TEST(Sample, TurnsTheShortWayRound) {
    const float h = std::sqrt(0.5f);
    const Scene scene = animated("rotation", "VEC4", {0, 1}, {0, 0, 0, 1, 0, 0, -h, -h}).loaded();
    Pose pose;
    ASSERT_TRUE(sample(scene, 0, 0.5, pose));
    EXPECT_NEAR(std::fabs(pose.nodes[0].local.rotation.w), std::cos(std::acos(-1.0) / 8), 1e-6);
}

TEST(Sample, RefusesWhatIsNotThere) {
    const Scene scene = animated("translation", "VEC3", {0}, {1, 2, 3}).loaded();
    Pose pose;
    EXPECT_EQ(sample(scene, 1, 0, pose).error().code, "pose.animation");
    EXPECT_EQ(sample(scene, 0, std::numeric_limits<double>::quiet_NaN(), pose).error().code, "pose.time");
    EXPECT_TRUE(pose.nodes.empty());
}

TEST(Mix, LiesBetween) {
    const Scene scene = animated("translation", "VEC3", {0, 1}, {0, 0, 0, 4, 0, 0}).loaded();
    Pose a, b;
    ASSERT_TRUE(sample(scene, 0, 0, a));
    ASSERT_TRUE(sample(scene, 0, 1, b));
    ASSERT_TRUE(mix(a, b, 0.25, a));
    EXPECT_EQ(a.nodes[0].local.translation.x, 1);
    EXPECT_EQ(mix(a, Pose{}, 0.5, b).error().code, "pose.nodes");
}

TEST(Mix, MixesWeightsAndTakesTheNearersVisibility) {
    const Pose a{{{.visible = true, .weights = {1}}}}, b{{{.visible = false, .weights = {3}}}};
    Pose out;
    ASSERT_TRUE(mix(a, b, 0.25, out));
    EXPECT_TRUE(out.nodes.at(0).visible);
    EXPECT_EQ(out.nodes.at(0).weights, std::vector<float>{1.5f});
    ASSERT_TRUE(mix(a, b, 0.75, out));
    EXPECT_FALSE(out.nodes.at(0).visible);
}

TEST(Pose, PlacesAnInstanceWithItsOffset) {
    Scene scene = animated("translation", "VEC3", {0}, {0, 0, 0}).loaded();
    scene.instances.at(0).offset[3].x = 2;
    Pose pose = restPose(scene);
    pose.nodes.at(0).local = {.translation = {5, 0, 0}, .scale = {-1, 1, 1}};
    ASSERT_TRUE(applyPose(scene, pose));
    EXPECT_EQ(scene.instances[0].world[3].x, 3);
    EXPECT_TRUE(scene.instances[0].mirrored);
}

TEST(Pose, MovesWhatHangsBelowAndHidesIt) {
    GltfFile file;
    file.setTriangle();
    file.append("nodes",
                {{"children", {0}}, {"extensions", {{"KHR_node_visibility", {{"visible", false}}}}}});
    file.json["scenes"] = {{{"nodes", {1}}}};
    Scene scene = file.loaded();
    ASSERT_EQ(scene.instances.size(), 1u);
    EXPECT_FALSE(scene.instances[0].visible);
    EXPECT_TRUE(scene.bounds().empty());
    Pose pose = restPose(scene);
    pose.nodes[0].visible = true;
    pose.nodes[0].local.translation = {5, 0, 0};
    ASSERT_TRUE(applyPose(scene, pose));
    EXPECT_TRUE(scene.instances[0].visible);
    EXPECT_EQ(scene.instances[0].world[3].x, 5);
    EXPECT_EQ(applyPose(scene, Pose{}).error().code, "pose.nodes");
}

TEST(Pose, IsRefusedWhereItIsNotTheScenes) {
    const Scene scene = animated("translation", "VEC3", {0}, {1, 2, 3}).loaded();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    constexpr double kLarge = std::numeric_limits<double>::max();
    const auto placeOf = [&](auto change) {
        Pose pose = restPose(scene);
        change(pose.nodes.at(0));
        const Result<void> checked = check(scene, pose);
        return checked ? "" : checked.error().code + " " + checked.error().where;
    };
    const std::string refused = "pose.nodes nodes[0]";
    EXPECT_EQ(placeOf([](NodeState& node) { node.local.translation = {kInfinity, -kInfinity, 0}; }), refused);
    EXPECT_EQ(placeOf([](NodeState& node) { node.local.rotation.w = std::nan(""); }), refused);
    EXPECT_EQ(placeOf([](NodeState& node) { node.local.scale.z = kInfinity; }), refused);
    EXPECT_EQ(placeOf([](NodeState& node) { node.weights = {1}; }), refused);
    EXPECT_EQ(placeOf([](NodeState& node) { node.local.scale = {kLarge, kLarge, 1}; }), "");
}

struct MotionFault {
    const char* where;
    void (*change)(Scene&);
};

const MotionFault kMotionFaults[] = {
    {"instances[0].nodeIndex", [](Scene& scene) { scene.instances[0].nodeIndex = 1; }},
    {"cameras[0].nodeIndex", [](Scene& scene) { scene.cameras.emplace_back().nodeIndex = 1; }},
    {"lights[0].nodeIndex", [](Scene& scene) { scene.lights.emplace_back().nodeIndex = -2; }},
    {"nodes[0].parent", [](Scene& scene) { scene.nodes[0].parent = 0; }},
    {"animations[0].duration", [](Scene& scene) { scene.animations[0].duration = std::nanf(""); }},
    {"animations[0].samplers[0].times", [](Scene& scene) { scene.animations[0].samplers[0].times = {}; }},
    {"animations[0].samplers[0].times", [](Scene& scene) { scene.animations[0].samplers[0].times[1] = -1; }},
    {"animations[0].samplers[0].times",
     [](Scene& scene) { scene.animations[0].samplers[0].times[1] = std::nanf(""); }},
    {"animations[0].samplers[0].values",
     [](Scene& scene) { scene.animations[0].samplers[0].values[5] = std::nanf(""); }},
    {"animations[0].channels[0].node", [](Scene& scene) { scene.animations[0].channels[0].node = 1; }},
    {"animations[0].channels[0].sampler", [](Scene& scene) { scene.animations[0].channels[0].sampler = 1; }},
    {"animations[0].channels[0]", [](Scene& scene) { scene.animations[0].samplers[0].values.pop_back(); }},
    {"animations[0].channels[1]",
     [](Scene& scene) { scene.animations[0].channels.resize(2, scene.animations[0].channels[0]); }},
};

TEST(CheckedScene, NamesWhatIsWrongWithItsMotion) {
    const Scene sound = animated("translation", "VEC3", {0, 1}, {0, 0, 0, 1, 0, 0}).loaded();
    EXPECT_TRUE(check(sound));
    for (const auto& [where, change] : kMotionFaults) {
        Scene scene = sound;
        change(scene);
        const Result<void> checked = check(scene);
        ASSERT_FALSE(checked) << where;
        EXPECT_EQ(checked.error().code, "scene.data");
        EXPECT_EQ(checked.error().where, where);
    }
}

TEST(GltfAnimation, FaultsCostTheAnimationAlone) {
    for (GltfFile file :
         {animated("translation", "VEC3", {1, 0}, {0, 0, 0, 1, 0, 0}),
          animated("translation", "VEC3", {0, 1}, {0, 0, 0}),
          animated("translation", "VEC4", {0}, {0, 0, 0, 1}), animated("colour", "VEC3", {0}, {0, 0, 0}),
          animated("scale", "VEC3", {0}, {0, 0, 0}, "SMOOTH"),
          animated("scale", "VEC3", {0}, {0, 0, std::nanf("")})}) {
        const Scene scene = file.loaded();
        EXPECT_EQ(scene.instances.size(), 1u);
        EXPECT_TRUE(scene.animations.empty());
        EXPECT_TRUE(isWarned(file, "gltf.unneeded"));
    }
}

TEST(GltfAnimation, TwoChannelsThatMoveTheSameCostIt) {
    GltfFile file = animated("translation", "VEC3", {0}, {0, 0, 0});
    Json& channels = file.json["animations"][0]["channels"];
    channels.push_back(Json(channels[0]));
    EXPECT_TRUE(file.loaded().animations.empty());
    EXPECT_TRUE(isWarned(file, "move the same"));
}

TEST(GltfAnimation, MatricesMoveUnlessTheyShear) {
    GltfFile file = animated("translation", "VEC3", {0}, {7, 0, 0});
    file.json["nodes"][0]["matrix"] = {0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0, 0, 5, 6, 7, 1}; // mirrored
    const Scene turned = file.loaded();
    EXPECT_FALSE(turned.nodes.at(0).matrix);
    const glm::dmat4 matrix = matrixOf(turned.nodes[0].rest.local);
    for (int column = 0; column < 4; ++column)
        EXPECT_LT(glm::distance(matrix[column], turned.instances.at(0).world[column]), 1e-12) << column;
    EXPECT_EQ(turned.animations.at(0).channels.size(), 1u);

    file.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    const Scene sheared = file.loaded();
    EXPECT_TRUE(sheared.nodes.at(0).matrix);
    EXPECT_TRUE(sheared.animations.at(0).channels.empty());
    EXPECT_TRUE(isWarned(file, "shears"));
}

TEST(GltfAnimation, IndicesThatPointAtNothingAreRefused) {
    for (const char* pointer : {"/channels/0/sampler", "/channels/0/target/node", "/samplers/0/input"}) {
        GltfFile file = animated("translation", "VEC3", {0}, {0, 0, 0});
        file.json["animations"][0][Json::json_pointer(pointer)] = 99;
        const auto scene = file.load();
        ASSERT_FALSE(scene) << pointer;
        EXPECT_EQ(scene.error().code, "gltf.index-range") << pointer;
    }
}

TEST(GltfAnimation, IntegersAreNormalized) {
    GltfFile file = animated("rotation", "VEC4", {0}, {0, 0, 0, 1});
    const int output = file.accessor<std::int16_t>("VEC4", GltfFile::kShort, {0, 32767, 0, 0});
    file.json["animations"][0]["samplers"][0]["output"] = output;
    const Scene scene = file.loaded();
    Pose pose;
    ASSERT_TRUE(sample(scene, 0, 0, pose));
    EXPECT_EQ(pose.nodes[0].local.rotation.y, 1);
    EXPECT_TRUE(isWarned(file, "gltf.mended"));
}

} // namespace
