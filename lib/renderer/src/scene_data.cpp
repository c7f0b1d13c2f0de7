// SPDX-License-Identifier: MIT
#include "scene_data.h"

#include "franken/scene_check.h"

#include <algorithm>
#include <utility>

namespace franken {
namespace {

/// So many copies of a roughness image beside different normal maps, and so many scales of a normal map: a
/// file may name any number. What is beyond has the mips of another copy, or of the file.
constexpr int kMostWidened = 4;

class Planner {
public:
    Planner(const Scene& scene, const Scene& outline, const Log& log)
        : m_scene(scene), m_outline(outline), m_log(log) {}

    ScenePlan make() {
        std::vector<std::size_t> first; // By scene mesh: its first GpuPrimitive.
        for (const Mesh& mesh : m_scene.meshes) {
            first.push_back(m_gpu.primitives.size());
            for (const Primitive& primitive : mesh.primitives)
                add(primitive);
        }
        for (const Instance& instance : m_scene.instances) {
            const auto mesh = static_cast<std::size_t>(instance.mesh);
            for (std::size_t i = 0; i < m_scene.meshes[mesh].primitives.size(); ++i)
                m_gpu.drawables.push_back({.primitive = first[mesh] + i,
                                           .world = instance.world,
                                           .mirrored = instance.mirrored,
                                           .visible = instance.visible,
                                           .nodeIndex = instance.nodeIndex,
                                           .skin = instance.skin,
                                           .offset = instance.offset});
        }
        return std::move(m_plan);
    }

private:
    void add(const Primitive& primitive) {
        const auto [known, isNew] = m_meshes.try_emplace(&primitive, m_plan.meshes.size());
        if (isNew) {
            m_plan.meshes.push_back(&primitive);
            m_contents.push_back(contentsOf(primitive));
        }
        GpuPrimitive gpu{.mesh = known->second,
                         .contents = m_contents[known->second],
                         .bounds = primitive.bounds,
                         .deformation = primitive.deformation,
                         .materials = {materialFor(primitive.material, m_contents[known->second])}};
        for (const int material : primitive.variantMaterials)
            gpu.materials.push_back(
                materialFor(material == kNone ? primitive.material : material, gpu.contents));
        m_gpu.primitives.push_back(std::move(gpu));
    }

    std::size_t materialFor(int material, const VertexContents& contents) {
        for (std::size_t i = 0; i < m_gpu.materials.size(); ++i)
            if (m_gpu.materials[i].material == material && m_gpu.materials[i].contents == contents)
                return i;
        GpuMaterial gpu{.material = material,
                        .contents = contents,
                        .plan = {},
                        .textures = {},
                        .state = {},
                        .doubleSided = false,
                        .blended = false,
                        .block = {}};
        planMaterial(gpu, m_outline, m_log);
        // Those of the scene, not what they are by now: mips stay as they are through a lost context. Those
        // of now beside other textures, which setMaterial() has set with them.
        const auto index = static_cast<std::size_t>(material);
        const bool isAsAdded = m_outline.materials[index].textures == m_scene.materials[index].textures;
        gpu.inMips = (isAsAdded ? m_scene : m_outline).materials[index].factors;
        for (std::size_t unit = 0; unit < kUsedTextureUnits; ++unit)
            if (gpu.plan.textures[unit] != kNone)
                addTexture(useOf(gpu.plan, gpu.inMips, unit), unit);
        m_gpu.materials.push_back(std::move(gpu));
        return m_gpu.materials.size() - 1;
    }

    const Texture& textureAt(int index) const { return m_scene.textures[static_cast<std::size_t>(index)]; }

    bool isWidened(const TextureUse& use) const {
        return m_scene.normalsWidenRoughness && use.normals != kNone &&
               usesMipmaps(textureAt(use.texture).minFilter) && usesMipmaps(textureAt(use.normals).minFilter);
    }

    bool hasMost(int texture) const {
        int uses = 0;
        for (auto each = m_gpu.textureOf.lower_bound({.texture = texture});
             each != m_gpu.textureOf.end() && each->first.texture == texture; ++each)
            ++uses;
        return uses >= kMostWidened;
    }

    void addTexture(TextureUse use, std::size_t unit) {
        const bool widened = isWidened(use);
        if (!widened)
            use = {.texture = use.texture};
        if (m_gpu.textureOf.contains(use) || (widened && hasMost(use.texture)))
            return;
        const Texture& source = textureAt(use.texture);
        const Image& image = m_scene.images[static_cast<std::size_t>(source.image)];
        SampledImage sampled{&image, source, findRoleAt(unit)->contents};
        if (widened) { // The normal map has a lower unit, and so is there already.
            std::size_t& copies = m_copies[sampled];
            sampled.widening = {m_gpu.textureOf.at({.texture = use.normals}), use.scale, use.factor,
                                use.channel};
            // Many textures of a file may have one image.
            if (!m_textures.contains(sampled) && copies++ >= std::size_t{kMostWidened}) {
                use = {.texture = use.texture};
                sampled.widening = {};
            }
        }
        const auto [known, isNew] = m_textures.try_emplace(sampled, m_plan.textures.size());
        if (isNew)
            m_plan.textures.push_back({sampled, findRoleAt(unit)->defaultTexel});
        m_gpu.textureOf.emplace(use, known->second);
    }

