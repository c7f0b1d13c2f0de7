// SPDX-License-Identifier: MIT
#include "franken/material.h"

#include "franken/deform.h"
#include "franken/tessellation.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cassert>
#include <optional>
#include <vector>

namespace franken {
namespace {

Float9 toFloat9(const glm::mat3& matrix) {
    Float9 values;
    std::copy_n(glm::value_ptr(matrix), values.size(), values.begin());
    return values;
}

/// Hands out the two streams to textures as they come.
class Streams {
public:
    Streams(const Material& material, const VertexContents& contents, const Log& log)
        : m_material(material), m_contents(contents), m_log(log) {}

    /// The stream that feeds the texture; none where it must be left out.
    std::optional<UvStream> find(const TextureRef& ref, std::string_view role);

    std::size_t count() const { return m_used.size(); }
    const TextureRef& operator[](std::size_t stream) const { return *m_used[stream]; }

    void warn(std::string_view role, const std::string& reason) const {
        if (m_log)
            m_log(LogLevel::Warning, "material \"" + m_material.name + "\": the " + std::string(role) +
                                         " texture is left out: " + reason);
    }

private:
    const Material& m_material;
    const VertexContents& m_contents;
    const Log& m_log;
    std::vector<const TextureRef*> m_used;
};

std::optional<UvStream> Streams::find(const TextureRef& ref, std::string_view role) {
    if (!m_contents.uv[static_cast<std::size_t>(ref.uvSet)]) {
        warn(role, "the mesh has no TEXCOORD_" + std::to_string(ref.uvSet));
        return std::nullopt;
    }
    for (std::size_t stream = 0; stream < m_used.size(); ++stream)
        if (m_used[stream]->uvSet == ref.uvSet && m_used[stream]->transform == ref.transform)
            return static_cast<UvStream>(stream);
    if (m_used.size() == 2) {
        warn(role, "it would be the third pair of texture coordinates and transform, and there are two");
        return std::nullopt;
    }
    m_used.push_back(&ref);
    return static_cast<UvStream>(m_used.size() - 1);
}

bool sameSampling(const Scene& scene, const TextureRef& a, const TextureRef& b) {
    const Texture& left = scene.textures[static_cast<std::size_t>(a.texture)];
    const Texture& right = scene.textures[static_cast<std::size_t>(b.texture)];
    return a.uvSet == b.uvSet && a.transform == b.transform && left.image == right.image &&
           left.wrapS == right.wrapS && left.wrapT == right.wrapT && left.magFilter == right.magFilter &&
           left.minFilter == right.minFilter;
}

class Planner {
public:
    Planner(const Scene& scene, const Material& material, const VertexContents& contents, const Log& log)
        : m_scene(scene), m_material(material), m_contents(contents), m_streams(material, contents, log) {
        m_plan.textures.fill(kNone);
    }

    MaterialPlan make() {
        m_plan.factors = m_material.factors;
        planBase();
        planNormal();
        planReflection();
        planEmissive();
        planStreams();
        m_plan.fine = m_contents.fine;
        choices().influences = m_contents.influences;
        choices().joints = m_contents.joints;
        return m_plan;
    }

private:
    Permutation& choices() { return m_plan.permutation; }

    // Gives the texture to its role; false where there is none, or where its coordinates have no stream.
    bool take(TextureRole role) {
        const TextureRef& ref = m_material.textures[role];
        const TextureRoleRow& row = rowOf(role);
        if (!ref)
            return false;
        const std::optional<UvStream> found = m_streams.find(ref, row.name);
        if (!found)
            return false;
        choices().*row.stream = *found;
        m_plan.textures[row.unit] = ref.texture;
        return true;
    }

    void planBase() {
        choices().baseColorTexture = take(TextureRole::BaseColor);
        choices().vertexColor = m_contents.colors;
        choices().sides = m_material.doubleSided ? Sides::Double : Sides::Single;
        choices().shading = m_material.unlit ? Shading::Unlit : Shading::Lit;
        choices().alpha = m_material.alphaMode == AlphaMode::Mask    ? Alpha::Mask
                          : m_material.alphaMode == AlphaMode::Blend ? Alpha::Blend
                                                                     : Alpha::Opaque;
    }

    void planNormal() {
        if (m_material.textures[TextureRole::Normal] && !m_contents.tangents)
            return m_streams.warn(rowOf(TextureRole::Normal).name, "the mesh has no tangents");
        if (take(TextureRole::Normal))
            choices().normal = Normal::Map;
    }

    void planReflection() {
        const TextureRef& packed = m_material.textures[TextureRole::MetallicRoughness];
        const TextureRef& occlusion = m_material.textures[TextureRole::Occlusion];
        if (take(TextureRole::MetallicRoughness))
            choices().metallicRoughness = MetallicRoughness::Packed;
        const bool metallic = take(TextureRole::Metallic), roughness = take(TextureRole::Roughness);
        if (metallic || roughness)
            choices().metallicRoughness = MetallicRoughness::Separate;
        if (choices().metallicRoughness == MetallicRoughness::Packed && occlusion &&
            sameSampling(m_scene, packed, occlusion))
            choices().occlusion = Occlusion::Packed;
        else if (take(TextureRole::Occlusion))
            choices().occlusion = Occlusion::Texture;
    }

