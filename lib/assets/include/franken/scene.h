// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <glm/ext/matrix_double4x4.hpp>
#include <glm/ext/vector_double3.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "franken/animation.h"
#include "franken/api.h"
#include "franken/box.h"
#include "franken/deform.h"
#include "franken/generator/pack.h"
#include "franken/generator/texture_role.h"
#include "franken/image.h"
#include "franken/index.h"
#include "franken/sampling.h"

/// What a glTF file says, as plain data on the CPU: no GL, no file format, nothing left to resolve. All
/// indices into the arrays of Scene are in range, all numbers finite. Units are glTF's: metres, radians,
/// lux and candela; +Y up, right-handed; colours are linear. Vertices are floats; where things stand in the
/// world is double, so that a model may stand anywhere on a globe.
namespace FRANKEN_API franken {

/// An image and how it is sampled. Filters that the file leaves open are the best that GLES2 has.
struct Texture {
    int image = kNone; ///< Index into Scene::images; kNone only where no material uses the texture.
    /// What lies outside of 0-1, across and down.
    Wrap wrapS = Wrap::Repeat;
    Wrap wrapT = Wrap::Repeat;
    Filter magFilter = Filter::Linear;             ///< Nearest or Linear only.
    Filter minFilter = Filter::LinearMipmapLinear; ///< With mipmaps, unless it is Nearest or Linear.
};

/// A material's use of a texture.
struct TextureRef {
    int texture = kNone; ///< Index into Scene::textures, or kNone: the material has no such texture.
    int uvSet = 0;       ///< 0 or 1: which of the primitive's UV streams.

    /// KHR_texture_transform: sampled at (transform * vec3(uv, 1)).xy, with transform = T * R * S as in the
    /// extension's text. The identity where the extension is absent or does nothing.
    glm::mat3 transform{1.0f};
    bool transformed = false; ///< Whether `transform` differs from the identity.

    /// There is a texture.
    explicit operator bool() const { return texture != kNone; }
    bool operator==(const TextureRef&) const = default;
};

/// Whether a surface is solid, has holes, or is seen through.
enum class AlphaMode { Opaque, Mask, Blend };

/// A material's textures, by role (texture_role.h). A glTF file fills the roles that have a place in it;
/// those of Metallic and Roughness are for scenes that are not from a file, in place of MetallicRoughness,
/// and share their coordinates.
struct MaterialTextures {
    std::array<TextureRef, kMaterialRoles> refs; ///< By TextureRole.

    /// The texture in that role.
    TextureRef& operator[](TextureRole role) { return refs[static_cast<std::size_t>(role)]; }
    const TextureRef& operator[](TextureRole role) const { return refs[static_cast<std::size_t>(role)]; }
    /// Over all roles, in the order of the enumeration.
    auto begin() { return refs.begin(); }
    auto end() { return refs.end(); }
    auto begin() const { return refs.begin(); }
    auto end() const { return refs.end(); }
    bool operator==(const MaterialTextures&) const = default;
};

/// glTF's metallic-roughness material. A texture multiplies the factor of its role. A texture whose image
/// could not be read is left out, which is what a 1x1 default of its role would give.
struct Material {
    std::string name;          ///< As in the file; not unique.
    MaterialFactors factors;   ///< Numbers and colours.
    MaterialTextures textures; ///< By role.
    AlphaMode alphaMode = AlphaMode::Opaque;
    bool doubleSided = false; ///< Back faces are drawn, and lit from their side.
    bool unlit = false;       ///< KHR_materials_unlit: base colour only, no light.
};

/// One draw's worth of triangles, as one array for each attribute, in one form whatever the file had. Each
/// array but `indices` is either empty (the attribute is absent) or as long as `positions`.
struct Primitive {
    std::vector<glm::vec3> positions; ///< m, in the node's space.
    /// Unit length; never absent after loading (flat where the file has none).
    std::vector<glm::vec3> normals;
    /// Unit xyz; w = +-1, and B = cross(N, T.xyz) * w. Present where the material has a normal texture and
    /// its UV stream exists.
    std::vector<glm::vec4> tangents;
    std::vector<glm::vec2> uv[2];  ///< TEXCOORD_0 and TEXCOORD_1; v grows downwards.
    std::vector<glm::vec4> colors; ///< COLOR_0, linear RGBA; multiplies the base colour.

