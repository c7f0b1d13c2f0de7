// SPDX-License-Identifier: MIT
#include <cmath>

#include "gltf/document.h"

namespace franken::gltf {

bool checkPresent(Source& source, int index, std::size_t size, const std::string& where) {
    if (index >= 0 && at(index) < size)
        return true;
    return source.fail("gltf.index-range", where,
                       "the index " + std::to_string(index) + " is out of range: there are only " +
                           std::to_string(size));
}

bool checkIndex(Source& source, int index, std::size_t size, const std::string& where) {
    return index == kNone || checkPresent(source, index, size, where);
}

bool checkFinite(Source& source, const std::vector<double>& numbers, const std::string& where) {
    for (const double number : numbers)
        if (!std::isfinite(static_cast<float>(number)))
            return source.fail("gltf.value", where, "a number is not finite");
    return true;
}

namespace {

bool checkLength(Document& source, const std::vector<double>& numbers, std::size_t length,
                 const std::string& where) {
    if (!numbers.empty() && numbers.size() != length)
        return source.fail("gltf.type", where, std::to_string(length) + " numbers are expected here");
    return checkFinite(source, numbers, where);
}

bool checkAllPresent(Document& source, const std::vector<int>& indices, std::size_t size,
                     const std::string& where) {
    for (std::size_t i = 0; i < indices.size(); ++i)
        if (!checkPresent(source, indices[i], size, where + pathOf(i)))
            return false;
    return true;
}

bool checkNode(Document& source, std::size_t index) {
    const tinygltf::Model& model = source.model;
    const tinygltf::Node& node = model.nodes[index];
    const std::string where = pathOf("nodes", index);
    return checkIndex(source, node.mesh, model.meshes.size(), where + "/mesh") &&
           checkIndex(source, node.camera, model.cameras.size(), where + "/camera") &&
           checkIndex(source, node.skin, model.skins.size(), where + "/skin") &&
           checkAllPresent(source, node.children, model.nodes.size(), where + "/children") &&
           checkLength(source, node.matrix, 16, where + "/matrix") &&
           checkLength(source, node.translation, 3, where + "/translation") &&
           checkLength(source, node.rotation, 4, where + "/rotation") &&
           checkLength(source, node.scale, 3, where + "/scale") &&
           checkFinite(source, node.weights, where + "/weights");
}

// With one parent at most for each node, whoever walks up more steps than there are nodes is in a cycle.
bool checkForest(Document& source) {
    const std::size_t count = source.model.nodes.size();
    std::vector<int> parent(count, kNone);
    for (std::size_t i = 0; i < count; ++i)
        for (const int child : source.model.nodes[i].children) {
            if (parent[at(child)] != kNone)
                return source.fail("gltf.node-tree", pathOf("nodes", child),
                                   "the node has more than one parent");
            parent[at(child)] = static_cast<int>(i);
        }
    std::vector<bool> rooted(count, false);
    for (std::size_t i = 0; i < count; ++i) {
        std::size_t steps = 0;
        for (int up = static_cast<int>(i); up != kNone && !rooted[at(up)]; up = parent[at(up)])
            if (++steps > count)
                return source.fail("gltf.node-tree", pathOf("nodes", i), "the node is its own ancestor");
        for (int up = static_cast<int>(i); up != kNone && !rooted[at(up)]; up = parent[at(up)])
            rooted[at(up)] = true;
    }
    return true;
}

bool checkSkin(Document& source, std::size_t index) {
    const tinygltf::Skin& skin = source.model.skins[index];
    const std::string where = pathOf("skins", index);
    if (!checkAllPresent(source, skin.joints, source.model.nodes.size(), where + "/joints") ||
        !checkIndex(source, skin.inverseBindMatrices, source.model.accessors.size(),
                    where + "/inverseBindMatrices"))
        return false;
    if (skin.joints.empty())
        return source.fail("gltf.type", where + "/joints", "a skin has at least one joint");
    if (skin.inverseBindMatrices == kNone)
        return true;
    const tinygltf::Accessor& matrices = source.model.accessors[at(skin.inverseBindMatrices)];
    if (matrices.type != TINYGLTF_TYPE_MAT4 || matrices.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT ||
        matrices.count < skin.joints.size())
        return source.fail("gltf.type", where + "/inverseBindMatrices",
                           "a float MAT4 for each joint is expected");
    return true;
}

int indexOf(const Json& use) { return use.is_object() ? use.value("index", kNone) : kNone; }

bool checkMaterial(Document& source, std::size_t index) {
    const MaterialValues& values = source.materials[index];
    const std::string where = pathOf("materials", index);
    const std::size_t textures = source.model.textures.size();
    for (const TextureRoleRow& role : textureRoles())
        if (isMaterials(role.role) && !checkIndex(source, indexOf(values[role.role]), textures,
                                                  where + std::string(role.gltf) + "/index"))
            return false;
    for (std::size_t i = 0; i < values.factors.size(); ++i)
        if (!checkFinite(source, values.factors[i], where + std::string(kMaterialFactors[i].gltf)))
            return false;
    return true;
}

bool checkTextures(Document& source) {
    const tinygltf::Model& model = source.model;
    for (std::size_t i = 0; i < model.textures.size(); ++i)
        if (!checkIndex(source, model.textures[i].source, model.images.size(),
                        pathOf("textures", i, "source")) ||
            !checkIndex(source, model.textures[i].sampler, model.samplers.size(),
                        pathOf("textures", i, "sampler")))
            return false;
    for (std::size_t i = 0; i < source.images.size(); ++i)
        if (!checkIndex(source, source.images[i].view, model.bufferViews.size(),
                        pathOf("images", i, "bufferView")))
            return false;
    return true;
}

bool checkScenes(Document& source) {
    const tinygltf::Model& model = source.model;
    for (std::size_t i = 0; i < model.scenes.size(); ++i)
        if (!checkAllPresent(source, model.scenes[i].nodes, model.nodes.size(), pathOf("scenes", i, "nodes")))
            return false;
    return checkIndex(source, model.defaultScene, model.scenes.size(), "/scene");
}

} // namespace

bool validateTree(Document& source) {
    for (std::size_t i = 0; i < source.model.nodes.size(); ++i)
        if (!checkNode(source, i) && !source.defer(pathOf("nodes", i)))
            return false;
    for (std::size_t i = 0; i < source.model.skins.size(); ++i)
        if (!checkSkin(source, i) && !source.defer(pathOf("skins", i)))
            return false;
    for (std::size_t i = 0; i < source.model.materials.size(); ++i)
        if (!checkMaterial(source, i) && !source.defer(pathOf("materials", i)))
            return false;
    return checkTextures(source) && checkScenes(source) && checkForest(source);
}

} // namespace franken::gltf
