// SPDX-License-Identifier: MIT
// Where an evaluation in float64 by others has vertices, cameras and lights: ../shared/reference/animation.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "franken/pose.h"
#include "gltf_file.h"

using namespace franken;

namespace {

constexpr double kPosition = 1e-4; // Of a model of some metres: floats have 24 bits.
constexpr double kNormal = 0.01;

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
        const auto number = [&](std::size_t i) { return std::stod(cells[i]); };
        Row row{cells[0], cells[2], number(1), std::stoi(cells[3]), std::stoi(cells[4]), std::stoi(cells[5])};
        row.position = {number(6), number(7), number(8)};
        row.hasNormal = !cells[9].empty();
        if (row.hasNormal)
            row.normal = {number(9), number(10), number(11)};
        rows.push_back(row);
    }
    return rows;
}

/// Whether something that hangs on the row's node is where the row says.
class Comparison {
public:
    Comparison(const Scene& scene, const Row& row) : m_scene(scene), m_row(row) {}

    bool run() {
        for (const Camera& camera : m_scene.cameras)
            see(camera.nodeIndex, camera.world[3], -glm::dvec3(camera.world[2]));
        for (const Light& light : m_scene.lights)
            see(light.nodeIndex, light.position, light.direction);
        for (const Instance& instance : m_scene.instances)
            if (m_row.primitive >= 0)
                seeVertex(instance);
        return m_isRight;
    }

private:
    void see(int node, const glm::dvec3& position, const glm::dvec3& direction) {
        if (node == kNone || m_scene.nodes[static_cast<std::size_t>(node)].index != m_row.node)
            return;
        m_isRight = m_isRight ||
                    (glm::distance(position, m_row.position) < kPosition &&
                     (!m_row.hasNormal || glm::distance(glm::normalize(direction), m_row.normal) < kNormal));
    }

    void seeVertex(const Instance& instance) {
        const Mesh& mesh = m_scene.meshes[static_cast<std::size_t>(instance.mesh)];
        if (m_row.primitive >= static_cast<int>(mesh.primitives.size()))
            return;
        const Primitive& primitive = mesh.primitives[static_cast<std::size_t>(m_row.primitive)];
        const auto vertex = static_cast<std::size_t>(m_row.vertex);
        if (vertex >= primitive.positions.size())
            return;
        const glm::dvec4 position(primitive.positions[vertex], 1);
        const glm::dmat3 turn = glm::transpose(glm::inverse(glm::dmat3(instance.world)));
        see(instance.nodeIndex, glm::dvec3(instance.world * position),
            turn * glm::dvec3(primitive.normals[vertex]));
    }

    const Scene& m_scene;
    const Row& m_row;
    bool m_isRight = false;
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
    Pose pose;
    for (const Row& row : rows) {
        const Ends ends = row.beyondEnd == "loop" ? Ends::Loop : Ends::Hold;
        ASSERT_TRUE(sample(*scene, 0, row.time, pose, ends));
        Scene posed = *scene;
        ASSERT_TRUE(applyPose(posed, pose));
        EXPECT_TRUE(Comparison(posed, row).run())
            << row.time << " s (" << row.beyondEnd << "), node " << row.node << ", vertex " << row.vertex;
    }
}

INSTANTIATE_TEST_SUITE_P(Rigid, AnimationReference,
                         testing::Values("BoxAnimated", "Interpolation9", "Animation_Node_05",
                                         "Animation_NodeMisc_01", "MovingCameraAndLights", "EdgeStepAtKey"),
                         [](const auto& model) { return std::string(model.param); });

} // namespace
