// SPDX-License-Identifier: MIT
#include "franken/scene_check.h"

#include "element.h"
#include "finite.h"
#include "motion_check.h"

#include <algorithm>
#include <cmath>

namespace franken {
namespace {

template<typename Vector>
bool areAllFinite(const std::vector<Vector>& vectors) {
    return std::all_of(vectors.begin(), vectors.end(), isFinite<Vector>);
}

bool isWithin(float value, float least, float most) { return value >= least && value <= most; }

/// Gathers the first fault.
class Checker {
public:
    explicit Checker(const Scene& scene) : m_scene(scene) {}

    Result<void> run() {
        each("images", m_scene.images,
             [&](const Image& image, const std::string& where) { add(image, where); });
        each("textures", m_scene.textures,
             [&](const Texture& texture, const std::string& where) { add(texture, where); });
        each("materials", m_scene.materials,
             [&](const Material& material, const std::string& where) { add(material, where); });
        each("meshes", m_scene.meshes, [&](const Mesh& mesh, const std::string& where) {
            each(where + ".primitives", mesh.primitives,
                 [&](const Primitive& primitive, const std::string& place) { add(primitive, place); });
        });
        each("instances", m_scene.instances, [&](const Instance& instance, const std::string& where) {
            expect(isIndex(instance.mesh, m_scene.meshes.size()), where, ".mesh", "there is no such mesh");
            expect(isFinite(instance.world), where, ".world", "its numbers must be finite");
            expectNode(instance.nodeIndex, where);
        });
        each("cameras", m_scene.cameras,
             [&](const Camera& camera, const std::string& where) { expectNode(camera.nodeIndex, where); });
        each("lights", m_scene.lights,
             [&](const Light& light, const std::string& where) { expectNode(light.nodeIndex, where); });
        return m_fault ? checkMotion(m_scene) : std::move(m_fault);
    }

    Result<void> run(const Material& material) {
        add(material, "material");
        return std::move(m_fault);
    }

private:
    template<typename Elements, typename Function>
    void each(const std::string& array, const Elements& elements, Function function) {
        for (std::size_t i = 0; i < elements.size() && m_fault; ++i)
            function(elements[i], elementOf(array, i));
    }

    void expect(bool holds, const std::string& where, const char* member, std::string_view what) {
        if (!holds && m_fault)
            m_fault = Error{"scene.data", where + member, std::string(what),
                            "see scene.h for the values of each member"};
    }

    void expectNode(int node, const std::string& where) {
        expect(node == kNone || isIndex(node, m_scene.nodes.size()), where, ".nodeIndex",
               "there is no such node");
    }

    void add(const Image& image, const std::string& where) {
        const bool hasSize = image.width > 0 && image.height > 0;
        const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
        expect(hasSize, where, "", "it has no pixels");
        const bool hasPixels = image.rgba.size() % 4 == 0 && image.rgba.size() / 4 == pixels;
        expect(!hasSize || hasPixels || (image.rgba.empty() && !image.encoded.empty()), where, ".rgba",
               "it must hold four bytes for each pixel");
    }

    void add(const Texture& texture, const std::string& where) {
        expect(texture.image == kNone || isIndex(texture.image, m_scene.images.size()), where, ".image",
               "there is no such image");
        const auto isWrap = [](Wrap wrap) { return wrap >= Wrap::Repeat && wrap <= Wrap::MirroredRepeat; };
        expect(isWrap(texture.wrapS) && isWrap(texture.wrapT), where, ".wrapS", "there is no such wrap");
        expect(texture.magFilter == Filter::Nearest || texture.magFilter == Filter::Linear, where,
               ".magFilter", "it must be Nearest or Linear");
        expect(texture.minFilter >= Filter::Nearest && texture.minFilter <= Filter::LinearMipmapLinear, where,
               ".minFilter", "there is no such filter");
    }

    /// What is wrong with it; null where nothing is.
    const char* faultOf(const TextureRef& ref) const {
        if (!isIndex(ref.texture, m_scene.textures.size()))
            return "there is no such texture";
        if (m_scene.textures[static_cast<std::size_t>(ref.texture)].image == kNone)
            return "its texture has no image";
        if (ref.uvSet != 0 && ref.uvSet != 1)
            return "its uvSet must be 0 or 1";
        return isFinite(ref.transform) ? nullptr : "its transform must be finite";
    }

