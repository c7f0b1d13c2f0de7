// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>
#include <numeric>
#include <type_traits>
#include <utility>

#include <glm/geometric.hpp>

#include "franken/tangents.h"
#include "gltf/accessor.h"
#include "gltf/mesh.h"
#include "gltf/variants.h"
#include "mesh/vertices.h"

namespace franken::gltf {
namespace {

int find(const tinygltf::Primitive& primitive, const std::string& name) {
    const auto found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? kNone : found->second;
}

template<typename Vector>
bool readOptional(Document& source, int accessor, std::vector<Vector>& out) {
    return accessor == kNone || readVectors(source, accessor, out);
}

// Exporters are known that write a third coordinate, which means nothing.
bool readUv(Document& source, int accessor, std::vector<glm::vec2>& uv) {
    if (accessor == kNone || width(source.model.accessors[at(accessor)]) == 2)
        return readOptional(source, accessor, uv);
    const std::size_t count = source.model.accessors[at(accessor)].count;
    const auto each = at(width(source.model.accessors[at(accessor)]));
    std::vector<float> numbers;
    if (!source.charge(count, each * sizeof(float), pathOf("accessors", accessor)))
        return false;
    numbers.resize(count * each);
    if (!readFloats(source, accessor, numbers))
        return false;
    for (std::size_t i = 0; i < count; ++i)
        uv.emplace_back(numbers[i * each], numbers[i * each + 1]);
    return true;
}

bool readColors(Document& source, int accessor, std::vector<glm::vec4>& colors) {
    if (accessor == kNone || source.model.accessors[at(accessor)].type == TINYGLTF_TYPE_VEC4)
        return readOptional(source, accessor, colors);
    std::vector<glm::vec3> opaque;
    if (!readVectors(source, accessor, opaque))
        return false;
    colors.reserve(opaque.size());
    for (const glm::vec3& color : opaque)
        colors.emplace_back(color, 1.0f);
    return true;
}

bool readAttributes(Document& source, const tinygltf::Primitive& from, Primitive& primitive) {
    return readVectors(source, find(from, "POSITION"), primitive.positions) &&
           readOptional(source, find(from, "NORMAL"), primitive.normals) &&
           readOptional(source, find(from, "TANGENT"), primitive.tangents) &&
           readUv(source, find(from, "TEXCOORD_0"), primitive.uv[0]) &&
           readUv(source, find(from, "TEXCOORD_1"), primitive.uv[1]) &&
           readColors(source, find(from, "COLOR_0"), primitive.colors);
}

// glTF 2.0, 3.7.2.1: the vertices of triangle i in a list, a strip and a fan. What is left over is ignored.
std::vector<std::uint32_t> triangles(const std::vector<std::uint32_t>& vertices, int mode) {
    std::vector<std::uint32_t> list;
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        list.assign(vertices.begin(), vertices.end() - static_cast<std::ptrdiff_t>(vertices.size() % 3));
        return list;
    }
    for (std::size_t i = 0; i + 2 < vertices.size(); ++i)
        if (mode == TINYGLTF_MODE_TRIANGLE_STRIP)
            list.insert(list.end(), {vertices[i], vertices[i + 1 + i % 2], vertices[i + 2 - i % 2]});
        else
            list.insert(list.end(), {vertices[i + 1], vertices[i + 2], vertices[0]});
    return list;
}

bool readTriangles(Document& source, const tinygltf::Primitive& from, const std::string& where,
                   Primitive& primitive) {
    const std::size_t count = primitive.positions.size();
    std::vector<std::uint32_t> vertices(count);
    std::iota(vertices.begin(), vertices.end(), 0u);
    if (from.indices != kNone && !readIndices(source, from.indices, vertices))
        return false;
    for (std::size_t i = 0; i < vertices.size(); ++i)
        if (vertices[i] >= count)
            return source.fail("gltf.vertex-range", where + "/indices",
                               "index " + std::to_string(i) + " is " + std::to_string(vertices[i]) +
                                   ", but there are only " + std::to_string(count) + " vertices");
    primitive.indices = triangles(vertices, from.mode);
    return true;
}

// A normal of no length says nothing: that of the triangles around the vertex stands in.
void fillNormals(const Document& source, const std::string& where, Primitive& primitive) {
    const auto isMissing = [](const glm::vec3& normal) { return normal == glm::vec3(0.0f); };
    if (std::none_of(primitive.normals.begin(), primitive.normals.end(), isMissing))
        return;
    source.warn(kMended, where, "a normal has no length; the triangles around its vertex give it one");
    std::vector<glm::dvec3> sums(primitive.positions.size(), glm::dvec3(0.0));
    for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
        const std::uint32_t* corner = primitive.indices.data() + i;
        const glm::dvec3 a(primitive.positions[corner[0]]), b(primitive.positions[corner[1]]),
            c(primitive.positions[corner[2]]);
        for (int j = 0; j < 3; ++j)
            sums[corner[j]] += glm::cross(b - a, c - a);
    }
    for (std::size_t i = 0; i < sums.size(); ++i)
        if (const double length = glm::length(sums[i]); isMissing(primitive.normals[i]) && length > 0.0)
            primitive.normals[i] = glm::vec3(sums[i] / length);
}

