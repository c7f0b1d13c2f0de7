// SPDX-License-Identifier: MIT
#pragma once

#include "franken/scene.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace franken {

/// A ray as boxes are tested against it.
struct RayInverse {
    explicit RayInverse(const glm::dvec3& from, const glm::dvec3& direction);

    /// How far away the ray enters the box, in lengths of its direction; infinity where it misses it, or
    /// enters it beyond `farthest`. Never misses a box because of rounding.
    double entry(const Box& box, double farthest) const;

    glm::dvec3 origin, inverse;
};

/// Boxes of things in a tree, each node of which has a box around all below it.
class BoxTree {
public:
    explicit BoxTree(std::span<const Box> boxes);

    /// Around all; empty where there is none.
    Box bounds() const { return m_nodes.empty() ? Box() : m_nodes.front().box; }

    /// The things in the order in which leaves have them: which one of those that were handed over stands at
    /// each place.
    const std::vector<std::uint32_t>& order() const { return m_order; }

    /// Calls test(place) for each thing whose box the ray enters not beyond `nearest`, which `test` may bring
    /// closer. Nearer nodes come first.
    template<typename Test>
    void visit(const RayInverse& ray, const double& nearest, Test&& test) const;

private:
    struct Node {
        Box box;
        std::uint32_t first; ///< Of its things; or the first of its two nodes, the second of which follows.
        std::uint32_t count; ///< Of its things; 0 for a node with two below it.
    };
    struct Pending {
        std::uint32_t node;
        double entry;
    };
    /// Halving 2^32 things until there is one each takes 32 levels; each leaves one node to come back to.
    static constexpr std::size_t kMaxPending = 33;

    void split(std::uint32_t node, std::span<const Box> boxes);

    std::vector<Node> m_nodes;
    std::vector<std::uint32_t> m_order;
};

template<typename Test>
void BoxTree::visit(const RayInverse& ray, const double& nearest, Test&& test) const {
    if (m_nodes.empty())
        return;
    std::array<Pending, kMaxPending> pending;
    std::size_t count = 0;
    pending[count++] = {0, ray.entry(m_nodes[0].box, nearest)};
    while (count > 0) {
        const auto [index, entry] = pending[--count];
        if (entry > nearest || entry == std::numeric_limits<double>::infinity())
            continue;
        const Node& node = m_nodes[index];
        for (std::uint32_t place = node.first; place < node.first + node.count; ++place)
            test(place);
        if (node.count > 0)
            continue;
        Pending near{node.first, ray.entry(m_nodes[node.first].box, nearest)};
        Pending far{node.first + 1, ray.entry(m_nodes[node.first + 1].box, nearest)};
        if (far.entry < near.entry)
            std::swap(near, far);
        pending[count++] = far;
        pending[count++] = near;
    }
}

} // namespace franken
