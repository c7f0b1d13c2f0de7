// SPDX-License-Identifier: MIT
// The model that moves: is it good glTF, the same everywhere, and a flower's day?
#include "franken/gltf.h"
#include "franken/pose.h"
#include "franken/scene_check.h"
#include "support/shell.h"

#include <algorithm>
#include <cstdint>

#include <glm/geometric.hpp>

namespace franken::test {
namespace {

class Flower : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_EQ(runIn(m_folder, MAKE_MODEL " flower.glb flower").code, 0);
        Result<Scene> loaded = loadGltf(m_folder / "flower.glb", {}, [](LogLevel, std::string_view text) {
            ADD_FAILURE() << "a warning: " << text;
        });
        ASSERT_TRUE(loaded) << toString(loaded.error());
        m_scene = *std::move(loaded);
    }

    Pose at(double seconds, Ends ends = Ends::Hold) const {
        Pose pose;
        EXPECT_TRUE(sample(m_scene, 0, seconds, pose, ends));
        return pose;
    }

    std::size_t nodeOf(const std::string& name) const {
        for (std::size_t node = 0; node < m_scene.nodes.size(); ++node)
            if (m_scene.nodes[node].name == name)
                return node;
        ADD_FAILURE() << "there is no node " << name;
        return 0;
    }

    /// Where the flower looks: as at noon, up and to +Z, and turned since by its joints.
    glm::dvec3 lookAt(double seconds) const {
        std::vector<NodeWorld> worlds;
        worldsOf(m_scene, at(seconds), worlds);
        return glm::normalize(glm::dmat3(worlds[nodeOf("head")].matrix) * glm::dvec3(0, 0.368, 0.930));
    }

    const std::filesystem::path m_folder = emptyTestFolder();
    Scene m_scene;
};

TEST_F(Flower, IsOneFileOrMany) {
    const std::string first = readText(m_folder / "flower.glb");
    EXPECT_LT(first.size(), 140000u);
    ASSERT_EQ(runIn(m_folder, MAKE_MODEL " again.glb flower && " MAKE_MODEL " flower.gltf flower").code, 0);
    EXPECT_TRUE(first == readText(m_folder / "again.glb"));
    const Result<Scene> many = loadGltf(m_folder / "flower.gltf");
    ASSERT_TRUE(many) << toString(many.error());
    ASSERT_EQ(many->meshes.size(), m_scene.meshes.size());
    for (std::size_t mesh = 0; mesh < m_scene.meshes.size(); ++mesh)
        EXPECT_TRUE(many->meshes[mesh].primitives[0].positions ==
                    m_scene.meshes[mesh].primitives[0].positions);
    EXPECT_EQ(runIn(m_folder, MAKE_MODEL " other.glb tulip").code, 2);
}

TEST_F(Flower, IsOneSkinWithABlossomOfTwoTargets) {
    EXPECT_TRUE(check(m_scene));
    ASSERT_EQ(m_scene.skins.size(), 1u);
    EXPECT_EQ(m_scene.skins[0].joints.size(), 16u);
    ASSERT_EQ(m_scene.animations.size(), 1u);
    EXPECT_EQ(m_scene.animations[0].name, "day");
    EXPECT_EQ(m_scene.animations[0].duration, 8);
    std::size_t skinned = 0, targets = 0;
    for (const Instance& instance : m_scene.instances) {
        const Primitive& primitive = m_scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives[0];
        skinned += instance.skin == 0;
        targets += primitive.deformation ? primitive.deformation->targets.size() : 0;
    }
    EXPECT_EQ(skinned, 3u);
    EXPECT_EQ(targets, 2u);
    EXPECT_TRUE(m_scene.images.empty());
    EXPECT_EQ(m_scene.cameras.size(), 1u);
    EXPECT_EQ(m_scene.lights.size(), 1u);
}

TEST_F(Flower, RestsAsItWasBoundAndFacesOutwards) {
    std::size_t triangles = 0;
    for (const Instance& instance : m_scene.instances) {
        const Primitive& primitive = m_scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives[0];
        for (std::size_t v = 0; primitive.deformation && v < primitive.positions.size(); ++v) {
            const glm::dvec3 bound(primitive.deformation->bind.positions[v]);
            ASSERT_LT(
                glm::distance(glm::dvec3(instance.world * glm::dvec4(primitive.positions[v], 1)), bound),
                1e-6);
        }
        for (std::size_t i = 0; i < primitive.indices.size(); i += 3) {
            const auto corner = [&](std::size_t n) { return primitive.positions[primitive.indices[i + n]]; };
            const glm::vec3 front = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
            for (std::size_t n = 0; n < 3; ++n)
                ASSERT_GT(glm::dot(front, primitive.normals[primitive.indices[i + n]]), 0)
                    << instance.name << i;
        }
        triangles += primitive.indices.size() / 3;
    }
    EXPECT_GT(triangles, 2000u);
    EXPECT_LT(triangles, 3000u);
}

TEST_F(Flower, TurnsAfterTheSunAndSleepsByNight) {
    EXPECT_LT(lookAt(2).x, -0.4) << "in the morning";
    EXPECT_GT(lookAt(6).x, 0.4) << "in the evening";
    EXPECT_NEAR(lookAt(4).x, 0, 0.1) << "at noon";
    EXPECT_GT(lookAt(4).y, 0.25);
    EXPECT_LT(lookAt(0).y, -0.4) << "at midnight";
    const std::size_t blossom = nodeOf("blossom");
    EXPECT_EQ(at(4).nodes[blossom].weights, (std::vector<float>{0, 0})) << "open";
    EXPECT_EQ(at(0).nodes[blossom].weights, (std::vector<float>{0, 1})) << "closed";
    Light sun = m_scene.lights[0];
    for (const double seconds : {0.0, 2.0, 4.0, 6.0}) {
        std::vector<NodeWorld> worlds;
        worldsOf(m_scene, at(seconds), worlds);
        follow(worlds, sun);
        EXPECT_LT(sun.direction.y, -0.3f) << "it never shines from below";
        if (seconds == 2.0 || seconds == 6.0) {
            EXPECT_GT(sun.direction.x * static_cast<float>(4 - seconds), 0.8f)
                << "from the left in the morning";
        }
    }
}

TEST_F(Flower, TheDayEndsAsItBeginsAndNothingJumps) {
    EXPECT_EQ(at(8), at(0));
    for (int step = 0; step < 80; ++step)
        EXPECT_GT(glm::dot(lookAt(0.1 * step), lookAt(0.1 * step + 0.1)), 0.95) << step;
}

// FNV-1a, 64 bits (Fowler, Noll, Vo). Whoever changes the model on purpose puts the new number here, and the
// new strip into README.md.
TEST_F(Flower, IsTheModelOfTheReadme) {
    ASSERT_EQ(runIn(m_folder, MAKE_MODEL " flower.gltf flower").code, 0);
    std::uint64_t value = 14695981039346656037u;
    for (const char byte : readText(m_folder / "flower.bin"))
        value = (value ^ static_cast<unsigned char>(byte)) * 1099511628211u;
    EXPECT_EQ(value, 0x8d1085ec1b3e3378u);
}

} // namespace
} // namespace franken::test
