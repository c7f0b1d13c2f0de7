// SPDX-License-Identifier: MIT
#pragma once

#include "franken/deform.h"
#include "franken/scene.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <array>
#include <memory>
#include <vector>

/// A figure of CesiumMan's size: a chain of joints that turn, and four influences for each vertex.
namespace franken::bench {

inline constexpr int kJoints = 19, kKeys = 48;
inline constexpr std::size_t kVertices = 3273, kInfluences = 4;
inline constexpr double kDuration = 2;

/// Its nodes, its skin and its animation.
Scene figureScene();
std::shared_ptr<const Deformation> figureDeformation();

/// The same written by hand: keys at equal distances, one parent for each joint, nothing that files may have
/// besides.
struct PlainFigure {
    PlainFigure();

    void move(double seconds);

    std::vector<glm::vec3> positions, normals;

private:
    std::array<std::array<glm::vec4, kKeys>, kJoints> m_rotations; ///< x, y, z, w
    std::vector<glm::vec3> m_bindPositions, m_bindNormals;
    std::vector<Influence> m_influences;
};

} // namespace franken::bench