    // Names of places are made for faults alone: a material may change in each frame.
    void add(const TextureRef& ref, const std::string& material, std::string_view role) {
        if (!ref)
            return;
        if (const char* fault = faultOf(ref))
            expect(false, material + ": the " + std::string(role) + " texture", "", fault);
    }

    void add(const Material& material, const std::string& where) {
        for (const TextureRoleRow& role : textureRoles())
            if (isMaterials(role.role))
                add(material.textures[role.role], where, role.name);
        addSeparate(material.textures, where);
        add(material.factors, where);
        expect(material.alphaMode >= AlphaMode::Opaque && material.alphaMode <= AlphaMode::Blend, where,
               ".alphaMode", "there is no such mode");
    }

    // A program reads either one texture of both numbers, or two at the same coordinates.
    void addSeparate(const MaterialTextures& textures, const std::string& where) {
        const TextureRef& metallic = textures[TextureRole::Metallic];
        const TextureRef& roughness = textures[TextureRole::Roughness];
        expect(!textures[TextureRole::MetallicRoughness] || (!metallic && !roughness), where,
               ": the metallic-roughness texture",
               "there must be no metallic or roughness texture beside it");
        expect(!metallic || !roughness ||
                   (metallic.uvSet == roughness.uvSet && metallic.transform == roughness.transform),
               where, ": the roughness texture",
               "its uvSet and transform must be those of the metallic texture");
    }

    void add(const MaterialFactors& factors, const std::string& where) {
        for (const FactorRow& row : kMaterialFactors)
            for (const float value : row.of(factors))
                if (!isWithin(value, row.range.least, row.range.most))
                    expect(false, where + ".factors." + std::string(row.name), "", row.range.rule);
    }

    template<typename Vector>
    void addStream(const std::vector<Vector>& values, std::size_t vertices, const std::string& where,
                   const char* member) {
        expect(values.empty() || values.size() == vertices, where, member,
               "it must be empty, or as long as positions");
        expect(areAllFinite(values), where, member, "its numbers must be finite");
    }

    void add(const Primitive& primitive, const std::string& where) {
        const std::size_t vertices = primitive.positions.size();
        expect(isIndex(primitive.material, m_scene.materials.size()), where, ".material",
               "there is no such material");
        const auto isVariant = [&](int material) {
            return material == kNone || isIndex(material, m_scene.materials.size());
        };
        expect(std::all_of(primitive.variantMaterials.begin(), primitive.variantMaterials.end(), isVariant),
               where, ".variantMaterials", "there is no such material");
        expect(areAllFinite(primitive.positions), where, ".positions", "its numbers must be finite");
        expect(primitive.normals.size() == vertices, where, ".normals",
               "there must be one for each position");
        addStream(primitive.normals, vertices, where, ".normals");
        const auto isNormal = [](const glm::vec3& normal) { return normal != glm::vec3(0); };
        expect(std::all_of(primitive.normals.begin(), primitive.normals.end(), isNormal), where, ".normals",
               "they must have a length");
        addStream(primitive.tangents, vertices, where, ".tangents");
        addStream(primitive.uv[0], vertices, where, ".uv[0]");
        addStream(primitive.uv[1], vertices, where, ".uv[1]");
        addStream(primitive.colors, vertices, where, ".colors");
        expect(primitive.indices.size() % 3 == 0, where, ".indices", "there must be three for each triangle");
        const auto isVertex = [&](std::uint32_t index) { return index < vertices; };
        expect(std::all_of(primitive.indices.begin(), primitive.indices.end(), isVertex), where, ".indices",
               "one of them is that of no position");
    }

    const Scene& m_scene;
    Result<void> m_fault;
};

} // namespace

Result<void> check(const Scene& scene) { return Checker(scene).run(); }

Result<void> check(const Scene& scene, const Material& material) { return Checker(scene).run(material); }

} // namespace franken
