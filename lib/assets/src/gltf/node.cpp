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
#include "gltf/instancing.h"
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
        for (const int node : depthFirst(model, sceneRoots(model))) {
            if (!need(node) || !addMesh(node) || !addCamera(node) || !addLight(node))
                return false;
            ++m_walked;
        }
        std::stable_sort(m_scene.cameras.begin(), m_scene.cameras.end(),
                         [](const Camera& a, const Camera& b) { return a.index < b.index; });
        return true;
    }

private:
    bool need(int node) { return m_source.need(pathOf("nodes", node)); }
    bool readSkin(int index, const Skin*& skin);
    bool findOrReadMesh(int fileMesh, const MeshUse& use, int& mesh);
    bool addMesh(int node);
    bool addPart(int node, const MeshUse& use, const std::vector<glm::dmat4>& offsets, const Skin* skin);
    bool moveToRest(int node, const MeshUse& use, const Instance& instance, const Palette& palette);
    bool addCamera(int node);
    bool addLight(int node);

    Document& m_source;
    const NodePlaces& m_places;
    Scene& m_scene;
    std::size_t m_walked = 0;                            ///< Nodes.
    std::vector<NodeWorld> m_worlds;                     ///< By file node.
    std::map<std::pair<int, MeshUse>, int> m_still;      ///< From file meshes to Scene::meshes.
    std::map<std::pair<int, MeshUse>, Mesh> m_deforming; ///< By file mesh, as nothing has moved them.
    std::map<int, Skin> m_skins;                         ///< By file skin; joints are nodes of the file.
    std::map<int, int> m_skinPlaces;                     ///< From file skins to Scene::skins.
};

bool Walker::readSkin(int index, const Skin*& out) {
    if (!m_source.need(pathOf("skins", index)))
        return false;
    const tinygltf::Skin& from = m_source.model.skins[at(index)];
    for (const int joint : from.joints)
        if (!need(joint))
            return false;
    // The palette of each use is charged, and for the first, all that is kept.
    constexpr std::size_t kBytes = 2 * (sizeof(int) + sizeof(glm::mat4)) + sizeof(float[16]);
    const auto [place, isNew] = m_skins.try_emplace(index);
    if (!m_source.charge(from.joints.size(), sizeof(glm::mat4x3) + (isNew ? kBytes : 0),
                         pathOf("skins", index)))
        return false;
    Skin& skin = place->second;
    out = &skin;
    if (!isNew)
        return true;
    skin = {.name = from.name, .index = index, .joints = from.joints};
    skin.inverseBinds.assign(skin.joints.size(), glm::mat4(1.0f));
    if (from.inverseBindMatrices != kNone) {
        const std::size_t count = m_source.model.accessors[at(from.inverseBindMatrices)].count;
        std::vector<float> numbers;
        if (!m_source.charge(count, sizeof(glm::mat4), pathOf("skins", index)))
            return false;
        numbers.resize(count * 16);
        if (!readFloats(m_source, from.inverseBindMatrices, numbers))
            return false;
        for (std::size_t j = 0; j < skin.joints.size(); ++j)
            skin.inverseBinds[j] = glm::make_mat4(numbers.data() + j * 16);
    }
    if (m_scene.nodes.empty())
        return true;
    m_skinPlaces[index] = static_cast<int>(m_scene.skins.size());
    Skin& placed = m_scene.skins.emplace_back(skin);
    for (int& joint : placed.joints)
        joint = m_places[at(joint)];
    return true;
}

bool deforms(const Mesh& mesh) {
    return std::any_of(mesh.primitives.begin(), mesh.primitives.end(),
                       [](const Primitive& primitive) { return primitive.deformation != nullptr; });
}

