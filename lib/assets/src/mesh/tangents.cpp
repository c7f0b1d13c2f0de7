// SPDX-License-Identifier: MIT
#include "franken/tangents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/vertices.h"

namespace franken {
namespace {

using Index = std::uint32_t;
constexpr Index kNoIndex = 0xFFFFFFFF;

/// A set of corners that grows together. A corner is an index into Primitive::indices: 3 * triangle + 0..2.
class UnionFind {
public:
    explicit UnionFind(std::size_t size) : m_parent(size) { std::iota(m_parent.begin(), m_parent.end(), 0u); }

    Index find(Index i) {
        while (m_parent[i] != i)
            i = m_parent[i] = m_parent[m_parent[i]];
        return i;
    }
    /// The set of `from` becomes part of that of `into`, whose root stays.
    void join(Index into, Index from) { m_parent[find(from)] = find(into); }

private:
    std::vector<Index> m_parent;
};

/// What one triangle says: where u grows on it, and how its UVs turn.
struct Triangle {
    glm::vec3 dPdu{0.0f};    ///< Unit length, or zero where the UVs have no area.
    bool preserving = false; ///< Its UVs turn as its positions do.
    bool oriented = false;   ///< `preserving` is known.
    bool degenerate = false; ///< Two of its positions are equal.
    std::array<Index, 3> neighbor{kNoIndex, kNoIndex, kNoIndex}; ///< Over edge i, from corner i to i + 1.
};

class Builder {
public:
    Builder(Primitive& primitive, std::span<const glm::vec2> uv)
        : m_primitive(primitive),
          m_uv(uv),
          m_triangles(primitive.indices.size() / 3),
          m_groups(primitive.indices.size()) {}

    void build() {
        weld();
        for (Index t = 0; t < m_triangles.size(); ++t)
            measure(t);
        findNeighbors();
        orientFlatOnes();
        joinGroups();
        sumGroups();
        adoptDegenerates();
        store();
    }

private:
    void weld();
    void measure(Index triangle);
    void findNeighbors();
    void orientFlatOnes();
    void joinGroups();
    void sumGroups();
    void adoptDegenerates();
    void store();

    const glm::vec3& position(Index corner) const {
        return m_primitive.positions[m_primitive.indices[corner]];
    }
    const glm::vec3& normal(Index corner) const { return m_primitive.normals[m_primitive.indices[corner]]; }
    const glm::vec2& uv(Index corner) const { return m_uv[m_primitive.indices[corner]]; }
    Index welded(Index corner) const { return m_welded[m_primitive.indices[corner]]; }

    Primitive& m_primitive;
    std::span<const glm::vec2> m_uv;
    std::vector<Index> m_welded; ///< For each vertex the first one that equals it.
    std::vector<Triangle> m_triangles;
    UnionFind m_groups;                ///< Over corners.
    std::vector<glm::vec4> m_tangents; ///< For each corner that is the root of a group.
};

Index next(Index corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
Index previous(Index corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }

glm::vec3 unit(const glm::vec3& vector) {
    const float length = glm::length(vector);
    return length > 0.0f ? vector / length : glm::vec3(0.0f);
}

glm::vec3 onPlane(const glm::vec3& vector, const glm::vec3& normal) {
    return unit(vector - glm::dot(vector, normal) * normal);
}

glm::vec3 anyOnPlane(const glm::vec3& normal) {
    return onPlane(std::fabs(normal.x) < 0.7f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0), normal);
}

void Builder::weld() {
    const auto key = [this](Index i) {
        const glm::vec3 &p = m_primitive.positions[i], &n = m_primitive.normals[i];
        return std::make_tuple(p.x, p.y, p.z, n.x, n.y, n.z, m_uv[i].x, m_uv[i].y);
    };
    std::vector<Index> order(m_primitive.positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });
    m_welded.resize(order.size());
    Index first = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i == 0 || key(order[i]) != key(order[i - 1]))
            first = order[i];
        m_welded[order[i]] = first;
    }
}

void Builder::measure(Index t) {
    Triangle& triangle = m_triangles[t];
    const Index c = 3 * t;
    triangle.degenerate = position(c) == position(c + 1) || position(c + 1) == position(c + 2) ||
                          position(c + 2) == position(c);
    const glm::vec3 e1 = position(c + 1) - position(c), e2 = position(c + 2) - position(c);
    const glm::vec2 t1 = uv(c + 1) - uv(c), t2 = uv(c + 2) - uv(c);
    const float area = t1.x * t2.y - t1.y * t2.x;
    triangle.oriented = area != 0.0f && !triangle.degenerate;
    triangle.preserving = area > 0.0f;
    if (triangle.oriented)
        triangle.dPdu = unit((t2.y * e1 - t1.y * e2) * (area > 0.0f ? 1.0f : -1.0f));
}

// Two triangles are neighbours over an edge that they run along in opposite directions. Where more than two
// share an edge, they are paired in the order of the file.
void Builder::findNeighbors() {
    std::unordered_multimap<std::uint64_t, Index> open; // directed edge -> its first corner
    const auto edge = [](Index from, Index to) { return std::uint64_t{from} << 32 | to; };
    for (Index corner = 0; corner < 3 * m_triangles.size(); ++corner) {
        if (m_triangles[corner / 3].degenerate)
            continue;
        const Index from = welded(corner), to = welded(next(corner));
        const auto match = open.find(edge(to, from));
        if (match == open.end()) {
            open.emplace(edge(from, to), corner);
            continue;
        }
        m_triangles[corner / 3].neighbor[corner % 3] = match->second / 3;
        m_triangles[match->second / 3].neighbor[match->second % 3] = corner / 3;
        open.erase(match);
    }
}

