// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "image.h"

namespace make_model {

/// A model as plain data, in the terms of glTF 2.0: metres, +Y up, right-handed, linear colours, indices into
/// the lists of Model. What glTF allows and this model does not need is left out.

/// What is added to a mesh's vertices, times a weight.
struct Target {
    std::string name{};
    std::vector<glm::vec3> positions{};
    std::vector<glm::vec3> normals{};
};

/// A triangle mesh of one material. Attributes are parallel lists; one that is not wanted is empty.
struct Mesh {
    std::string name{};
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec4> tangents;  ///< w = ±1; the bitangent is cross(normal, tangent) * w.
    std::vector<glm::vec2> uvs;       ///< (0, 0) is the upper left corner of the image.
    std::vector<glm::u8vec4> colours; ///< Linear, 255 = 1, multiplied with the base colour.
    std::vector<glm::u8vec4> joints;  ///< Indices into Skin::joints.
    std::vector<glm::u8vec4> weights; ///< Of these joints, 255 = 1; those of a vertex add up to 255.
    std::vector<Target> targets{};
    std::vector<std::uint16_t> indices; ///< Counter-clockwise triangles; 16 bits, for GPUs that have no more.
    int material = 0;
};

struct Material {
    std::string name{};
    glm::dvec3 baseColour{1.0};
    double metallic = 1.0;  ///< 0 = dielectric, 1 = metal.
    double roughness = 1.0; ///< Perceptual, 0 to 1.
    glm::dvec3 emissive{0.0};
    bool doubleSided = false;
    std::optional<int> baseColourImage{};        ///< sRGB.
    std::optional<int> metallicRoughnessImage{}; ///< Linear; G rough, B metal.
    std::optional<int> normalImage{};            ///< Linear; X right, Y up in the image, Z out.
    std::optional<int> occlusionImage{};         ///< Linear; R. May be the metallic-roughness image.
    std::optional<int> emissiveImage{};          ///< sRGB.
};

struct Camera {
    double verticalFov = 0.0; ///< Radians.
    double near = 0.0;        ///< Metres.
    double far = 0.0;         ///< Metres.
};

/// A sun: shines along its node's -Z.
struct DirectionalLight {
    std::string name{};
    glm::dvec3 colour{1.0};
    double lux = 0.0; ///< π lux make a white surface that faces the light 1.0.
};

struct Node {
    std::string name{};
    glm::dvec3 translation{0.0};
    glm::dvec4 rotation{0.0, 0.0, 0.0, 1.0}; ///< Unit quaternion, x y z w.
    glm::dvec3 scale{1.0};
    std::vector<int> children{};
    std::optional<int> mesh{};
    std::optional<int> skin{};
    std::optional<int> camera{};
    std::optional<int> light{};
};

/// What moves the vertices of a mesh.
struct Skin {
    std::string name{};
    std::vector<int> joints{};             ///< Nodes.
    std::vector<glm::mat4> inverseBinds{}; ///< From the mesh to each.
};

/// What moves a node.
struct Channel {
    int node = 0;
    std::string path{};          ///< "translation", "rotation", "scale" or "weights".
    std::vector<float> values{}; ///< For each of the animation's times, one after the other.
};

/// Values between two times are linear.
struct Animation {
    std::string name{};
    std::vector<float> times{}; ///< Seconds, ascending; of all channels.
    std::vector<Channel> channels{};
};

struct NamedImage {
    std::string name{};
    Image image;
};

struct Model {
    std::vector<Node> nodes; ///< The last one is the root of the scene.
    std::vector<Mesh> meshes;
    std::vector<Material> materials;
    std::vector<NamedImage> images;
    std::vector<Camera> cameras;
    std::vector<DirectionalLight> lights;
    std::vector<Skin> skins{};
    std::vector<Animation> animations{};
};

/// Adds to one of the model's lists; the index.
template<typename T>
int add(std::vector<T>& list, T item) {
    list.push_back(std::move(item));
    return static_cast<int>(list.size()) - 1;
}

/// Tilted up about +X first, then turned about +Y: angles in turns, as a quaternion of six decimals.
glm::dvec4 aim(double turned, double tilted);

/// The demonstration model: a lidded urn of teal porcelain with glowing windows, in gilt mounts, on a round
/// stone plinth, with a camera and two suns. It uses each thing that a glTF material can say in the core
/// format at least once, and both ways to store occlusion.
Model makeModel();

} // namespace make_model
