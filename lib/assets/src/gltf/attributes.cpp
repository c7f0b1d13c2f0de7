// SPDX-License-Identifier: MIT
// Which attributes of a primitive are read, and as what.
#include <algorithm>
#include <initializer_list>

#include "gltf/mesh.h"

namespace franken::gltf {
namespace {

constexpr int kByte = TINYGLTF_COMPONENT_TYPE_BYTE, kUByte = TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE,
              kShort = TINYGLTF_COMPONENT_TYPE_SHORT, kUShort = TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
              kUInt = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, kFloat = TINYGLTF_COMPONENT_TYPE_FLOAT;

bool isOneOf(int value, std::initializer_list<int> values) {
    return std::find(values.begin(), values.end(), value) != values.end();
}

/// What glTF says of an accessor as a certain attribute: that it is right, that it is wrong but has only one
/// meaning, or that it is wrong.
enum class Fit { Right, Mendable, Wrong };

Fit rightIf(bool condition) { return condition ? Fit::Right : Fit::Mendable; }

// KHR_mesh_quantization adds formats whose numbers mean the same, declared or not.
Fit judgeDirection(const tinygltf::Accessor& accessor, int type, bool isTarget, bool quantized) {
    if (accessor.type != type)
        return Fit::Wrong;
    if (accessor.componentType == kFloat)
        return Fit::Right;
    if (!isOneOf(accessor.componentType, {kByte, kShort}) || (isTarget && !accessor.normalized))
        return Fit::Wrong;
    return rightIf(quantized && accessor.normalized); // any length will do
}

Fit judgePosition(const tinygltf::Accessor& accessor, bool isTarget, bool quantized) {
    const int component = accessor.componentType;
    if (accessor.type != TINYGLTF_TYPE_VEC3)
        return Fit::Wrong;
    if (component == kFloat)
        return Fit::Right;
    const bool isSmall =
        isOneOf(component, {kByte, kShort}) || (!isTarget && isOneOf(component, {kUByte, kUShort}));
    return isSmall ? rightIf(quantized) : Fit::Wrong;
}

Fit judgeUv(const tinygltf::Accessor& accessor, bool isTarget, bool quantized) {
    const int component = accessor.componentType;
    if (!isOneOf(accessor.type, {TINYGLTF_TYPE_VEC2, TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC4}))
        return Fit::Wrong;
    const bool isUnsigned = isOneOf(component, {kUByte, kUShort});
    if (component != kFloat && !isUnsigned && !isOneOf(component, {kByte, kShort}))
        return Fit::Wrong;
    const bool isShare = (isUnsigned || isTarget) && accessor.normalized;
    return rightIf(accessor.type == TINYGLTF_TYPE_VEC2 && (component == kFloat || isShare || quantized));
}

Fit judgeColor(const tinygltf::Accessor& accessor, bool isTarget = false) {
    const bool isInteger = isOneOf(accessor.componentType, {kUByte, kUShort}) ||
                           (isTarget && isOneOf(accessor.componentType, {kByte, kShort}));
    if (!isOneOf(accessor.type, {TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC4}) ||
        (accessor.componentType != kFloat && !isInteger))
        return Fit::Wrong;
    return rightIf(!isInteger || accessor.normalized);
}

Fit judgeJoints(const tinygltf::Accessor& accessor) {
    if (accessor.type != TINYGLTF_TYPE_VEC4 ||
        !isOneOf(accessor.componentType, {kUByte, kUShort, kUInt, kFloat}))
        return Fit::Wrong;
    return rightIf(isOneOf(accessor.componentType, {kUByte, kUShort}) && !accessor.normalized);
}

// glTF 2.0, 3.7.2.1, and the tables of KHR_mesh_quantization.
Fit judge(const tinygltf::Accessor& accessor, const std::string& name, bool isTarget, bool quantized) {
    if (name == "POSITION")
        return judgePosition(accessor, isTarget, quantized);
    if (name == "NORMAL")
        return judgeDirection(accessor, TINYGLTF_TYPE_VEC3, isTarget, quantized);
    if (name == "TANGENT")
        return judgeDirection(accessor, isTarget ? TINYGLTF_TYPE_VEC3 : TINYGLTF_TYPE_VEC4, isTarget,
                              quantized);
    if (name.starts_with("TEXCOORD_"))
        return judgeUv(accessor, isTarget, quantized);
    if (name.starts_with("COLOR_"))
        return judgeColor(accessor, isTarget);
    if (name.starts_with("JOINTS_"))
        return judgeJoints(accessor);
    if (name.starts_with("WEIGHTS_")) // whose sum is made 1
        return accessor.type == TINYGLTF_TYPE_VEC4 ? judgeColor(accessor) : Fit::Wrong;
    return Fit::Right; // an application's own
}

/// Chooses among the attributes of one primitive.
class Chooser {
public:
    Chooser(Document& source, const MaterialChoice& materials, const MeshUse& use, std::size_t vertices)
        : m_source(source),
          m_materials(materials),
          m_use(use),
          m_vertices(vertices),
          m_quantized(source.uses("KHR_mesh_quantization")) {}