void normalize(const Document& source, const std::string& where, Primitive& primitive) {
    fillNormals(source, where, primitive);
    for (glm::vec3& normal : primitive.normals)
        normal = unitOr(normal, {0.0f, 0.0f, 1.0f});
    for (glm::vec4& tangent : primitive.tangents)
        tangent = {unitOr(glm::vec3(tangent), {1.0f, 0.0f, 0.0f}), tangent.w < 0.0f ? -1.0f : 1.0f};
}

// By the first of its materials that has a normal texture: a vertex has one tangent.
void completeTangents(Document& source, const MaterialChoice& materials, const std::string& where,
                      Primitive& primitive) {
    const auto found = std::find_if(materials.begin(), materials.end(), [](const Material* material) {
        return static_cast<bool>(material->textures[TextureRole::Normal]);
    });
    if (found != materials.end() && !fillTangents(primitive, (*found)->textures[TextureRole::Normal]))
        source.warn(kLeftOut, where, "the material has a normal texture, but its UV stream is missing");
}

int materialOf(const tinygltf::Primitive& from, Scene& scene, std::size_t fileMaterials) {
    if (from.material != kNone)
        return from.material;
    if (scene.materials.size() == fileMaterials)
        scene.materials.emplace_back();
    return static_cast<int>(fileMaterials);
}

MaterialChoice materialsOf(const Primitive& primitive, const Scene& scene) {
    MaterialChoice materials{&scene.materials[at(primitive.material)]};
    for (const int material : primitive.variantMaterials)
        if (material != kNone)
            materials.push_back(&scene.materials[at(material)]);
    return materials;
}

// A buffer without URI, and not the binary chunk: glTF 2.0, 3.6.1.1, leaves its bytes to others.
bool lacksData(const Document& source, const tinygltf::Primitive& from) {
    const auto lacks = [&source](int accessor) {
        const int view = source.model.accessors[at(accessor)].bufferView;
        if (view == kNone)
            return false;
        const Buffer& buffer = source.buffers[at(source.model.bufferViews[at(view)].buffer)];
        return buffer.bytes.empty() && !buffer.hasUri && source.binaryChunk.empty();
    };
    return std::any_of(from.attributes.begin(), from.attributes.end(),
                       [&](const auto& attribute) { return lacks(attribute.second); }) ||
           (from.indices != kNone && lacks(from.indices));
}

bool isDrawable(Document& source, const tinygltf::Primitive& from, const std::string& where) {
    if (from.mode < TINYGLTF_MODE_TRIANGLES)
        source.warnOnce(kLeftOut, "points and lines are not drawn");
    else if (find(from, "POSITION") == kNone)
        source.warn(kLeftOut, where, "a primitive without positions is not drawn");
    else if (lacksData(source, from))
        source.warn(kLeftOut, where, "a primitive whose buffer has neither URI nor data is not drawn");
    else
        return true;
    return false;
}

// A small file can ask for the same accessors again and again, or for accessors that have no bytes.
bool chargePrimitive(Document& source, const tinygltf::Primitive& from, const std::string& where) {
    constexpr std::size_t kVertexBytes = 72;   // all attributes of a Primitive
    constexpr std::size_t kTangentBytes = 192; // computeTangents(), where it has to split every corner
    const std::size_t vertices = source.model.accessors[at(find(from, "POSITION"))].count;
    const std::size_t read =
        from.indices == kNone ? vertices : source.model.accessors[at(from.indices)].count;
    const std::size_t corners = from.mode == TINYGLTF_MODE_TRIANGLES ? read : 3 * read;
    const bool flat = find(from, "NORMAL") == kNone;
    const std::vector<int> materials = possibleMaterials(from, source.model.materials.size());
    const bool tangents = (flat || find(from, "TANGENT") == kNone) &&
                          std::any_of(materials.begin(), materials.end(), [&](int material) {
                              return source.model.materials[at(material)].normalTexture.index != kNone;
                          });
    return source.charge(vertices, kVertexBytes, where) && source.charge(read, 4, where) &&
           source.charge(corners, 4 + (flat ? kVertexBytes : 0) + (tangents ? kTangentBytes : 0), where);
}

