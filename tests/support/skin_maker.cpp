// SPDX-License-Identifier: MIT
#include "support/skin_maker.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/ext/quaternion_double.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace {

using Json = GltfBuilder::Json;

constexpr int kNone = -1;
constexpr int kRows = 9;

/// The weights in that form, rounded, and what is then pulled with.
template<typename T>
int storeWeights(GltfBuilder& file, Band& band, std::size_t set, int type) {
    const double most = type == GltfBuilder::kFloat ? 1 : type == GltfBuilder::kUByte ? 255 : 65535;
    std::vector<T> values;
    for (std::vector<Pull>& pulls : band.pulls)
        for (std::size_t i = 4 * set; i < 4 * set + 4; ++i) {
            const double weight = i < pulls.size() ? pulls[i].weight * most : 0;
            values.push_back(static_cast<T>(most == 1 ? weight : std::round(weight)));
            if (i < pulls.size())
                pulls[i].weight = static_cast<double>(values.back()) / most;
        }
    return file.accessor("VEC4", type, values, most != 1);
}

template<typename T>
int storeJoints(GltfBuilder& file, const Band& band, std::size_t set, int type) {
    std::vector<T> values;
    for (const std::vector<Pull>& pulls : band.pulls)
        for (std::size_t i = 4 * set; i < 4 * set + 4; ++i)
            values.push_back(i < pulls.size() ? static_cast<T>(pulls[i].joint) : T{});
    return file.accessor("VEC4", type, values);
}

/// With joints; `band` becomes what the file says.
Json skinnedBand(GltfBuilder& file, Band& band, const Form& form) {
    Json primitive = bareBand(file, band);
    for (std::size_t set = 0; 4 * set < band.pulls[0].size(); ++set) {
        primitive["attributes"]["JOINTS_" + std::to_string(set)] =
            form.joints == GltfBuilder::kUByte ? storeJoints<std::uint8_t>(file, band, set, form.joints)
                                               : storeJoints<std::uint16_t>(file, band, set, form.joints);
        primitive["attributes"]["WEIGHTS_" + std::to_string(set)] =
            form.weights == GltfBuilder::kFloat ? storeWeights<float>(file, band, set, form.weights)
            : form.weights == GltfBuilder::kUByte
                ? storeWeights<std::uint8_t>(file, band, set, form.weights)
                : storeWeights<std::uint16_t>(file, band, set, form.weights);
    }
    return primitive;
}

template<typename Vector>
Vector vectorOf(const Json& node, const char* name, Vector vector) {
    if (node.contains(name))
        for (int i = 0; i < static_cast<int>(node[name].size()); ++i)
            vector[i] = node[name][static_cast<std::size_t>(i)].get<double>();
    return vector;
}

glm::dmat4 localOf(const Json& node, bool isTurned) {
    if (node.contains("matrix")) {
        const auto numbers = node["matrix"].get<std::vector<double>>();
        return glm::make_mat4(numbers.data());
    }
    const auto q = vectorOf(node, "rotation", glm::dvec4(0, 0, 0, 1));
    const glm::dmat4 rotation = isTurned ? glm::rotate(glm::dmat4(1), kTurn, glm::dvec3(0, 0, 1))
                                         : glm::mat4_cast(glm::dquat(q.w, q.x, q.y, q.z));
    return glm::translate(glm::dmat4(1), vectorOf(node, "translation", glm::dvec3(0))) * rotation *
           glm::scale(glm::dmat4(1), vectorOf(node, "scale", glm::dvec3(1)));
}

/// A node to the world.
glm::dmat4 worldOf(const Json& json, int node, int turned) {
    const Json& nodes = json["nodes"];
    for (std::size_t parent = 0; parent < nodes.size(); ++parent)
        for (const Json& child : nodes[parent].value("children", Json::array()))
            if (child == node)
                return worldOf(json, static_cast<int>(parent), turned) *
                       localOf(nodes[static_cast<std::size_t>(node)], node == turned);
    return localOf(nodes[static_cast<std::size_t>(node)], node == turned);
}

glm::dvec3 movedBy(const Rig& rig, const Json& json, const glm::dvec3& position,
                   const std::vector<Pull>& pulls, int turned) {
    glm::dvec3 sum(0);
    double weights = 0;
    for (const auto& [joint, weight] : pulls) {
        const auto at = static_cast<std::size_t>(joint);
        sum += weight * glm::dvec3(worldOf(json, rig.joints[at], turned) * rig.inverseBinds[at] *
                                   glm::dvec4(position, 1));
        weights += weight;
    }
    return sum / weights;
}

} // namespace

