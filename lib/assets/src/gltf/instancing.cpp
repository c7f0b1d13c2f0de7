// SPDX-License-Identifier: MIT
#include "gltf/instancing.h"

#include <optional>

#include "franken/animation.h"
#include "gltf/accessor.h"

namespace franken::gltf {
namespace {

/// One attribute of all instances, as `width` numbers each; none where it is absent.
struct Column {
    std::size_t width = 0;
    std::vector<float> numbers = {};

    bool isThere() const { return width != 0; }
    double at(std::size_t instance, std::size_t i) const { return numbers[instance * width + i]; }
    glm::dvec3 vectorAt(std::size_t instance) const {
        return {at(instance, 0), at(instance, 1), at(instance, 2)};
    }
};

class Reader {
public:
    Reader(Document& source, const tinygltf::Value& attributes, std::string where)
        : m_source(source), m_attributes(attributes), m_where(std::move(where)) {}

    bool read(std::vector<glm::dmat4>& offsets) {
        Column translations, rotations, scales;
        if (!readColumn("TRANSLATION", TINYGLTF_TYPE_VEC3, translations) ||
            !readColumn("ROTATION", TINYGLTF_TYPE_VEC4, rotations) ||
            !readColumn("SCALE", TINYGLTF_TYPE_VEC3, scales))
            return false;
        constexpr std::size_t kBytes = sizeof(glm::dmat4) + sizeof(Instance);
        const std::size_t count = m_count.value_or(1);
        if (!m_source.charge(count, kBytes, m_where))
            return false;
        offsets.clear();
        for (std::size_t i = 0; i < count; ++i) {
            Transform transform;
            if (translations.isThere())
                transform.translation = translations.vectorAt(i);
            if (rotations.isThere())
                transform.rotation = glm::dquat(rotations.at(i, 3), rotations.vectorAt(i));
            if (scales.isThere())
                transform.scale = scales.vectorAt(i);
            offsets.push_back(matrixOf(transform));
        }
        return true;
    }

private:
    bool readColumn(const std::string& name, int type, Column& column) {
        if (!m_attributes.Has(name))
            return true;
        const std::string where = m_where + "/attributes" + pathOf(name);
        const int index = m_attributes.Get(name).GetNumberAsInt();
        if (!checkPresent(m_source, index, m_source.model.accessors.size(), where) ||
            !m_source.need(pathOf("accessors", index)))
            return false;
        const tinygltf::Accessor& accessor = m_source.model.accessors[at(index)];
        const bool isFloat = accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT;
        const bool isShare = accessor.normalized && (accessor.componentType == TINYGLTF_COMPONENT_TYPE_BYTE ||
                                                     accessor.componentType == TINYGLTF_COMPONENT_TYPE_SHORT);
        if (accessor.type != type || (!isFloat && !(isShare && type == TINYGLTF_TYPE_VEC4)))
            return m_source.fail("gltf.type", where, "instances cannot have " + name + " of that type");
        if (m_count.value_or(accessor.count) != accessor.count)
            return m_source.fail("gltf.type", where,
                                 "there are " + std::to_string(accessor.count) + " elements, and " +
                                     std::to_string(*m_count) + " instances");
        m_count = accessor.count;
        column.width = at(width(accessor));
        if (!m_source.charge(accessor.count, column.width * sizeof(float), where))
            return false;
        column.numbers.resize(accessor.count * column.width);
        return readFloats(m_source, index, column.numbers);
    }

    Document& m_source;
    const tinygltf::Value& m_attributes;
    std::string m_where;
    std::optional<std::size_t> m_count; ///< Of instances, once it is known.
};

} // namespace

bool readOffsets(Document& source, int index, std::vector<glm::dmat4>& offsets) {
    const tinygltf::Node& node = source.model.nodes[at(index)];
    const std::string where = pathOf("nodes", index, "extensions/EXT_mesh_gpu_instancing");
    offsets.assign(1, glm::dmat4(1.0));
    const auto found = node.extensions.find("EXT_mesh_gpu_instancing");
    if (found == node.extensions.end())
        return true;
    if (node.skin != kNone) {
        source.warn(kLeftOut, where, "a skinned mesh stands where its joints are, and not at instances");
        return true;
    }
    return Reader(source, found->second.Get("attributes"), where).read(offsets);
}

} // namespace franken::gltf