    void planEmissive() {
        if (m_material.factors.emissive == Float3{})
            return;
        if (take(TextureRole::Emissive))
            choices().emissive = Emissive::Texture;
        else if (!m_material.textures[TextureRole::Emissive])
            choices().emissive = Emissive::Factor;
        else // The texture says where a surface glows: without it, none of it may.
            m_plan.factors.emissive = {};
    }

    void planStreams() {
        for (std::size_t i = 0; i < m_streams.count(); ++i) {
            m_plan.uvSets[i] = m_streams[i].uvSet;
            (i == 0 ? choices().uv0Transform : choices().uv1Transform) = m_streams[i].transformed;
            (i == 0 ? m_plan.uvTransforms.uv0 : m_plan.uvTransforms.uv1) = toFloat9(m_streams[i].transform);
        }
    }

    const Scene& m_scene;
    const Material& m_material;
    const VertexContents& m_contents;
    Streams m_streams;
    MaterialPlan m_plan;
};

void apply(const Look& look, Permutation& permutation) {
    permutation.brdf = look.brdf;
    permutation.energy = look.energy;
    permutation.decode = look.decode;
    permutation.toneMap = look.toneMap;
    permutation.output = look.srgbTarget ? Output::Linear : look.output;
    permutation.dither = look.dither;
    permutation.view = look.view;
    permutation.target = look.target;
    permutation.facingWorkaround = look.facingWorkaround;
    permutation.precision = look.precision;
    if (!look.joints)
        permutation.influences = 0;
    permutation.joints = permutation.influences == 0 ? Joints() : std::min(permutation.joints, *look.joints);
}

Result<Permutation> canonical(const Permutation& permutation) {
    return canonicalise(permutation).transform([](const Canonical& found) { return found.permutation; });
}

} // namespace

namespace {

/// Room for so many joints; where they are too many, the most there is.
Joints jointsFor(std::size_t count) {
    for (const Joints joints : {Joints::UpTo32, Joints::UpTo64})
        if (count <= roomFor(joints))
            return joints;
    return Joints::UpTo256;
}

std::size_t countOfJoints(const Deformation& deformation) {
    std::vector<std::uint32_t> joints;
    for (const Influence& influence : deformation.influences)
        if (influence.weight != 0.0f)
            joints.push_back(influence.joint);
    std::sort(joints.begin(), joints.end());
    return static_cast<std::size_t>(std::unique(joints.begin(), joints.end()) - joints.begin());
}

} // namespace

bool isForVertexShader(const Primitive& primitive) {
    if (!primitive.deformation || primitive.indices.empty())
        return false;
    const Deformation& deformation = *primitive.deformation;
    return deformation.influencesPerVertex >= 1 &&
           deformation.influencesPerVertex <= Permutation::kMaxInfluences && !deformation.flat;
}

VertexContents contentsOf(const Primitive& primitive) {
    const bool skinned = isForVertexShader(primitive);
    return {.tangents = !primitive.tangents.empty(),
            .uv = {!primitive.uv[0].empty(), !primitive.uv[1].empty()},
            .colors = !primitive.colors.empty(),
            .fine = normalTurn(primitive) <= kFineNormalTurn,
            .influences = skinned ? static_cast<std::uint8_t>(primitive.deformation->influencesPerVertex)
                                  : std::uint8_t{0},
            .joints = skinned ? jointsFor(countOfJoints(*primitive.deformation)) : Joints::UpTo32};
}

MaterialPlan planMaterial(const Scene& scene, int material, const VertexContents& contents, const Log& log) {
    assert(material >= 0 && static_cast<std::size_t>(material) < scene.materials.size());
    return Planner(scene, scene.materials[static_cast<std::size_t>(material)], contents, log).make();
}

void replaceFactors(MaterialPlan& plan, const Material& material) {
    plan.factors = material.factors;
    if (plan.permutation.emissive == Emissive::None)
        plan.factors.emissive = {};
}

Result<Permutation> permutationOf(const MaterialPlan& plan, const Lighting& lighting, const Look& look) {
    if (!fittingOf(lighting).empty())
        return permutationOf(plan, fittedLighting(lighting), look);
    Permutation permutation = plan.permutation;
    apply(look, permutation);
    permutation.effect = look.effect;
    if (plan.fine)
        permutation.lightVectors = look.lightVectors;
    permutation.ambient = lighting.ambient.kind;
    if (lighting.ambient.kind == Ambient::Sky)
        permutation.reflection = lighting.reflection;
    permutation.suns = static_cast<std::uint8_t>(lighting.suns.size());
    permutation.punctualLights = static_cast<std::uint8_t>(lighting.punctualLights.size());
    permutation.spots = std::any_of(lighting.punctualLights.begin(), lighting.punctualLights.end(),
                                    [](const PunctualLight& light) { return light.spot; });
    return canonical(permutation);
}

Result<Permutation> skyPermutation(const Look& look) {
    Permutation permutation;
    permutation.program = Program::Sky;
    apply(look, permutation);
    return canonical(permutation);
}

} // namespace franken