// A mesh is shared by all nodes that show it, unless these can move its vertices: then each has a copy.
bool Walker::findOrReadMesh(int fileMesh, const MeshUse& use, int& mesh) {
    const auto key = std::make_pair(fileMesh, use);
    mesh = static_cast<int>(m_scene.meshes.size());
    if (const auto still = m_still.find(key); still != m_still.end()) {
        mesh = still->second;
        return true;
    }
    if (const auto deforming = m_deforming.find(key); deforming != m_deforming.end()) {
        m_scene.meshes.push_back(deforming->second);
        return true;
    }
    Mesh read;
    if (!readMesh(m_source, fileMesh, use, m_scene, read))
        return false;
    if (deforms(read)) {
        m_deforming.emplace(key, read);
    } else {
        if (read.primitives.empty())
            mesh = kNone; // Nothing in it can be drawn.
        m_still.emplace(key, mesh);
    }
    if (mesh != kNone)
        m_scene.meshes.push_back(std::move(read));
    return true;
}

bool Walker::addMesh(int index) {
    const tinygltf::Node& node = m_source.model.nodes[at(index)];
    if (node.mesh == kNone)
        return true;
    const float share = static_cast<float>(m_walked) / static_cast<float>(m_source.model.nodes.size());
    if (!m_source.proceed(kReadImages + (1 - kReadImages) * share, "meshes"))
        return false;
    MeshUse use;
    use.weights = node.weights.empty() ? m_source.model.meshes[at(node.mesh)].weights : node.weights;
    std::vector<glm::dmat4> offsets;
    if (!readOffsets(m_source, index, offsets))
        return false;
    if (node.skin == kNone)
        return addPart(index, use, offsets, nullptr);
    const Skin* skin = nullptr;
    if (!readSkin(node.skin, skin))
        return false;
    const MeshUse skinned{MeshUse::Part::Skinned, skin->joints.size(), use.weights};
    use.part = MeshUse::Part::Unskinned;
    return addPart(index, skinned, offsets, skin) && addPart(index, use, offsets, nullptr);
}

bool Walker::addPart(int index, const MeshUse& use, const std::vector<glm::dmat4>& offsets,
                     const Skin* skin) {
    const tinygltf::Node& node = m_source.model.nodes[at(index)];
    const NodeWorld& world = m_worlds[at(index)];
    int mesh = kNone;
    if (!findOrReadMesh(node.mesh, use, mesh))
        return false;
    if (mesh == kNone)
        return true;
    for (const glm::dmat4& offset : offsets)
        m_scene.instances.push_back({.name = node.name,
                                     .mesh = mesh,
                                     .world = world.matrix * offset,
                                     .mirrored = glm::determinant(glm::dmat3(world.matrix * offset)) < 0.0,
                                     .visible = world.visible,
                                     .nodeIndex = m_places[at(index)],
                                     .offset = offset});
    if (!deforms(m_scene.meshes[at(mesh)]))
        return true;
    Instance& instance = m_scene.instances.back();
    Palette palette;
    if (skin != nullptr) {
        paletteOf(*skin, m_worlds, palette);
        instance.world = glm::translate(glm::dmat4(1.0), palette.origin);
        instance.skin = m_scene.nodes.empty() ? kNone : m_skinPlaces.at(node.skin);
    }
    return moveToRest(index, use, instance, palette);
}

bool Walker::moveToRest(int index, const MeshUse& use, const Instance& instance, const Palette& palette) {
    constexpr std::size_t kVertexBytes = 72; // All attributes of a Primitive.
    const std::vector<float> weights(use.weights.begin(), use.weights.end());
    for (Primitive& primitive : m_scene.meshes[at(instance.mesh)].primitives) {
        if (!m_source.charge(primitive.positions.size(), kVertexBytes, pathOf("nodes", index)) ||
            !m_source.charge(primitive.indices.size(), sizeof(std::uint32_t), pathOf("nodes", index)))
            return false;
        deform(primitive, {.weights = weights, .joints = palette.joints, .mirrored = instance.mirrored});
        if (!std::all_of(primitive.positions.begin(), primitive.positions.end(), isFinite<glm::vec3>))
            return m_source.fail("gltf.value", pathOf("nodes", index),
                                 "the pose moves a vertex out of the range of floats");
        if (m_scene.nodes.empty())
            primitive.deformation.reset();
    }
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
