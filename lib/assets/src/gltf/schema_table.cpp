// SPDX-License-Identifier: MIT
// What of a glTF file is read: each member of each object, and so each extension.
#include "gltf/schema.h"

#include <algorithm>
#include <array>

namespace franken::gltf {
namespace {

/// An array of objects that the file may have more of than what is drawn needs.
constexpr Property elements(std::string_view name, Schema members, std::string_view empty) {
    return {name, Kind::Object, kMany, members, false, empty};
}

constexpr Property required(std::string_view name, Kind kind, std::size_t length = kOne,
                            Schema members = {}) {
    return {name, kind, length, members, true};
}

// glTF 2.0, 5 ("Properties Reference"), and the schemas of the extensions that are known: the members that
// the loader reads, and no others.

constexpr Property kUvTransform[]{{"offset", Kind::Number, 2},
                                  {"rotation", Kind::Number},
                                  {"scale", Kind::Number, 2},
                                  {"texCoord", Kind::Natural}};
constexpr Property kTextureExtensions[]{{"KHR_texture_transform", Kind::Object, kOne, kUvTransform}};
constexpr Property kTextureInfo[]{required("index", Kind::Index),
                                  {"texCoord", Kind::Natural},
                                  {"scale", Kind::Number},
                                  {"strength", Kind::Number},
                                  {"extensions", Kind::Object, kOne, kTextureExtensions}};
constexpr Property kPbr[]{{"baseColorFactor", Kind::Number, 4},
                          {"baseColorTexture", Kind::Object, kOne, kTextureInfo},
                          {"metallicFactor", Kind::Number},
                          {"roughnessFactor", Kind::Number},
                          {"metallicRoughnessTexture", Kind::Object, kOne, kTextureInfo}};
constexpr Property kEmissiveStrength[]{{"emissiveStrength", Kind::Number}};
constexpr Property kMaterialExtensions[]{
    {"KHR_materials_emissive_strength", Kind::Object, kOne, kEmissiveStrength},
    {"KHR_materials_unlit", Kind::Object}};
constexpr Property kMaterial[]{{"name", Kind::Name},
                               {"pbrMetallicRoughness", Kind::Object, kOne, kPbr},
                               {"normalTexture", Kind::Object, kOne, kTextureInfo},
                               {"occlusionTexture", Kind::Object, kOne, kTextureInfo},
                               {"emissiveTexture", Kind::Object, kOne, kTextureInfo},
                               {"emissiveFactor", Kind::Number, 3},
                               {"alphaMode", Kind::String},
                               {"alphaCutoff", Kind::Number},
                               {"doubleSided", Kind::Boolean},
                               {"extensions", Kind::Object, kOne, kMaterialExtensions}};

constexpr Property kSparseIndices[]{required("bufferView", Kind::Index),
                                    {"byteOffset", Kind::Natural},
                                    required("componentType", Kind::Integer)};
constexpr Property kSparseValues[]{required("bufferView", Kind::Index), {"byteOffset", Kind::Natural}};
constexpr Property kSparse[]{required("count", Kind::Natural),
                             required("indices", Kind::Object, kOne, kSparseIndices),
                             required("values", Kind::Object, kOne, kSparseValues)};
constexpr Property kAccessor[]{{"name", Kind::Name},           {"bufferView", Kind::Index},
                               {"byteOffset", Kind::Size},     required("componentType", Kind::Integer),
                               {"normalized", Kind::Boolean},  required("count", Kind::Size),
                               required("type", Kind::String), {"sparse", Kind::Object, kOne, kSparse}};
constexpr Property kBuffer[]{{"uri", Kind::String}, required("byteLength", Kind::Size)};
constexpr Property kBufferView[]{required("buffer", Kind::Index),
                                 {"byteOffset", Kind::Size},
                                 required("byteLength", Kind::Size),
                                 {"byteStride", Kind::Size}};
constexpr Property kImage[]{{"name", Kind::Name}, {"uri", Kind::String}, {"bufferView", Kind::Index}};
constexpr Property kTexture[]{{"name", Kind::Name}, {"sampler", Kind::Index}, {"source", Kind::Index}};
constexpr Property kSampler[]{{"magFilter", Kind::Integer},
                              {"minFilter", Kind::Integer},
                              {"wrapS", Kind::Integer},
                              {"wrapT", Kind::Integer}};

constexpr Property kMapping[]{{"material", Kind::Index}, {"variants", Kind::Index, kMany}};
constexpr Property kMappings[]{elements("mappings", kMapping, "{}")};
constexpr Property kPrimitiveExtensions[]{{"KHR_materials_variants", Kind::Object, kOne, kMappings}};
constexpr Property kPrimitive[]{required("attributes", Kind::Attributes),
                                {"indices", Kind::Index},
                                {"material", Kind::Index},
                                {"mode", Kind::Integer},
                                {"targets", Kind::Attributes, kMany},
                                {"extensions", Kind::Object, kOne, kPrimitiveExtensions}};
constexpr Property kMesh[]{{"name", Kind::Name},
                           required("primitives", Kind::Object, kMany, kPrimitive),
                           {"weights", Kind::Number, kMany}};
constexpr Property kSkin[]{
    {"name", Kind::Name}, required("joints", Kind::Index, kMany), {"inverseBindMatrices", Kind::Index}};
constexpr Property kNodeLight[]{required("light", Kind::Index)};
constexpr Property kVisibility[]{{"visible", Kind::Boolean}};
constexpr Property kInstancing[]{required("attributes", Kind::Attributes)};
constexpr Property kNodeExtensions[]{{"EXT_mesh_gpu_instancing", Kind::Object, kOne, kInstancing},
                                     {"KHR_lights_punctual", Kind::Object, kOne, kNodeLight},
                                     {"KHR_node_visibility", Kind::Object, kOne, kVisibility}};
constexpr Property kNode[]{{"name", Kind::Name},
                           {"camera", Kind::Index},
                           {"children", Kind::Index, kMany},
                           {"skin", Kind::Index},
                           {"mesh", Kind::Index},
                           {"matrix", Kind::Number, 16},
                           {"rotation", Kind::Number, 4},
                           {"scale", Kind::Number, 3},
                           {"translation", Kind::Number, 3},
                           {"weights", Kind::Number, kMany},
                           {"extensions", Kind::Object, kOne, kNodeExtensions}};
constexpr Property kScene[]{{"name", Kind::Name}, {"nodes", Kind::Index, kMany}};

constexpr Property kPointer[]{required("pointer", Kind::String)};
constexpr Property kTargetExtensions[]{{"KHR_animation_pointer", Kind::Object, kOne, kPointer}};
constexpr Property kTarget[]{{"node", Kind::Index},
                             required("path", Kind::String),
                             {"extensions", Kind::Object, kOne, kTargetExtensions}};
constexpr Property kChannel[]{required("sampler", Kind::Index),
                              required("target", Kind::Object, kOne, kTarget)};
constexpr Property kAnimationSampler[]{
    required("input", Kind::Index), {"interpolation", Kind::String}, required("output", Kind::Index)};
constexpr Property kAnimation[]{{"name", Kind::Name},
                                required("channels", Kind::Object, kMany, kChannel),
                                required("samplers", Kind::Object, kMany, kAnimationSampler)};

constexpr Property kPerspective[]{{"aspectRatio", Kind::Number},
                                  required("yfov", Kind::Number),
                                  {"zfar", Kind::Number},
                                  required("znear", Kind::Number)};
constexpr Property kOrthographic[]{required("xmag", Kind::Number), required("ymag", Kind::Number),
                                   required("zfar", Kind::Number), required("znear", Kind::Number)};
constexpr Property kCamera[]{{"name", Kind::Name},
                             required("type", Kind::String),
                             {"perspective", Kind::Object, kOne, kPerspective},
                             {"orthographic", Kind::Object, kOne, kOrthographic}};
constexpr std::string_view kEmptyCamera =
    R"({"type": "perspective", "perspective": {"yfov": 1, "znear": 1}})";
constexpr Property kSpot[]{{"innerConeAngle", Kind::Number}, {"outerConeAngle", Kind::Number}};
constexpr Property kLight[]{{"name", Kind::Name},       required("type", Kind::String),
                            {"color", Kind::Number, 3}, {"intensity", Kind::Number},
                            {"range", Kind::Number},    {"spot", Kind::Object, kOne, kSpot}};
constexpr Property kLights[]{{"lights", Kind::Object, kMany, kLight, true, R"({"type": "point"})"}};
constexpr Property kVariant[]{{"name", Kind::Name}};
constexpr Property kVariants[]{elements("variants", kVariant, "{}")};
constexpr Property kFileExtensions[]{{"KHR_lights_punctual", Kind::Object, kOne, kLights},
                                     {"KHR_materials_variants", Kind::Object, kOne, kVariants}};
constexpr Property kAsset[]{required("version", Kind::String)};

constexpr Property kFile[]{
    required("asset", Kind::Object, kOne, kAsset),
    {"extensionsUsed", Kind::String, kMany},
    {"extensionsRequired", Kind::String, kMany},
    {"extensions", Kind::Object, kOne, kFileExtensions},
    {"buffers", Kind::Object, kMany, kBuffer},
    {"bufferViews", Kind::Object, kMany, kBufferView},
    elements("accessors", kAccessor, R"({"componentType": 5121, "count": 1, "type": "SCALAR"})"),
    elements("images", kImage, R"({"uri": "data:,"})"),
    elements("samplers", kSampler, "{}"),
    elements("textures", kTexture, "{}"),
    elements("materials", kMaterial, "{}"),
    elements("meshes", kMesh, R"({"primitives": []})"),
    elements("skins", kSkin, R"({"joints": []})"),
    elements("cameras", kCamera, kEmptyCamera),
    elements("nodes", kNode, "{}"),
    elements("scenes", kScene, "{}"),
    elements("animations", kAnimation, R"({"channels": [], "samplers": []})"),
    {"scene", Kind::Index}};

// An extension is known by its name among the members above, or here, where it has none of its own.
constexpr std::array<std::string_view, 1> kWithoutMembers{"KHR_mesh_quantization"};

// What a picture of the file at rest can do without, even where the file says that it requires it: words
// about the model, what moves, sounds or answers, other looks to choose from, and lobes on top of a surface
// that is there without them.
constexpr std::array<std::string_view, 37> kHarmless{"ADOBE_materials_clearcoat_specular",
                                                     "ADOBE_materials_clearcoat_tint",
                                                     "AGI_articulations",
                                                     "AGI_stk_metadata",
                                                     "CESIUM_primitive_outline",
                                                     "EXT_feature_metadata",
                                                     "EXT_instance_features",
                                                     "EXT_lights_ies",
                                                     "EXT_mesh_features",
                                                     "EXT_mesh_manifold",
                                                     "EXT_structural_metadata",
                                                     "FB_geometry_metadata",
                                                     "GODOT_single_root",
                                                     "KHR_audio",
                                                     "KHR_audio_emitter",
                                                     "KHR_implicit_shapes",
                                                     "KHR_interactivity",
                                                     "KHR_materials_anisotropy",
                                                     "KHR_materials_clearcoat",
                                                     "KHR_materials_dispersion",
                                                     "KHR_materials_ior",
                                                     "KHR_materials_iridescence",
                                                     "KHR_materials_sheen",
                                                     "KHR_materials_specular",
                                                     "KHR_node_hoverability",
                                                     "KHR_node_selectability",
                                                     "KHR_physics_rigid_bodies",
                                                     "KHR_xmp",
                                                     "KHR_xmp_json_ld",
                                                     "MSFT_audio_emitter",
                                                     "MSFT_lod",
                                                     "OMI_physics_body",
                                                     "OMI_physics_shape",
                                                     "VRM",
                                                     "VRMC_node_constraint",
                                                     "VRMC_springBone",
                                                     "VRMC_vrm"};

bool hasExtension(Schema schema, std::string_view name, bool isExtension = false) {
    return std::any_of(schema.begin(), schema.end(), [&](const Property& property) {
        return (isExtension && property.name == name) ||
               hasExtension(property.members, name, property.name == "extensions");
    });
}

template<typename List>
bool contains(const List& list, std::string_view name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

} // namespace

const Schema kFileSchema = kFile;

bool isKnown(std::string_view extension) {
    return contains(kWithoutMembers, extension) || hasExtension(kFile, extension);
}

bool isHarmless(std::string_view extension) { return contains(kHarmless, extension); }

} // namespace franken::gltf
