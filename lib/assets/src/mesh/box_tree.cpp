// SPDX-License-Identifier: MIT
#include "mesh/box_tree.h"

#include <algorithm>
#include <numeric>

namespace franken {
namespace {

constexpr std::uint32_t kLeaf = 4; // Testing so many is faster than two more boxes.

glm::dvec3 centerOf(const Box& box) { return 0.5 * box.min + 0.5 * box.max; }

int widestAxis(const Box& box) {
    const glm::dvec3 extent = box.max - box.min;
    return extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
}

} // namespace

// Adding 0 makes -0 a 0, so that its inverse has the sign that entry() expects.
RayInverse::RayInverse(const glm::dvec3& from, const glm::dvec3& direction)
    : origin(from),
      inverse(1.0 / (direction.x + 0.0), 1.0 / (direction.y + 0.0), 1.0 / (direction.z + 0.0)) {}

// A direction along a plane makes 0 * infinity where the ray lies in the plane: no number, which no
// comparison holds for, so that such a plane counts as not crossed. The margin is of T. Ize, "Robust BVH Ray
// Traversal", 2013.
double RayInverse::entry(const Box& box, double farthest) const {
    constexpr double kMargin = 1 + 4 * std::numeric_limits<double>::epsilon();
    double near = 0, far = farthest;
    for (int axis = 0; axis < 3; ++axis) {
        double first = (box.min[axis] - origin[axis]) * inverse[axis];
        double second = (box.max[axis] - origin[axis]) * inverse[axis];
        if (first > second)
            std::swap(first, second);
        second *= kMargin;
        near = first > near ? first : near;
        far = second < far ? second : far;
    }
    return near <= far ? near : std::numeric_limits<double>::infinity();
}

BoxTree::BoxTree(std::span<const Box> boxes) : m_order(boxes.size()) {
    std::iota(m_order.begin(), m_order.end(), 0u);
    if (boxes.empty())
        return;
    m_nodes.reserve(boxes.size());
    m_nodes.push_back({{}, 0, static_cast<std::uint32_t>(boxes.size())});
    for (std::uint32_t node = 0; node < m_nodes.size(); ++node) // Grows as it goes.
        split(node, boxes);
}

void BoxTree::split(std::uint32_t index, std::span<const Box> boxes) {
    const auto [ignored, first, count] = m_nodes[index];
    const auto begin = m_order.begin() + first, end = begin + count;
    Box around, centers;
    for (auto thing = begin; thing != end; ++thing) {
        around.add(boxes[*thing].min);
        around.add(boxes[*thing].max);
        centers.add(centerOf(boxes[*thing]));
    }
    m_nodes[index].box = around;
    if (count <= kLeaf)
        return;
    const int axis = widestAxis(centers);
    const std::uint32_t half = count / 2;
    std::nth_element(begin, begin + half, end, [&](std::uint32_t a, std::uint32_t b) {
        return centerOf(boxes[a])[axis] < centerOf(boxes[b])[axis];
    });
    m_nodes[index].first = static_cast<std::uint32_t>(m_nodes.size());
    m_nodes[index].count = 0;
    m_nodes.push_back({{}, first, half});
    m_nodes.push_back({{}, first + half, count - half});
}

} // namespace franken