// A triangle whose UVs have no area goes with the side of a neighbour that has some.
void Builder::orientFlatOnes() {
    std::vector<Index> queue;
    for (Index t = 0; t < m_triangles.size(); ++t)
        if (m_triangles[t].oriented)
            queue.push_back(t);
    for (std::size_t head = 0; head < queue.size(); ++head) {
        const Triangle& from = m_triangles[queue[head]];
        for (const Index to : from.neighbor) {
            if (to == kNoIndex || m_triangles[to].oriented)
                continue;
            m_triangles[to].oriented = true;
            m_triangles[to].preserving = from.preserving;
            queue.push_back(to);
        }
    }
}

void Builder::joinGroups() {
    for (Index corner = 0; corner < 3 * m_triangles.size(); ++corner) {
        const Index other = m_triangles[corner / 3].neighbor[corner % 3];
        if (other == kNoIndex || m_triangles[other].preserving != m_triangles[corner / 3].preserving)
            continue;
        for (Index theirs = 3 * other; theirs < 3 * other + 3; ++theirs)
            for (const Index ours : {corner, next(corner)})
                if (welded(ours) == welded(theirs))
                    m_groups.join(ours, theirs);
    }
}

void Builder::sumGroups() {
    m_tangents.assign(m_primitive.indices.size(), glm::vec4(0.0f));
    for (Index corner = 0; corner < 3 * m_triangles.size(); ++corner) {
        const Triangle& triangle = m_triangles[corner / 3];
        if (triangle.degenerate)
            continue;
        const glm::vec3& n = normal(corner);
        const glm::vec3 a = onPlane(position(next(corner)) - position(corner), n);
        const glm::vec3 b = onPlane(position(previous(corner)) - position(corner), n);
        const float angle = std::acos(glm::clamp(glm::dot(a, b), -1.0f, 1.0f));
        glm::vec4& sum = m_tangents[m_groups.find(corner)];
        sum += glm::vec4(angle * onPlane(triangle.dPdu, n), 0.0f);
        sum.w = triangle.oriented && triangle.preserving ? -1.0f : 1.0f; // v grows downwards
    }
    for (Index corner = 0; corner < m_tangents.size(); ++corner) {
        if (m_groups.find(corner) != corner || m_triangles[corner / 3].degenerate)
            continue;
        const glm::vec3 tangent = unit(glm::vec3(m_tangents[corner]));
        m_tangents[corner] = glm::vec4(tangent == glm::vec3(0.0f) ? anyOnPlane(normal(corner)) : tangent,
                                       m_tangents[corner].w);
    }
}

// A corner of a triangle without area takes the tangent that another triangle gave to its vertex.
void Builder::adoptDegenerates() {
    std::vector<Index> giver(m_primitive.positions.size(), kNoIndex);
    for (Index corner = 0; corner < 3 * m_triangles.size(); ++corner)
        if (!m_triangles[corner / 3].degenerate && giver[welded(corner)] == kNoIndex)
            giver[welded(corner)] = corner;
    for (Index corner = 0; corner < 3 * m_triangles.size(); ++corner) {
        if (!m_triangles[corner / 3].degenerate)
            continue;
        if (giver[welded(corner)] != kNoIndex)
            m_groups.join(giver[welded(corner)], corner);
        else
            m_tangents[corner] = glm::vec4(anyOnPlane(normal(corner)), 1.0f);
    }
}

// The first group at a vertex keeps it; each other one gets a copy.
void Builder::store() {
    std::vector<Index> owner(m_primitive.positions.size(), kNoIndex);
    std::unordered_map<std::uint64_t, Index> copies; // (vertex, group) -> the copy
    std::vector<Index> sources(owner.size());        // Of each vertex, the one that it is a copy of.
    std::iota(sources.begin(), sources.end(), 0u);
    std::vector<glm::vec4> tangents(owner.size(), glm::vec4(1.0f, 0.0f, 0.0f, 1.0f));
    for (Index corner = 0; corner < m_primitive.indices.size(); ++corner) {
        const Index vertex = m_primitive.indices[corner], group = m_groups.find(corner);
        if (owner[vertex] == kNoIndex) {
            owner[vertex] = group;
            tangents[vertex] = m_tangents[group];
        }
        if (owner[vertex] == group)
            continue;
        const auto copy = static_cast<Index>(sources.size());
        const auto [known, isNew] = copies.emplace(std::uint64_t{vertex} << 32 | group, copy);
        m_primitive.indices[corner] = known->second;
        if (isNew) {
            sources.push_back(vertex);
            tangents.push_back(m_tangents[group]);
        }
    }
    m_primitive.tangents.clear();
    if (sources.size() > owner.size())
        gather(m_primitive, sources);
    m_primitive.tangents = std::move(tangents);
}

} // namespace

void computeTangents(Primitive& primitive, std::span<const glm::vec2> uv) { Builder(primitive, uv).build(); }

std::vector<glm::vec2> sampledUv(const Primitive& primitive, const TextureRef& texture) {
    std::vector<glm::vec2> uv = primitive.uv[texture.uvSet];
    if (texture.transformed)
        for (glm::vec2& point : uv)
            point = glm::vec2(texture.transform * glm::vec3(point, 1.0f));
    return uv;
}

} // namespace franken