    bool choose(std::map<std::string, int>& attributes, bool isTarget, bool isUsed,
                const std::string& where) {
        for (auto attribute = attributes.begin(); attribute != attributes.end();) {
            const auto& [name, accessor] = *attribute;
            const std::string path = where + pathOf(name);
            if (check(name, accessor, isTarget, path)) {
                ++attribute;
                continue;
            }
            if ((isUsed && isNeeded(name, isTarget)) || !m_source.defer(path))
                return false;
            attribute = attributes.erase(attribute);
        }
        return true;
    }

private:
    bool check(const std::string& name, int index, bool isTarget, const std::string& where) {
        tinygltf::Accessor& accessor = m_source.model.accessors[at(index)];
        if (!m_source.need(pathOf("accessors", index)))
            return false;
        const Fit fit = judge(accessor, name, isTarget, m_quantized);
        if (fit == Fit::Wrong)
            return m_source.fail("gltf.type", where,
                                 "glTF does not allow " + name + " in the accessor's type");
        if (accessor.count != m_vertices)
            return m_source.fail("gltf.type", where,
                                 "the attribute has " + std::to_string(accessor.count) +
                                     " elements, and there are " + std::to_string(m_vertices) + " vertices");
        if (fit == Fit::Mendable)
            mend(accessor, name, where);
        return true;
    }

    void mend(tinygltf::Accessor& accessor, const std::string& name, const std::string& where) {
        const bool isShare = name.starts_with("COLOR_") || name.starts_with("WEIGHTS_");
        accessor.normalized = accessor.normalized || isShare;
        m_source.warn(
            kMended, where,
            isShare ? name + " in integers is read as normalized, which the accessor does not say"
                    : "glTF does not allow " + name +
                          " in the accessor's type, unless an extension says so; it is read as it stands");
    }

    template<typename Predicate>
    bool anyMaterial(Predicate predicate) const {
        return std::any_of(m_materials.begin(), m_materials.end(),
                           [&](const Material* material) { return predicate(*material); });
    }

    static bool samples(const Material& material, int uvSet) {
        return std::any_of(material.textures.begin(), material.textures.end(),
                           [uvSet](const TextureRef& ref) { return ref && ref.uvSet == uvSet; });
    }

    bool isNeeded(const std::string& name, bool isTarget) const {
        if (name == "NORMAL")
            return anyMaterial([](const Material& material) { return !material.unlit; });
        if (name == "TANGENT")
            return anyMaterial([](const Material& material) {
                return material.textures[TextureRole::Normal] && !material.unlit;
            });
        if (isTarget)
            return name == "POSITION";
        if (name == "TEXCOORD_0" || name == "TEXCOORD_1")
            return anyMaterial(
                [&](const Material& material) { return samples(material, name.back() - '0'); });
        if (name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_"))
            return m_use.joints > 0;
        return name == "POSITION" || name == "COLOR_0";
    }

    Document& m_source;
    const MaterialChoice& m_materials;
    const MeshUse& m_use;
    std::size_t m_vertices;
    bool m_quantized;
};

bool checkIndices(Document& source, int index, const std::string& where) {
    if (index == kNone)
        return true;
    if (!source.need(pathOf("accessors", index)))
        return false;
    const tinygltf::Accessor& accessor = source.model.accessors[at(index)];
    if (accessor.type != TINYGLTF_TYPE_SCALAR || !isOneOf(accessor.componentType, {kUByte, kUShort, kUInt}))
        return source.fail("gltf.type", where, "indices are unsigned integers");
    if (accessor.normalized)
        source.warn(kMended, where, "indices are not normalized");
    return true;
}

} // namespace

bool chooseAttributes(Document& source, const MaterialChoice& materials, const MeshUse& use,
                      const std::string& where, tinygltf::Primitive& primitive) {
    const int position = primitive.attributes["POSITION"];
    if (!source.need(pathOf("accessors", position)) ||
        !checkIndices(source, primitive.indices, where + "/indices"))
        return false;
    Chooser chooser(source, materials, use, source.model.accessors[at(position)].count);
    if (!chooser.choose(primitive.attributes, false, true, where + "/attributes"))
        return false;
    for (std::size_t t = 0; t < primitive.targets.size(); ++t) {
        const bool isUsed = t < use.weights.size() && use.weights[t] != 0.0;
        if (!chooser.choose(primitive.targets[t], true, isUsed, where + pathOf("targets", t)))
            return false;
    }
    return true;
}

} // namespace franken::gltf
