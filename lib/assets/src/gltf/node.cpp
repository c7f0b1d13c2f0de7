// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <utility>

#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include "animation/node_world.h"
#include "finite.h"
#include "gltf/accessor.h"
#include "gltf/mesh.h"
#include "gltf/node.h"
#include "gltf/variants.h"

namespace franken::gltf {
namespace {

std::vector<int> sceneRoots(const tinygltf::Model& model) {
    return model.scenes.empty() ? allRoots(model) : model.scenes[at(std::max(model.defaultScene, 0))].nodes;
}

// Of all nodes, those outside the scene too, because a skin's joints may be there.
bool placeNodes(Document& source, std::vector<NodeWorld>& worlds) {
    const tinygltf::Model& model = source.model;
    for (const tinygltf::Node& node : model.nodes)
        worlds.push_back({localMatrix(node), isVisible(node)});
    for (const int node : depthFirst(model, allRoots(model))) {
        for (const int child : model.nodes[at(node)].children)
            worlds[at(child)] = below(worlds[at(node)], worlds[at(child)]);
        if (!isFinite(glm::mat4(worlds[at(node)].matrix))) {
            source.fail("gltf.value", pathOf("nodes", node), "the node's place in the world is not finite");
            if (!source.defer(pathOf("nodes", node)))
                return false;
        }
    }
    return true;
}

/// Walks the nodes of the scene and adds what hangs on them.
class Walker {
public:
    Walker(Document& source, const NodePlaces& places, Scene& scene)
        : m_source(source), m_places(places), m_scene(scene) {}

    bool walk() {
        const tinygltf::Model& model = m_source.model;
        if (!placeNodes(m_source, m_worlds))
            return false;
        if (!model.scenes.empty() && !m_source.need(pathOf("scenes", std::max(model.defaultScene, 0))))
            return false;
        m_scene.instances.reserve(static_cast<std::size_t>(
            std::count_if(model.nodes.begin(), model.nodes.end(),
                          [](const tinygltf::Node& node) { return node.mesh != kNone; })));
        for (const int node : depthFirst(model, sceneRoots(model)))
            if (!need(node) || !addMesh(node) || !addCamera(node) || !addLight(node))
                return false;
        std::stable_sort(m_scene.cameras.begin(), m_scene.cameras.end(),
                         [](const Camera& a, const Camera& b) { return a.index < b.index; });
        return true;
    }

private:
    bool need(int node) { return m_source.need(pathOf("nodes", node)); }
    bool readJointMatrices(int skin, const glm::dvec3& origin, std::vector<glm::mat4>& joints);
    bool findOrReadMesh(int fileMesh, const Pose& pose, int& mesh);
    bool addMesh(int node);
    bool addCamera(int node);
    bool addLight(int node);