/// Bytes of each vertex that nothing has moved yet, at least, and of its joints and targets.
std::size_t bytesOfVertex(const Deformation& deformation) {
    const auto bytes = [](const auto& values) {
        return values.empty() ? 0 : sizeof(typename std::decay_t<decltype(values)>::value_type);
    };
    std::size_t sum = sizeof(glm::vec3) + deformation.influencesPerVertex * sizeof(Influence);
    for (const Vertices& target : deformation.targets)
        sum += bytes(target.positions) + bytes(target.normals) + bytes(target.tangents) +
               bytes(target.uv[0]) + bytes(target.uv[1]) + bytes(target.colors);
    return sum;
}

bool readPrimitive(Document& source, tinygltf::Primitive from, const std::string& where, const MeshUse& use,
                   Scene& scene, Primitive& primitive) {
    primitive.material = materialOf(from, scene, source.model.materials.size());
    if (!readVariantMaterials(source, from, where, scene.variants.size(), primitive.variantMaterials))
        return false;
    const MaterialChoice materials = materialsOf(primitive, scene);
    Deformation deformation;
    if (!chooseAttributes(source, materials, use, where, from) || !chargePrimitive(source, from, where) ||
        !readAttributes(source, from, primitive) || !readTriangles(source, from, where, primitive) ||
        !readDeformation(source, from, where, use, primitive, deformation))
        return false;
    const bool deforms = !deformation.targets.empty() || !deformation.influences.empty();
    deformation.flat = primitive.normals.empty();
    if (deforms) {
        if (!source.charge(primitive.indices.size(), bytesOfVertex(deformation), where))
            return false;
        primitive.deformation = std::make_shared<const Deformation>(std::move(deformation));
    }
    if (primitive.normals.empty())
        computeFlatNormals(primitive);
    normalize(source, where, primitive);
    completeTangents(source, materials, where, primitive);
    primitive.bounds = boundsOf(primitive.positions);
    if (deforms)
        bind(primitive);
    return true;
}

/// Whether it is of the part that is meant. What no joints move stands where the node does, as glTF 2.0
/// (3.7.3) lets only what has joints and weights leave it.
bool isMeant(Document& source, const tinygltf::Primitive& from, const std::string& where,
             MeshUse::Part part) {
    const bool skinned = find(from, "JOINTS_0") != kNone && find(from, "WEIGHTS_0") != kNone;
    if (part == MeshUse::Part::Unskinned && !skinned)
        source.warn(kMended, where,
                    "a skinned mesh has no JOINTS_0 and WEIGHTS_0 here: it stands where its node does");
    return part == MeshUse::Part::All || skinned == (part == MeshUse::Part::Skinned);
}

} // namespace

bool readMesh(Document& source, int index, const MeshUse& use, Scene& scene, Mesh& mesh) {
    if (!source.need(pathOf("meshes", index)))
        return false;
    const tinygltf::Mesh& from = source.model.meshes[at(index)];
    mesh.name = from.name;
    for (std::size_t p = 0; p < from.primitives.size(); ++p) {
        const std::string where = pathOf("meshes", index, "primitives", p);
        const int mode = from.primitives[p].mode;
        if (mode < TINYGLTF_MODE_POINTS || mode > TINYGLTF_MODE_TRIANGLE_FAN)
            return source.fail("gltf.value", where + "/mode", "there is no mode " + std::to_string(mode));
        if (!isMeant(source, from.primitives[p], where, use.part) ||
            !isDrawable(source, from.primitives[p], where))
            continue;
        Primitive primitive;
        if (!readPrimitive(source, from.primitives[p], where, use, scene, primitive))
            return false;
        if (!primitive.indices.empty())
            mesh.primitives.push_back(std::move(primitive));
    }
    return true;
}

} // namespace franken::gltf
