// SPDX-License-Identifier: MIT
#include "gltf/gate.h"

#include <algorithm>
#include <array>
#include <limits>

namespace franken::gltf {
namespace {

enum class Kind {
    Boolean,
    String,
    Number,
    Integer,    ///< Of 32 bits.
    Natural,    ///< Likewise, and not negative.
    Size,       ///< An unsigned integer of 64 bits: bytes or elements.
    Index,      ///< A Natural that points into an array.
    Attributes, ///< An object whose every value is an Index.
    Object,
    Name, ///< A string for people: a number will do.
};

constexpr std::array<std::string_view, 10> kDescriptions{"true or false",
                                                         "a string",
                                                         "a number",
                                                         "an integer",
                                                         "an integer that is not negative",
                                                         "a size",
                                                         "an index",
                                                         "an object of indices",
                                                         "an object",
                                                         "a name"};

struct Property;
using Schema = std::span<const Property>;
constexpr std::size_t kOne = 0, kMany = std::numeric_limits<std::size_t>::max();

/// A member of an object.
struct Property {
    std::string_view name;
    Kind kind;
    std::size_t length = kOne; ///< One value, or an array: of so many, or of any number.
    Schema members{};          ///< Of Kind::Object.
    bool required = false;
    std::string_view empty{}; ///< What stands in for a faulty element of this array; none: it is refused.
};

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

/// Walks a document along the schema. Functions return false after an error.
class Checker {
public:
    explicit Checker(Source& source) : m_source(source) {}

    bool checkObject(Json& object, Schema schema, const std::string& where) {
        if (!object.is_object())
            return wrongType(Kind::Object, where);
        for (auto member = object.begin(); member != object.end();) {
            const auto property = std::find_if(schema.begin(), schema.end(),
                                               [&](const Property& p) { return p.name == member.key(); });
            if (property != schema.end() && member->is_null())
                m_source.warnOnce(kMended, "a null counts as a property that is absent");
            if (property == schema.end() || member->is_null())
                member = object.erase(member);
            else if (checkProperty(*member, *property, where + pathOf(property->name)))
                ++member;
            else
                return false;
        }
        for (const Property& property : schema)
            if (property.required && !object.contains(property.name))
                return m_source.fail("gltf.schema", where,
                                     "the property " + std::string(property.name) + " is missing");
        return true;
    }

private:
    bool checkProperty(Json& value, const Property& property, const std::string& where) {
        if (property.length == kOne)
            return checkValue(value, property, where);
        const bool any = property.length == kMany;
        if (!value.is_array() || (!any && value.size() != property.length))
            return m_source.fail("gltf.schema", where,
                                 "an array is expected here, each element " +
                                     std::string(kDescriptions[static_cast<std::size_t>(property.kind)]) +
                                     (any ? "" : ", of length " + std::to_string(property.length)));
        for (std::size_t i = 0; i < value.size(); ++i)
            if (!checkValue(value[i], property, where + pathOf(i))) {
                if (property.empty.empty() || !m_source.defer(where + pathOf(i)))
                    return false;
                value[i] = Json::parse(property.empty);
            }
        return true;
    }

    bool checkName(Json& value, const std::string& where) {
        if (!value.is_string()) {
            m_source.warn(kMended, where, "a name is a string");
            value = value.is_structured() ? "" : value.dump();
        }
        return true;
    }

    bool checkValue(Json& value, const Property& property, const std::string& where) {
        switch (property.kind) {
        case Kind::Boolean:
            return value.is_boolean() || wrongType(property.kind, where);
        case Kind::String:
            return value.is_string() || wrongType(property.kind, where);
        case Kind::Number:
            return value.is_number() || wrongType(property.kind, where);
        case Kind::Name:
            return checkName(value, where);
        case Kind::Attributes:
            return checkAttributes(value, where);
        case Kind::Object:
            return checkObject(value, property.members, where);
        default:
            return checkInteger(value, property.kind, where);
        }
    }

    // tinygltf cuts integers down to 32 bits, so that an index of 2^32 would be 0.
    bool checkInteger(const Json& value, Kind kind, const std::string& where) {
        if (!value.is_number_integer())
            return wrongType(kind, where);
        const bool isUnsigned = value.is_number_unsigned();
        const bool isSmall = isUnsigned ? value.get<std::uint64_t>() <= std::numeric_limits<int>::max()
                                        : value.get<std::int64_t>() >= std::numeric_limits<int>::min();
        if (kind == Kind::Size ? isUnsigned : isSmall && (isUnsigned || kind == Kind::Integer))
            return true;
        return m_source.fail(
            kind == Kind::Index ? "gltf.index-range" : "gltf.value", where,
            value.dump() + " is out of range: " + std::string(kDescriptions[static_cast<std::size_t>(kind)]) +
                " is expected here");
    }

    bool checkAttributes(Json& object, const std::string& where) {
        if (!object.is_object())
            return wrongType(Kind::Attributes, where);
        for (auto member = object.begin(); member != object.end();) {
            if (!member->is_null() && !checkInteger(*member, Kind::Index, where + pathOf(member.key())))
                return false;
            member = member->is_null() ? object.erase(member) : std::next(member);
        }
        return true;
    }

    bool wrongType(Kind expected, const std::string& where) {
        return m_source.fail("gltf.schema", where,
                             std::string(kDescriptions[static_cast<std::size_t>(expected)]) +
                                 " is expected here");
    }

    Source& m_source;
};

} // namespace

bool checkSchema(Source& source, Json& root) { return Checker(source).checkObject(root, kFile, ""); }

} // namespace franken::gltf
