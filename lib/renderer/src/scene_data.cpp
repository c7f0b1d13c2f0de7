// SPDX-License-Identifier: MIT
#include "scene_data.h"

#include "franken/scene_check.h"

#include <utility>

namespace franken {
namespace {

class Planner {
public:
    Planner(const Scene& scene, const Scene& outline, const Log& log)
        : m_scene(scene), m_outline(outline), m_log(log) {}

    ScenePlan make() {
        m_gpu.textureOf.assign(m_scene.textures.size(), GpuScene::kNotUploaded);
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
        for (std::size_t unit = 0; unit < kUsedTextureUnits; ++unit)
            addTexture(gpu.plan.textures[unit], unit);
        m_gpu.materials.push_back(std::move(gpu));
        return m_gpu.materials.size() - 1;
    }

    void addTexture(int index, std::size_t unit) {
        if (index == kNone || m_gpu.textureOf[static_cast<std::size_t>(index)] != GpuScene::kNotUploaded)
            return;
        const Texture& source = m_scene.textures[static_cast<std::size_t>(index)];
        const Image& image = m_scene.images[static_cast<std::size_t>(source.image)];
        const SampledImage sampled{&image, source, findRoleAt(unit)->contents};
        const auto [known, isNew] = m_textures.try_emplace(sampled, m_plan.textures.size());
        if (isNew)
            m_plan.textures.push_back({sampled, findRoleAt(unit)->defaultTexel});
        m_gpu.textureOf[static_cast<std::size_t>(index)] = known->second;
    }

    const Scene& m_scene;
    const Scene& m_outline;
    const Log& m_log;
    ScenePlan m_plan;
    GpuScene& m_gpu = m_plan.gpu;
    MapOfGeometry m_meshes;                 ///< To ScenePlan::meshes.
    std::vector<VertexContents> m_contents; ///< By mesh.
    MapOfSampledImages m_textures;          ///< To ScenePlan::textures.
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

TextureData SceneData::textureAt(std::size_t index) {
    const auto& [sampled, defaultTexel] = m_plan.textures[index];
    Result<TextureData> data =
        TextureData::make(*sampled.image, sampled.sampling, sampled.contents, m_input.capabilities);
    if (data)
        return *std::move(data);
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
