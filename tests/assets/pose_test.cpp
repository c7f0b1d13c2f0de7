// SPDX-License-Identifier: MIT
// Animations of small files, sampled; and files whose animations are at fault.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "franken/pose.h"
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
