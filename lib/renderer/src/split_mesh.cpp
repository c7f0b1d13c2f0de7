// SPDX-License-Identifier: MIT
// Parts of a mesh that have no more vertices and joints than there is room for.
#include "joint_influences.h"

#include <algorithm>
#include <cassert>

namespace franken {
namespace {

class Splitter {
public:
    Splitter(const MeshData& whole, PartLimits limits)
        : m_whole(whole),
          m_limits(limits),
          m_stride(static_cast<std::size_t>(whole.format.stride)),
          m_vertexPlaces(whole.vertices.size() / m_stride, kUnseen) {
        if (whole.format.joints >= 0)
            for (std::size_t vertex = 0; vertex < m_vertexPlaces.size(); ++vertex)
                forEachJoint(vertex, [&](std::uint32_t joint) {
                    if (joint >= m_jointPlaces.size())
                        m_jointPlaces.resize(joint + std::size_t{1}, kUnseen);
                });
    }

    std::vector<MeshData> make() {
        for (std::size_t triangle = 0; triangle + 2 < m_whole.indices.size(); triangle += 3) {
            const std::span<const std::uint32_t, 3> corners(m_whole.indices.data() + triangle, 3);
            if (m_parts.empty() || !hasRoomFor(corners))
                begin();
            for (const std::uint32_t vertex : corners) {
                if (m_vertexPlaces[vertex] == kUnseen)
                    add(vertex);
                m_parts.back().indices.push_back(m_vertexPlaces[vertex]);
            }
        }
        return std::move(m_parts);
    }

private:
    static constexpr std::uint32_t kUnseen = ~std::uint32_t{0};

    template<typename Function>
    void forEachJoint(std::size_t vertex, Function function) const {
        if (m_whole.format.joints < 0)
            return;
        const JointInfluences influences =
            influencesAt(m_whole.format, m_whole.vertices.data() + vertex * m_stride);
        for (std::size_t i = 0; i < influences.joints.size(); ++i)
            if (influences.weights[i] != 0.0f)
                function(static_cast<std::uint32_t>(influences.joints[i]));
    }

    bool hasRoomFor(std::span<const std::uint32_t, 3> corners) const {
        const MeshData& part = m_parts.back();
        std::array<std::uint32_t, 3 * Permutation::kMaxInfluences> added;
        auto end = added.begin();
        for (const std::uint32_t vertex : corners)
            forEachJoint(vertex, [&](std::uint32_t joint) {
                if (m_jointPlaces[joint] == kUnseen && std::find(added.begin(), end, joint) == end)
                    *end++ = joint;
            });
        const auto joints = part.joints.size() + static_cast<std::size_t>(end - added.begin());
        return part.sources.size() + corners.size() <= m_limits.vertices && joints <= m_limits.joints;
    }

    void begin() {
        if (!m_parts.empty()) {
            for (const std::uint32_t vertex : m_parts.back().sources)
                m_vertexPlaces[vertex] = kUnseen;
            for (const std::uint32_t joint : m_parts.back().joints)
                m_jointPlaces[joint] = kUnseen;
        }
        m_parts.push_back({m_whole.format, {}, {}});
    }

    void add(std::uint32_t vertex) {
        MeshData& part = m_parts.back();
        m_vertexPlaces[vertex] = static_cast<std::uint32_t>(part.sources.size());
        part.sources.push_back(vertex);
        const auto from = m_whole.vertices.begin() + static_cast<std::ptrdiff_t>(vertex * m_stride);
        part.vertices.insert(part.vertices.end(), from, from + static_cast<std::ptrdiff_t>(m_stride));
        if (m_whole.format.joints >= 0)
            addJoints(vertex, part);
    }

    void addJoints(std::uint32_t vertex, MeshData& part) {
        forEachJoint(vertex, [&](std::uint32_t joint) {
            if (m_jointPlaces[joint] == kUnseen) {
                m_jointPlaces[joint] = static_cast<std::uint32_t>(part.joints.size());
                part.joints.push_back(joint);
            }
        });
        std::uint8_t* const to = part.vertices.data() + part.vertices.size() - m_stride;
        JointInfluences influences = influencesAt(part.format, to);
        for (std::size_t i = 0; i < influences.joints.size(); ++i) {
            constexpr std::uint32_t kRows = 3;
            const auto joint = static_cast<std::size_t>(influences.joints[i]);
            influences.joints[i] =
                influences.weights[i] == 0.0f ? 0.0f : static_cast<float>(kRows * m_jointPlaces[joint]);
        }
        store(influences, part.format, to);
    }

    const MeshData& m_whole;
    PartLimits m_limits;
    std::size_t m_stride;
    std::vector<std::uint32_t> m_vertexPlaces, m_jointPlaces; ///< In the last part.
    std::vector<MeshData> m_parts;
};

} // namespace

std::vector<MeshData> split(const MeshData& whole, PartLimits limits) {
    assert(limits.vertices >= 3 && limits.joints >= 3 * Permutation::kMaxInfluences);
    return Splitter(whole, limits).make();
}

} // namespace franken