    /// Triangle list, counter-clockwise in front; each < positions.size().
    std::vector<std::uint32_t> indices;
    int material = 0; ///< Index into Scene::materials; always valid.
    /// Index into Scene::materials for each of Scene::variants; kNone, or beyond the end: `material` in that
    /// variant as well.
    std::vector<int> variantMaterials;
    Box bounds; ///< Of `positions`.
    /// What moves the vertices of a skin or a morph; the arrays above have them at rest then. Primitives that
    /// one mesh of a file became share it. Null: they move only with the instance.
    std::shared_ptr<const Deformation> deformation = {};
};

/// What instances show: one or more primitives with a material each.
struct Mesh {
    std::string name;                  ///< As in the file; not unique.
    std::vector<Primitive> primitives; ///< At least one.
};

/// A mesh, placed in the world.
struct Instance {
    std::string name;      ///< The node's.
    int mesh = 0;          ///< Index into Scene::meshes.
    glm::dmat4 world{1.0}; ///< Object to world; affine. For a skinned mesh: only where its first joint is.
    bool mirrored = false; ///< The node's determinant is negative, a skinned mesh's too: front faces wind
                           ///< clockwise.
    bool visible = true;   ///< Neither the node nor one above it is hidden (KHR_node_visibility).
    int nodeIndex = kNone; ///< Index into Scene::nodes; kNone for what no pose moves.
    int skin = kNone;      ///< Index into Scene::skins, whose joints move its whole mesh, not the node.
    /// From the instance to its node: the identity, but for the instances of EXT_mesh_gpu_instancing.
    glm::dmat4 offset{1.0};
};

/// Looks along -Z of `world`, with +Y up; the view matrix is the inverse of `world`.
struct Camera {
    /// Lines meet far away, or stay parallel.
    enum class Projection { Perspective, Orthographic };

    std::string name;      ///< As in the file; not unique.
    std::string node = {}; ///< The name of the node that it hangs on.
    int index = kNone;     ///< In the file's array of cameras.
    Projection projection = Projection::Perspective;
    float yfov = 0.8f;        ///< Perspective: the full vertical angle, radians, > 0.
    float aspectRatio = 0.0f; ///< Perspective: width / height; 0: that of the viewport.
    float xmag = 1.0f;        ///< Orthographic: half the width of the view, metres.
    float ymag = 1.0f;        ///< Orthographic: half the height of the view, metres.
    float znear = 0.1f;       ///< Metres; > 0 for a perspective camera, >= 0 for an orthographic one.
    float zfar = 0.0f;        ///< Metres, > znear; 0 for a perspective camera: infinite.
    glm::dmat4 world{1.0};    ///< From the camera, which looks along -Z with +Y up, to the world. No scale.
    int nodeIndex = kNone;    ///< Index into Scene::nodes; kNone for one that no pose moves.
};

/// KHR_lights_punctual, placed in the world.
struct Light {
    /// KHR_lights_punctual's kinds.
    enum class Kind { Directional, Point, Spot };

    std::string name; ///< As in the file; not unique.
    Kind kind = Kind::Directional;
    glm::vec3 color{1.0f};            ///< Linear RGB, 0..1.
    float intensity = 1.0f;           ///< Lux (directional) or candela (point, spot); >= 0.
    float range = 0.0f;               ///< Metres, where the light has faded to nothing; 0: infinite.
    float innerConeAngle = 0.0f;      ///< Spot: radians from the axis, 0 <= inner < outer.
    float outerConeAngle = 0.785398f; ///< Spot: radians from the axis, <= pi/2.
    glm::dvec3 position{0.0};         ///< World; point and spot.
    /// World, unit length, where the light travels; directional and spot.
    glm::vec3 direction{0.0f, 0.0f, -1.0f};
    int nodeIndex = kNone; ///< Index into Scene::nodes; kNone for one that no pose moves.
};

/// Everything that one file draws.
struct Scene {
    std::vector<Image> images;       ///< One white pixel for each that no material uses.
    std::vector<Texture> textures;   ///< What materials refer to.
    std::vector<Material> materials; ///< At least one where there is a mesh: primitives without get a
                                     ///< default, and one stands in for each that the scene does not use.
    std::vector<Mesh> meshes;        ///< Only those that are drawn. A node with a skin or a morph has a mesh
                                     ///< of its own.
    std::vector<Instance> instances; ///< In the order of the node tree.
    std::vector<Camera> cameras;     ///< In the order of the file's array; one for each node that has one.
    std::vector<Light> lights;       ///< In the order of the node tree.
    std::vector<std::string> variants; ///< KHR_materials_variants: other materials to choose, by name.
    std::vector<Node> nodes; ///< All of the file, each after its parent. What stands above is as they are at
                             ///< rest; pose.h moves it.
    std::vector<Skin> skins; ///< Only those of instances.
    std::vector<Animation> animations; ///< In the order of the file's array; faulty ones are left out.

    /// The mips of a roughness texture hold what the mips of the normal map beside it lose (normal_spread.h),
    /// so that fine bumps are as bright and as calm from afar as they are near. It costs a frame nothing.
    bool normalsWidenRoughness = true;

    /// What loadGltf() read, the model's own file first; empty for a scene that is not from files.
    std::vector<std::filesystem::path> files;

    /// Of all visible instances, in the world; empty where nothing is drawn.
    Box bounds() const;
};

} // namespace franken
