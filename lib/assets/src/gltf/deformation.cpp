// SPDX-License-Identifier: MIT
// Morph targets, and the joints of vertices.
#include <algorithm>
#include <string>

#include <glm/common.hpp>

#include "finite.h"
#include "gltf/accessor.h"
#include "gltf/mesh.h"

namespace franken::gltf {
namespace {

/// The differences of one attribute, unless all of them are 0.
template<typename Vector>
bool readDifferences(Document& source, int index, std::vector<Vector>& out) {
    const tinygltf::Accessor& accessor = source.model.accessors[at(index)];
    const std::size_t each = at(width(accessor));
    std::vector<float> numbers;
    if (!source.charge(accessor.count, each * sizeof(float) + sizeof(Vector), pathOf("accessors", index)))
        return false;
    numbers.resize(accessor.count * each);
    if (!readFloats(source, index, numbers))
        return false;
    if (std::all_of(numbers.begin(), numbers.end(), [](float number) { return number == 0.0f; }))
        return true;
    out.assign(accessor.count, Vector(0.0f));
    for (std::size_t i = 0; i < out.size(); ++i)
        for (std::size_t c = 0; c < std::min(each, static_cast<std::size_t>(Vector::length())); ++c)
            out[i][static_cast<int>(c)] = numbers[i * each + c];
    return true;
}

// Of a tangent, the first three: a target never flips the handedness. What the primitive lacks, nothing can
// change: normals and tangents that are computed follow the positions.
bool readTarget(Document& source, const std::string& name, int accessor, const Primitive& primitive,
                Vertices& target) {
    if (name == "POSITION")
        return readDifferences(source, accessor, target.positions);
    if (name == "NORMAL")
        return primitive.normals.empty() || readDifferences(source, accessor, target.normals);
    if (name == "TANGENT")
        return primitive.tangents.empty() || readDifferences(source, accessor, target.tangents);
    for (const std::size_t set : {0, 1})
        if (name == "TEXCOORD_" + std::to_string(set))
            return primitive.uv[set].empty() || readDifferences(source, accessor, target.uv[set]);
    if (name == "COLOR_0")
        return primitive.colors.empty() || readDifferences(source, accessor, target.colors);
    source.warnOnce(kLeftOut, "morph targets of " + name + " are left out");
    return true;
}

/// All sets of joints and weights of a primitive: JOINTS_0 and WEIGHTS_0, which are there, JOINTS_1 and
/// WEIGHTS_1, ...
class InfluenceReader {
public:
    InfluenceReader(Document& source, const tinygltf::Primitive& from, std::string where, std::size_t joints)
        : m_source(source), m_from(from), m_where(std::move(where)), m_jointCount(joints) {}

    bool read(std::size_t vertices, Deformation& deformation) {
        while (const auto* joints = find("JOINTS_")) {
            const int* const weights = find("WEIGHTS_");
            if (weights == nullptr)
                break;
            if (!m_source.charge(vertices, 2 * sizeof(glm::vec4) + 4 * sizeof(Influence), m_where) ||
                !readJoints(m_source, *joints, m_joints.emplace_back()) ||
                !readVectors(m_source, *weights, m_weights.emplace_back()))
                return false;
        }
        if (find("JOINTS_") != nullptr || find("WEIGHTS_") != nullptr)
            m_source.warn(kMended, m_where,
                          "JOINTS_n and WEIGHTS_n come in pairs: what has no partner is left out");
        if (dropNegatives())
            m_source.warn(kMended, m_where, "weights of joints are below 0: they count as 0");
        for (std::size_t v = 0; v < vertices; ++v)
            if (!count(v))
                return false;
        deformation.influencesPerVertex = m_most;
        deformation.influences.assign(vertices * m_most, {});
        for (std::size_t v = 0; v < vertices; ++v)
            store(v, deformation.influences.data() + v * m_most);
        return true;
    }

private:
    const int* find(const std::string& name) const {
        const auto found = m_from.attributes.find(name + std::to_string(m_joints.size()));
        return found == m_from.attributes.end() ? nullptr : &found->second;
    }

    bool dropNegatives() {
        bool found = false;
        for (std::vector<glm::vec4>& set : m_weights)
            for (glm::vec4& weights : set) {
                const glm::vec4 held = glm::max(weights, 0.0f);
                found = found || held != weights;
                weights = held;
            }
        return found;
    }

    template<typename Function>
    bool eachOf(std::size_t vertex, Function function) const {
        for (std::size_t set = 0; set < m_joints.size(); ++set)
            for (int i = 0; i < 4; ++i)
                if (const float weight = m_weights[set][vertex][i]; weight != 0.0f) // Else any joint will do.
                    if (!function(set, m_joints[set][vertex][i], weight))
                        return false;
        return true;
    }

    bool count(std::size_t vertex) {
        std::size_t count = 0;
        const bool good = eachOf(vertex, [&](std::size_t set, std::uint32_t joint, float) {
            ++count;
            return joint < m_jointCount ||
                   m_source.fail("gltf.index-range", m_where + "/attributes/JOINTS_" + std::to_string(set),
                                 "vertex " + std::to_string(vertex) + " names joint " +
                                     std::to_string(joint) + " of " + std::to_string(m_jointCount));
        });
        m_most = std::max(m_most, count);
        return good;
    }

    // Weights of no sum say nothing: the first joint moves the vertex.
    void store(std::size_t vertex, Influence* to) const {
        double sum = 0;
        eachOf(vertex, [&](std::size_t, std::uint32_t, float weight) {
            sum += weight;
            return true;
        });
        if (sum == 0.0) {
            *to = {0, 1.0f};
            return;
        }
        eachOf(vertex, [&](std::size_t, std::uint32_t joint, float weight) {
            *to++ = {joint, static_cast<float>(weight / sum)};
            return true;
        });
    }

    Document& m_source;
    const tinygltf::Primitive& m_from;
    std::string m_where;
    std::size_t m_jointCount;
    std::vector<std::vector<glm::uvec4>> m_joints; ///< By set, then by vertex.
    std::vector<std::vector<glm::vec4>> m_weights;
    std::size_t m_most = 1; ///< Joints of a vertex.
};

} // namespace

bool readDeformation(Document& source, const tinygltf::Primitive& from, const std::string& where,
                     const MeshUse& use, const Primitive& primitive, Deformation& deformation) {
    if (!source.charge(from.targets.size(), sizeof(Vertices) + sizeof(Box), where))
        return false;
    deformation.targets.resize(from.targets.size());
    for (std::size_t t = 0; t < from.targets.size(); ++t)
        for (const auto& [name, accessor] : from.targets[t])
            if (!readTarget(source, name, accessor, primitive, deformation.targets[t]))
                return false;
    return use.joints == 0 ||
           InfluenceReader(source, from, where, use.joints).read(primitive.positions.size(), deformation);
}

} // namespace franken::gltf
