// SPDX-License-Identifier: MIT
// Where an evaluation in float64 by others has vertices, cameras and lights: ../shared/reference/animation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "franken/pose.h"
#include "gltf_file.h"

using namespace franken;

namespace {

// Of what nodes move, found: 3e-9 of the size, and 7e-7. Vertices are floats, and poses doubles.
constexpr double kPosition = 1e-7; // Of the model's size at rest.
constexpr double kNormal = 1e-5;
// Of skins and morphs, which floats move.
constexpr double kMovedPosition = 2e-6;
constexpr double kMovedNormal = 1e-4;

struct Row {
    std::string model, beyondEnd;
    double time = 0;
    int node = 0, primitive = 0, vertex = 0;
    glm::dvec3 position{0}, normal{0};
    bool hasNormal = false;
};

std::vector<Row> rowsOf(const std::filesystem::path& file, const std::string& model) {
    std::ifstream in(file);
    std::vector<Row> rows;
    for (std::string line; std::getline(in, line);) {
        std::vector<std::string> cells;
        std::istringstream text(line);
        for (std::string cell; std::getline(text, cell, ',');)
            cells.push_back(cell);
        if (cells[0] != model)
            continue;
        cells.resize(12);
        const auto number = [&](std::size_t i) { return cells[i].empty() ? 0 : std::stod(cells[i]); };
        Row row{cells[0], cells[2], number(1), std::stoi(cells[3]), std::stoi(cells[4]), std::stoi(cells[5])};
        row.position = {number(6), number(7), number(8)};
        row.hasNormal = !cells[9].empty();
        if (row.hasNormal)
            row.normal = {number(9), number(10), number(11)};
        rows.push_back(row);
    }
    return rows;
}

/// Whether what hangs on the row's node is where the row says: the vertex, or the cameras and lights.
class Comparison {
public:
    Comparison(const Scene& scene, const Row& row, double size) : m_scene(scene), m_row(row), m_size(size) {}

    void run() {
        if (m_row.primitive >= 0) {
            for (const Instance& instance : m_scene.instances)
                if (isOn(instance.nodeIndex))
                    seeVertex(instance);
        } else {
            for (const Camera& camera : m_scene.cameras)
                if (isOn(camera.nodeIndex))
                    see(camera.world[3], -glm::dvec3(camera.world[2]));
            for (const Light& light : m_scene.lights)
                if (isOn(light.nodeIndex))
                    see(light.position, light.direction);
        }
        EXPECT_EQ(m_seen, 1);
    }

private:
    bool isOn(int node) const {
        return node != kNone && m_scene.nodes[static_cast<std::size_t>(node)].index == m_row.node;
    }

    void see(const glm::dvec3& position, const glm::dvec3& direction) {
        ++m_seen;
        EXPECT_LT(glm::distance(position, m_row.position), (m_moved ? kMovedPosition : kPosition) * m_size);
        if (m_row.hasNormal) {
            EXPECT_LT(glm::distance(glm::normalize(direction), m_row.normal),
                      m_moved ? kMovedNormal : kNormal);
        }
    }

    /// Flat triangles share no vertices any more: of those that the file's has become, any will do.
    std::size_t vertexOf(const Instance& instance, const Primitive& primitive) const {
        if (!primitive.deformation || !primitive.deformation->flat)
            return static_cast<std::size_t>(m_row.vertex);
        const auto distance = [&](const glm::vec3& position) {
            return glm::distance(glm::dvec3(instance.world * glm::dvec4(position, 1)), m_row.position);
        };
        return static_cast<std::size_t>(
            std::min_element(primitive.positions.begin(), primitive.positions.end(),
                             [&](const auto& a, const auto& b) { return distance(a) < distance(b); }) -
            primitive.positions.begin());
    }

    void seeVertex(const Instance& instance) {
        const Primitive& primitive = m_scene.meshes.at(static_cast<std::size_t>(instance.mesh))
                                         .primitives.at(static_cast<std::size_t>(m_row.primitive));
        const std::size_t vertex = vertexOf(instance, primitive);
        const glm::dvec4 position(primitive.positions.at(vertex), 1);
        const glm::dmat3 turn = glm::transpose(glm::inverse(glm::dmat3(instance.world)));
        m_moved = primitive.deformation != nullptr;
        see(glm::dvec3(instance.world * position), turn * glm::dvec3(primitive.normals.at(vertex)));
    }

    const Scene& m_scene;
    const Row& m_row;
    double m_size;
    bool m_moved = false; ///< Its vertices, by a skin or a morph.
    int m_seen = 0;
};

class AnimationReference : public testing::TestWithParam<const char*> {};

TEST_P(AnimationReference, IsWhereDoublesHaveIt) {
    const std::filesystem::path folder = sharedFolder() / "reference/animation";
    if (!std::filesystem::exists(folder))
        GTEST_SKIP() << folder << " is not there";
    const auto scene = loadGltf(folder / (std::string(GetParam()) + ".glb"));
    ASSERT_TRUE(scene) << toString(scene.error());
    const std::vector<Row> rows = rowsOf(folder / "vertices.csv", GetParam());
    ASSERT_FALSE(rows.empty());
    const Box bounds = scene->bounds();
    const double size = glm::distance(bounds.min, bounds.max);
    Pose pose;
    for (const Row& row : rows) {
        const Ends ends = row.beyondEnd == "loop" ? Ends::Loop : Ends::Hold;
        if (scene->animations.empty())
            pose = restPose(*scene);
        else
            ASSERT_TRUE(sample(*scene, 0, row.time, pose, ends));
        Scene posed = *scene;
        ASSERT_TRUE(applyPose(posed, pose));
        SCOPED_TRACE(std::to_string(row.time) + " s (" + row.beyondEnd + "), node " +
                     std::to_string(row.node) + ", vertex " + std::to_string(row.vertex));
        Comparison(posed, row, size).run();
    }
}

INSTANTIATE_TEST_SUITE_P(Rigid, AnimationReference,
                         testing::Values("BoxAnimated", "Interpolation9", "Animation_Node_05",
                                         "Animation_NodeMisc_01", "MovingCameraAndLights", "EdgeStepAtKey"),
                         [](const auto& model) { return std::string(model.param); });
INSTANTIATE_TEST_SUITE_P(Deformed, AnimationReference,
                         testing::Values("AnimatedMorphCube", "SimpleMorph", "EdgeOneMorphTarget",
                                         "RiggedSimple", "CesiumMan", "Fox", "Animation_Skin_05",
                                         "Animation_Skin_08", "Animation_SkinType_02", "MirroredArmature",
                                         "EdgeSkinNoInverseBind"),
                         [](const auto& model) { return std::string(model.param); });

} // namespace