Band bandOf(int joints, int each, double sum) {
    Band band;
    for (int row = 0; row < kRows; ++row)
        for (const float x : {-0.3f, 0.3f}) {
            const double along = static_cast<double>(row) / (kRows - 1) * (joints - 1);
            const int first = std::clamp(static_cast<int>(std::lround(along - 0.5 * (each - 1))), 0,
                                         std::max(joints - each, 0));
            std::vector<Pull> pulls;
            double total = 0;
            for (int i = 0; i < each; ++i) {
                const double weight = 1 / (1 + (along - first - i) * (along - first - i));
                pulls.push_back({std::min(first + i, joints - 1), weight});
                total += weight;
            }
            for (Pull& pull : pulls)
                pull.weight *= sum / total;
            band.positions.emplace_back(x, 2.0f * static_cast<float>(row) / (kRows - 1), 0);
            band.pulls.push_back(pulls);
        }
    return band;
}

Json bareBand(GltfBuilder& file, const Band& band) {
    std::vector<float> positions, normals;
    for (const glm::vec3& position : band.positions) {
        positions.insert(positions.end(), {position.x, position.y, position.z});
        normals.insert(normals.end(), {0, 0, 1});
    }
    std::vector<std::uint16_t> indices;
    for (int row = 0; row + 1 < kRows; ++row)
        for (const int corner : {0, 1, 3, 0, 3, 2})
            indices.push_back(static_cast<std::uint16_t>(2 * row + corner));
    return {{"attributes",
             {{"POSITION", file.floats("VEC3", positions)}, {"NORMAL", file.floats("VEC3", normals)}}},
            {"indices", file.accessor("SCALAR", GltfBuilder::kUShort, indices)},
            {"material", 0}};
}

int storeBinds(GltfBuilder& file, const Rig& rig) {
    std::vector<float> numbers;
    for (const glm::dmat4& inverse : rig.inverseBinds)
        for (int i = 0; i < 16; ++i)
            numbers.push_back(static_cast<float>(inverse[i / 4][i % 4]));
    return file.floats("MAT4", numbers);
}

SkinMaker::SkinMaker(const char* name, int joints, bool storesInverseBinds)
    : m_storesBinds(storesInverseBinds) {
    odd.name = name;
    Json& json = odd.file.json;
    json["materials"] = {
        {{"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 0.7}}}, {"doubleSided", true}}};
    json["nodes"] = {{{"mesh", 0}, {"skin", 0}}};
    json["scene"] = 0;
    json["scenes"] = {{{"nodes", {0, 1}}}};
    rig = addChain(joints);
    odd.turned = rig.joints.back();
}

Rig SkinMaker::addChain(int joints) {
    Rig chain;
    const double step = 2.0 / std::max(joints - 1, 1), bend = 0.8 / joints;
    for (int j = 0; j < joints; ++j) {
        const bool isFirst = j == 0;
        chain.joints.push_back(odd.file.append(
            "nodes", {{"translation", {isFirst ? 0.1 : 0.02, isFirst ? 0.0 : step, isFirst ? 0.2 : 0.0}},
                      {"rotation", {0, 0, std::sin(bend / 2), std::cos(bend / 2)}}}));
        if (!isFirst)
            node(chain.joints.back() - 1)["children"] = {chain.joints.back()};
        glm::dmat4& inverse = chain.inverseBinds.emplace_back(1);
        inverse[3].y = m_storesBinds ? static_cast<double>(static_cast<float>(-step * j)) : 0;
    }
    Json skin{{"joints", chain.joints}};
    if (m_storesBinds)
        skin["inverseBindMatrices"] = storeBinds(odd.file, chain);
    odd.file.append("skins", skin);
    return chain;
}

void SkinMaker::addMesh(Band& band, const Form& form) {
    odd.file.append("meshes", {{"primitives", Json::array({skinnedBand(odd.file, band, form)})}});
}

void SkinMaker::expect(int node, const Rig& skin, const Band& band, double wider) {
    for (std::size_t v = 0; v < band.positions.size(); ++v) {
        const glm::dvec3 position = glm::dvec3(band.positions[v]) + glm::dvec3(wider, 0, 0);
        odd.expected.push_back({node, true, v, movedBy(skin, odd.file.json, position, band.pulls[v], kNone),
                                movedBy(skin, odd.file.json, position, band.pulls[v], odd.turned)});
    }
}

void SkinMaker::expectStill(int node, const Band& band, double wider) {
    for (std::size_t v = 0; v < band.positions.size(); ++v) {
        const glm::dvec4 position(glm::dvec3(band.positions[v]) + glm::dvec3(wider, 0, 0), 1);
        odd.expected.push_back({node, false, v, worldOf(odd.file.json, node, kNone) * position,
                                worldOf(odd.file.json, node, odd.turned) * position});
    }
}
