// SPDX-License-Identifier: MIT
#include "gltf/skeleton.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

namespace franken::gltf {
namespace {

/// The transform that multiplies to the matrix, if there is one: without shear, and without an axis of no
/// length, whose direction is lost.
std::optional<Transform> transformOf(const glm::dmat4& matrix) {
    constexpr double kRounding = 1e-5; // Of files, whose numbers are often floats.
    glm::dmat3 axes(matrix);
    Transform transform;
    transform.translation = glm::dvec3(matrix[3]);
    for (int axis = 0; axis < 3; ++axis) {
        transform.scale[axis] = glm::length(axes[axis]);
        if (!(transform.scale[axis] > 0.0))
            return std::nullopt;
        axes[axis] /= transform.scale[axis];
    }
    if (glm::determinant(axes) < 0.0) {
        transform.scale.x = -transform.scale.x;
        axes[0] = -axes[0];
    }
    const double skew =
        std::max({std::fabs(glm::dot(axes[0], axes[1])), std::fabs(glm::dot(axes[1], axes[2])),
                  std::fabs(glm::dot(axes[2], axes[0]))});
    if (!(skew < kRounding))
        return std::nullopt;
    transform.rotation = glm::normalize(glm::quat_cast(axes));
    return transform;
}

Transform writtenTransform(const tinygltf::Node& node) {
    Transform transform;
    if (!node.rotation.empty())
        transform.rotation =
            glm::dquat(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
    if (!node.scale.empty())
        transform.scale = glm::make_vec3(node.scale.data());
    if (!node.translation.empty())
        transform.translation = glm::make_vec3(node.translation.data());
    return transform;
}

std::size_t targetsOf(const tinygltf::Mesh& mesh) {
    std::size_t most = 0;
    for (const tinygltf::Primitive& primitive : mesh.primitives)
        most = std::max(most, primitive.targets.size());
    return most;
}

bool readWeights(Document& source, const tinygltf::Node& from, const std::string& where, NodeState& rest) {
    if (from.mesh == kNone)
        return true;
    const tinygltf::Mesh& mesh = source.model.meshes[at(from.mesh)];
    const std::size_t targets = targetsOf(mesh);
    if (!source.charge(targets, sizeof(float), where))
        return false;
    const std::vector<double>& weights = from.weights.empty() ? mesh.weights : from.weights;
    rest.weights.assign(targets, 0.0f);
    for (std::size_t t = 0; t < std::min(targets, weights.size()); ++t)
        rest.weights[t] = static_cast<float>(weights[t]);
    return true;
}

// A node with a fault is somewhere, if nothing that is drawn needs it.
bool readNode(Document& source, int index, Node& node) {
    const tinygltf::Node& from = source.model.nodes[at(index)];
    const std::string where = pathOf("nodes", index);
    node.name = from.name;
    node.index = index;
    if (source.faults.contains(where))
        return true;
    node.rest.visible = isVisible(from);
    if (from.matrix.empty()) {
        node.rest.local = writtenTransform(from);
    } else {
        const glm::dmat4 matrix = localMatrix(from);
        if (const std::optional<Transform> transform = transformOf(matrix))
            node.rest.local = *transform;
        else
            node.matrix = matrix;
    }
    return readWeights(source, from, where, node.rest);
}

} // namespace

std::vector<int> depthFirst(const tinygltf::Model& model, const std::vector<int>& roots) {
    std::vector<int> order, stack(roots.rbegin(), roots.rend());
    std::vector<bool> seen(model.nodes.size(), false);
    while (!stack.empty()) {
        const int node = stack.back();
        stack.pop_back();
        if (seen[at(node)])
            continue; // There are exporters that list a child among the scene's nodes.
        seen[at(node)] = true;
        order.push_back(node);
        const std::vector<int>& children = model.nodes[at(node)].children;
        stack.insert(stack.end(), children.rbegin(), children.rend());
    }
    return order;
}

std::vector<int> allRoots(const tinygltf::Model& model) {
    std::vector<bool> isChild(model.nodes.size(), false);
    for (const tinygltf::Node& node : model.nodes)
        for (const int child : node.children)
            isChild[at(child)] = true;
    std::vector<int> roots;
    for (std::size_t i = 0; i < isChild.size(); ++i)
        if (!isChild[i])
            roots.push_back(static_cast<int>(i));
    return roots;
}

bool isVisible(const tinygltf::Node& node) {
    const auto found = node.extensions.find("KHR_node_visibility");
    return found == node.extensions.end() || !found->second.Has("visible") ||
           found->second.Get("visible").Get<bool>();
}

glm::dmat4 localMatrix(const tinygltf::Node& node) {
    return node.matrix.empty() ? matrixOf(writtenTransform(node)) : glm::make_mat4(node.matrix.data());
}

bool readSkeleton(Document& source, Scene& scene, NodePlaces& places) {
    const tinygltf::Model& model = source.model;
    places.assign(model.nodes.size(), kNone);
    if (model.nodes.size() > source.room() / (2 * sizeof(Node))) {
        source.warn(kLeftOut, "/nodes", "there are more nodes than there is memory to move: nothing moves");
        return true;
    }
    if (!source.charge(model.nodes.size(), sizeof(Node), "/nodes"))
        return false;
    scene.nodes.reserve(model.nodes.size());
    for (const int index : depthFirst(model, allRoots(model))) {
        places[at(index)] = static_cast<int>(scene.nodes.size());
        if (!readNode(source, index, scene.nodes.emplace_back()))
            return false;
    }
    for (std::size_t parent = 0; parent < model.nodes.size(); ++parent)
        for (const int child : model.nodes[parent].children)
            scene.nodes[at(places[at(child)])].parent = places[parent];
    return true;
}

} // namespace franken::gltf