    Document& m_source;
    const NodePlaces& m_places;
    Scene& m_scene;
    std::vector<NodeWorld> m_worlds;                             ///< By file node.
    std::map<std::pair<int, std::vector<double>>, int> m_meshes; ///< By file mesh and weights.
};

// As seen from `origin`, so that vertices that floats can hold come out, wherever the skin is.
bool Walker::readJointMatrices(int index, const glm::dvec3& origin, std::vector<glm::mat4>& joints) {
    const tinygltf::Skin& skin = m_source.model.skins[at(index)];
    for (const int joint : skin.joints)
        if (!need(joint))
            return false;
    const std::size_t matrices =
        skin.inverseBindMatrices == kNone ? 0 : m_source.model.accessors[at(skin.inverseBindMatrices)].count;
    if (!m_source.charge(skin.joints.size() + matrices, 2 * sizeof(glm::mat4), pathOf("skins", index)))
        return false;
    joints.assign(skin.joints.size(), glm::mat4(1.0f));
    if (skin.inverseBindMatrices != kNone) {
        std::vector<float> numbers(matrices * 16);
        if (!readFloats(m_source, skin.inverseBindMatrices, numbers))
            return false;
        for (std::size_t j = 0; j < joints.size(); ++j)
            joints[j] = glm::make_mat4(numbers.data() + j * 16);
    }
    for (std::size_t j = 0; j < joints.size(); ++j) {
        glm::dmat4 world = m_worlds[at(skin.joints[j])].matrix;
        world[3] -= glm::dvec4(origin, 0);
        joints[j] = glm::mat4(world * glm::dmat4(joints[j]));
    }
    return true;
}

// A mesh is shared by all nodes that show it with the same weights; a skinned one by none.
bool Walker::findOrReadMesh(int fileMesh, const Pose& pose, int& mesh) {
    const auto key = std::make_pair(fileMesh, pose.weights);
    const auto known = m_meshes.find(key);
    if (pose.joints.empty() && known != m_meshes.end()) {
        mesh = known->second;
        return true;
    }
    Mesh read;
    if (!readMesh(m_source, fileMesh, pose, m_scene, read))
        return false;
    if (!read.primitives.empty()) {
        mesh = static_cast<int>(m_scene.meshes.size());
        m_scene.meshes.push_back(std::move(read));
    }
    if (pose.joints.empty())
        m_meshes.emplace(key, mesh);
    return true;
}

bool Walker::addMesh(int index) {
    const tinygltf::Node& node = m_source.model.nodes[at(index)];
    if (node.mesh == kNone)
        return true;
    const float share =
        static_cast<float>(m_scene.instances.size()) / static_cast<float>(m_source.model.nodes.size());
    if (!m_source.proceed(kReadImages + (1 - kReadImages) * share, "meshes"))
        return false;
    glm::dmat4 world = m_worlds[at(index)].matrix;
    bool mirrored = glm::determinant(glm::dmat3(world)) < 0.0;
    Pose pose;
    pose.weights = node.weights.empty() ? m_source.model.meshes[at(node.mesh)].weights : node.weights;
    if (node.skin != kNone) {
        if (!m_source.need(pathOf("skins", node.skin)))
            return false;
        m_source.warnOnce(kLeftOut, "skins are not animated; the pose of the file is drawn");
        pose.mirrored = std::exchange(mirrored, false);
        const glm::dvec3 origin(m_worlds[at(m_source.model.skins[at(node.skin)].joints[0])].matrix[3]);
        if (!readJointMatrices(node.skin, origin, pose.joints))
            return false;
        world = glm::translate(glm::dmat4(1.0), origin);
    }
    int mesh = kNone;
    if (!findOrReadMesh(node.mesh, pose, mesh))
        return false;
    if (mesh == kNone)
        return true; // nothing in it can be drawn
    m_scene.instances.push_back({.name = node.name,
                                 .mesh = mesh,
                                 .world = world,
                                 .mirrored = mirrored,
                                 .visible = m_worlds[at(index)].visible,
                                 .nodeIndex = node.skin == kNone ? m_places[at(index)] : kNone});
    return true;
}

bool Walker::addCamera(int index) {
    const int number = m_source.model.nodes[at(index)].camera;
    if (number == kNone)
        return true;
    const std::string where = pathOf("cameras", number);
    Camera camera;
    if (!m_source.need(where) || !readCamera(m_source, number, camera))
        return m_source.defer(where); // There are other cameras, or a framing one.
    camera.node = m_source.model.nodes[at(index)].name;
    camera.world = m_worlds[at(index)].matrix;
    camera.nodeIndex = m_places[at(index)];
    m_scene.cameras.push_back(camera);
    return true;
}

bool Walker::addLight(int index) {
    const tinygltf::Node& node = m_source.model.nodes[at(index)];
    const auto found = node.extensions.find("KHR_lights_punctual");
    if (found == node.extensions.end())
        return true;
    const tinygltf::Value& number = found->second.Get("light");
    if (!checkPresent(m_source, number.GetNumberAsInt(), m_source.model.lights.size(),
                      pathOf("nodes", index, "extensions/KHR_lights_punctual/light")))
        return false;
    if (!m_source.need(pathOf("extensions/KHR_lights_punctual/lights", number.GetNumberAsInt())))
        return false;
    Light light;
    if (!isKnownLight(m_source, number.GetNumberAsInt()))
        return true;
    if (!readLight(m_source, number.GetNumberAsInt(), light))
        return false;
    light.nodeIndex = m_places[at(index)];
    place(m_worlds[at(index)].matrix, light);
    m_scene.lights.push_back(light);
    return true;
}

} // namespace

std::vector<bool> materialsInScene(const Document& source) {
    const tinygltf::Model& model = source.model;
    std::vector<bool> used(model.materials.size(), false);
    for (const int node : depthFirst(model, sceneRoots(model)))
        if (const int mesh = model.nodes[at(node)].mesh; mesh != kNone)
            for (const tinygltf::Primitive& primitive : model.meshes[at(mesh)].primitives)
                for (const int material : possibleMaterials(primitive, used.size()))
                    used[at(material)] = true;
    return used;
}

bool readNodes(Document& source, const NodePlaces& places, Scene& scene) {
    readVariants(source, scene);
    return Walker(source, places, scene).walk();
}

} // namespace franken::gltf