    const Scene& m_scene;
    const Scene& m_outline;
    const Log& m_log;
    ScenePlan m_plan;
    GpuScene& m_gpu = m_plan.gpu;
    MapOfGeometry m_meshes;                 ///< To ScenePlan::meshes.
    std::vector<VertexContents> m_contents; ///< By mesh.
    MapOfSampledImages m_textures;          ///< To ScenePlan::textures.
    MapOfSampledImages m_copies; ///< How many there are beside normal maps, by what is in the file.
};

} // namespace

std::size_t bytesOf(const Piece& piece) {
    if (const auto* const texture = std::get_if<TextureData>(&piece))
        return texture->bytes();
    std::size_t bytes = 0;
    for (const MeshPart& part : std::get<std::vector<MeshPart>>(piece))
        bytes += part.bytes();
    return bytes;
}

Result<SceneData> SceneData::make(SceneInput input) {
    if (Result<void> checked = check(*input.scene); !checked)
        return checked.error();
    ScenePlan plan = Planner(*input.scene, input.outline.scene, input.log).make();
    return SceneData(std::move(input), std::move(plan));
}

namespace {

/// For a message: which of the scene's images it is.
std::string nameOf(const Image& image, const Scene& scene) {
    const std::string element = "images[" + std::to_string(&image - scene.images.data()) + "]";
    return image.name.empty() ? element : element + " \"" + image.name + "\"";
}

} // namespace

void SceneData::keepSpreads(std::size_t normals, const Image& image) {
    std::size_t kept = 0;
    for (const ScenePlan::PlannedTexture& other : m_plan.textures)
        if (const Widening& widening = other.sampled.widening;
            widening.normals == normals && kept < std::size_t{kMostWidened})
            kept += m_spreads.try_emplace({normals, widening.scale}, image, widening.scale).second ? 1 : 0;
}

void SceneData::widen(TextureData& data, std::size_t index) {
    const Widening& widening = m_plan.textures[index].sampled.widening;
    const auto spread = m_spreads.find({widening.normals, widening.scale});
    if (spread == m_spreads.end())
        return; // It has no normal map, or one that cannot be decoded.
    const SampledImage& normals = m_plan.textures[widening.normals].sampled;
    data.roughen(spread->second, fittedSize(*normals.image, normals.sampling, m_input.capabilities),
                 widening.channel, widening.factor);
    const auto needsIt = [&](const ScenePlan::PlannedTexture& other) {
        return other.sampled.widening.normals == widening.normals &&
               other.sampled.widening.scale == widening.scale;
    };
    if (std::none_of(m_plan.textures.begin() + static_cast<std::ptrdiff_t>(index) + 1, m_plan.textures.end(),
                     needsIt))
        m_spreads.erase(spread);
}

TextureData SceneData::textureAt(std::size_t index) {
    const auto& [sampled, defaultTexel] = m_plan.textures[index];
    Result<TextureData> data =
        TextureData::make(*sampled.image, sampled.sampling, sampled.contents, m_input.capabilities,
                          [&](const Image& image) { keepSpreads(index, image); });
    if (data) {
        widen(*data, index);
        return *std::move(data);
    }
    if (m_input.log)
        m_input.log(LogLevel::Warning, nameOf(*sampled.image, *m_input.scene) + ": " +
                                           toString(data.error()) + ": left out [gltf.left-out]");
    return TextureData::texel(defaultTexel, sampled.sampling, sampled.contents);
}

std::optional<Piece> SceneData::next() {
    if (m_mesh < m_plan.meshes.size())
        return partsOf(*m_plan.meshes[m_mesh++], m_input.capabilities);
    if (m_texture < m_plan.textures.size())
        return textureAt(m_texture++);
    return std::nullopt;
}

Result<void> SceneUpload::begin(Device& device, Piece piece) {
    if (auto* const parts = std::get_if<std::vector<MeshPart>>(&piece)) {
        m_current.emplace<MeshUpload>(std::move(*parts));
        return {};
    }
    Result<TextureUpload> begun = TextureUpload::begin(device, std::get<TextureData>(std::move(piece)));
    if (!begun)
        return begun.error();
    m_current.emplace<TextureUpload>(*std::move(begun));
    return {};
}

Result<std::size_t> SceneUpload::step(Device& device, std::size_t maxBytes) {
    if (auto* const texture = std::get_if<TextureUpload>(&m_current)) {
        const std::size_t bytes = texture->step(device.gl, maxBytes);
        if (texture->isDone()) {
            m_textures.push_back(texture->take());
            m_current = {};
        }
        return bytes;
    }
    MeshUpload& mesh = std::get<MeshUpload>(m_current);
    Result<std::size_t> bytes = mesh.step(device, maxBytes);
    if (bytes && mesh.isDone()) {
        m_meshes.push_back(mesh.take());
        m_current = {};
    }
    return bytes;
}

GpuScene SceneUpload::finish(GpuScene plan, const DefaultTextures& defaults) {
    plan.meshes = std::move(m_meshes);
    plan.textures = std::move(m_textures);
    for (GpuMaterial& material : plan.materials)
        bindTextures(material, plan, defaults);
    return plan;
}

Result<GpuScene> upload(Device& device, SceneInput input, const DefaultTextures& defaults) {
    Result<SceneData> data = SceneData::make(std::move(input));
    if (!data)
        return data.error();
    SceneUpload upload;
    while (std::optional<Piece> piece = data->next()) {
        if (Result<void> begun = upload.begin(device, *std::move(piece)); !begun)
            return begun.error();
        piece.reset();
        while (!upload.isIdle())
            if (Result<std::size_t> bytes = upload.step(device); !bytes)
                return bytes.error();
    }
    return upload.finish(data->takePlan(), defaults);
}

} // namespace franken
