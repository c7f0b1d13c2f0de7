// SPDX-License-Identifier: MIT
// Skins as exporters write them, against numbers worked out in double.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "franken/pose.h"
#include "franken/scene_check.h"
#include "gltf_file.h"
#include "support/odd_skins.h"

using namespace franken;

namespace {

constexpr double kRounding = 2e-6; // Of floats, in a scene of about 3 m.

GltfFile fileOf(const GltfBuilder& builder) {
    GltfFile file;
    static_cast<GltfBuilder&>(file) = builder;
    return file;
}

const Instance* instanceOf(const Scene& scene, const ExpectedVertex& vertex) {
    const auto shows = [&](const Instance& instance) {
        return scene.nodes[static_cast<std::size_t>(instance.nodeIndex)].index == vertex.node &&
               (instance.skin != kNone) == vertex.skinned;
    };
    const auto found = std::find_if(scene.instances.begin(), scene.instances.end(), shows);
    return found == scene.instances.end() ? nullptr : &*found;
}

/// How far the worst vertex is from where it should be, metres; and all bounds hold all vertices.
double worstOf(const Scene& scene, const OddSkin& odd, glm::dvec3 ExpectedVertex::*where) {
    double worst = 0;
    const Box bounds = scene.bounds();
    for (const ExpectedVertex& vertex : odd.expected) {
        const Instance* const instance = instanceOf(scene, vertex);
        if (instance == nullptr) {
            ADD_FAILURE() << "nothing is on node " << vertex.node;
            return 1;
        }
        const Mesh& mesh = scene.meshes.at(static_cast<std::size_t>(instance->mesh));
        EXPECT_EQ(mesh.primitives.size(), 1u);
        const glm::dvec4 position(mesh.primitives.at(0).positions.at(vertex.vertex), 1);
        worst = std::max(worst, glm::distance(glm::dvec3(instance->world * position), vertex.*where));
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_LE(bounds.min[axis] - kRounding, (vertex.*where)[axis]);
            EXPECT_GE(bounds.max[axis] + kRounding, (vertex.*where)[axis]);
        }
    }
    return worst;
}

TEST(OddSkins, AreWhereTheirJointsHaveThem) {
    for (const OddSkin& odd : oddSkins()) {
        SCOPED_TRACE(odd.name);
        GltfFile file = fileOf(odd.file);
        Scene scene = file.loaded();
        ASSERT_FALSE(scene.instances.empty());
        EXPECT_TRUE(check(scene)) << toString(check(scene).error());
        EXPECT_EQ(file.warnings.size(), odd.warning.empty() ? 0u : 1u);
        for (const std::string& warning : file.warnings)
            EXPECT_NE(warning.find(odd.warning), std::string::npos) << warning;
        EXPECT_LT(worstOf(scene, odd, &ExpectedVertex::atRest), kRounding);
        Pose pose = restPose(scene);
        for (std::size_t node = 0; node < scene.nodes.size(); ++node)
            if (scene.nodes[node].index == odd.turned)
                pose.nodes[node].local.rotation = glm::dquat(std::cos(kTurn / 2), 0, 0, std::sin(kTurn / 2));
        ASSERT_TRUE(applyPose(scene, pose));
        EXPECT_LT(worstOf(scene, odd, &ExpectedVertex::turned), kRounding);
    }
}

TEST(OddSkins, AJointThatIsNotThereIsRefusedWhereItPulls) {
    GltfFile file = fileOf(skinWithAJointTooMany(0.5f));
    const Result<Scene> scene = file.load();
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().code, "gltf.index-range");
    EXPECT_TRUE(scene.error().where.ends_with("/meshes/0/primitives/0/attributes/JOINTS_0"));
    EXPECT_NE(scene.error().what.find("vertex 5 names joint 2 of 2"), std::string::npos);
    EXPECT_TRUE(fileOf(skinWithAJointTooMany(0)).load());
}

} // namespace
