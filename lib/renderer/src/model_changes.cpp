// SPDX-License-Identifier: MIT
// Changes of a model that is loaded: its variant, its materials, its textures.
#include "checked_upload.h"
#include "checks.h"
#include "franken/guard.h"
#include "franken/scene_check.h"
#include "models.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace franken {
namespace {

/// The index of the variant; kNone for none of them ("").
Result<int> findVariant(const Model& model, std::string_view name) {
    if (name.empty())
        return kNone;
    const std::vector<std::string>& variants = model.outline.scene.variants;
    const auto found = std::find(variants.begin(), variants.end(), name);
    if (found != variants.end())
        return static_cast<int>(found - variants.begin());
    std::string known;
    for (const std::string& variant : variants)
        known += (known.empty() ? "" : ", ") + variant;
    return Error{"renderer.variant", std::string(name), "the model has no such variant",
                 variants.empty() ? "it has none: pass \"\"" : "it has " + known};
}

/// Whether both are drawn by the same programs with the same textures.
bool differInFactorsAlone(const Material& a, const Material& b) {
    const auto glows = [](const Material& material) { return material.factors.emissive != Float3{}; };
    return a.textures == b.textures && a.alphaMode == b.alphaMode && a.doubleSided == b.doubleSided &&
           a.unlit == b.unlit && glows(a) == glows(b);
}

Error unknownMaterial(int index, std::size_t count) {
    return {"renderer.material", "materials[" + std::to_string(index) + "]", "there is no such material",
            "the model has " + std::to_string(count) + ": see namesOf()"};
}

Error unknownTexture(const char* code, int index) {
    return {
        code, "textures[" + std::to_string(index) + "]",
        "no material of the model was drawn with that texture when it was uploaded, so that it is not there",
        "use it in a material, or a variant's, before add()"};
}

/// Of a texture of the scene, each once; those that no other texture of the scene has as well.
std::vector<std::size_t> uploadsOfNoOther(const GpuScene& gpu, int texture) {
    std::vector<std::size_t> own;
    for (const auto& [use, uploaded] : gpu.textureOf) {
        const auto isOthers = [&, place = uploaded](const auto& each) {
            return each.second == place && each.first.texture != texture;
        };
        if (use.texture == texture && std::find(own.begin(), own.end(), uploaded) == own.end() &&
            std::none_of(gpu.textureOf.begin(), gpu.textureOf.end(), isOthers))
            own.push_back(uploaded);
    }
    return own;
}

} // namespace

Result<void> Models::setVariant(ModelId id, std::string_view name) {
    Model* const model = find(id);
    if (model == nullptr)
        return unknownModel();
    const Result<int> variant = findVariant(*model, name);
    if (!variant)
        return variant.error();
    for (Place* place : model->places)
        place->variant = *variant;
    ++m_revision;
    return {};
}

Result<void> Models::setVariant(PlaceId id, std::string_view name) {
    Place* const place = find(id);
    if (place == nullptr)
        return unknownPlace();
    const Result<int> variant = findVariant(*place->model, name);
    if (!variant)
        return variant.error();
    place->variant = *variant;
    ++m_revision;
    return {};
}

Result<Material> Models::materialOf(ModelId id, int index) const {
    const Model* const model = find(id);
    if (model == nullptr)
        return unknownModel();
    const std::vector<Material>& materials = model->outline.scene.materials;
    if (!isIndex(index, materials.size()))
        return unknownMaterial(index, materials.size());
    return materials[static_cast<std::size_t>(index)];
}

Result<void> checkLoaded(Model& model, int index, const Material& values) {
    Material& current = model.outline.scene.materials[static_cast<std::size_t>(index)];
    Material others = values;
    std::swap(current, others);
    Result<void> loaded;
    for (const GpuMaterial& material : model.gpu->materials)
        if (material.material == index)
            for (const int texture : planMaterial(model.outline.scene, index, material.contents).textures)
                if (texture != kNone && model.gpu->findTexture(texture) == nullptr)
                    loaded = unknownTexture("renderer.material", texture);
    std::swap(current, others);
    return loaded;
}

Result<void> Models::setMaterial(ModelId id, int index, const Material& values) {
    Model* const model = find(id);
    if (model == nullptr)
        return unknownModel();
    Scene& outline = model->outline.scene;
    if (!isIndex(index, outline.materials.size()))
        return unknownMaterial(index, outline.materials.size());
    if (const Result<void> checked = check(outline, values); !checked)
        return Error{"renderer.material", checked.error().where, checked.error().what,
                     "nothing was changed: pass another value"};
    Material& current = outline.materials[static_cast<std::size_t>(index)];
    const bool factorsAlone = differInFactorsAlone(current, values);
    const bool isRetextured = current.textures != values.textures;
    if (model->gpu && !factorsAlone)
        if (Result<void> loaded = checkLoaded(*model, index, values); !loaded)
            return loaded;
    current = values;
    model->changedMaterials[index] = values;
    if (!model->gpu)
        return {};
    for (GpuMaterial& material : model->gpu->materials)
        if (material.material == index) {
            if (isRetextured)
                material.inMips = values.factors;
            factorsAlone ? replaceFactors(material, outline) : replan(material, *model);
        }
    return {};
}

Result<void> Models::setTexture(ModelId id, int index, const Image& image, PictureSource source) {
    Model* const model = find(id);
    if (model == nullptr)
        return unknownModel();
    if (Result<void> checked = check(image); !checked)
        return checked;
    if (!isIndex(index, model->outline.scene.textures.size()) ||
        (model->gpu && model->gpu->findTexture(index) == nullptr))
        return unknownTexture("renderer.texture", index);
    if (model->gpu)
        if (Result<void> replaced = replaceTexture(*model, index, image); !replaced)
            return replaced;
    TextureChange& change = model->changedTextures[index];
    change.image = source ? Image{} : image;
    change.source = std::move(source);
    return {};
}

void Models::replan(GpuMaterial& material, const Model& model) {
    planMaterial(material, model.outline.scene, m_device.log);
    bindTextures(material, *model.gpu, *m_defaults);
    ++m_revision; // It may be blended now, or seen from both sides.
}

Result<void> Models::replaceTexture(Model& model, int index, const Image& image) {
    GpuScene& gpu = *model.gpu;
    const Texture& sampling = model.outline.scene.textures[static_cast<std::size_t>(index)];
    const TextureContents contents = gpu.textures[*gpu.findTexture(index)].contents;
    const std::vector<std::size_t> own = uploadsOfNoOther(gpu, index);
    const Result<bool> updated = own.empty() ? Result<bool>(false) : checkedUpload(m_device, [&] {
        return updateTexture(m_device, gpu.textures[own.front()], image, sampling);
    });
    if (!updated)
        return updated.error();
    const std::size_t place = own.empty() ? gpu.textures.size() : own.front();
    if (!*updated) {
        Result<GpuTexture> made =
            checkedUpload(m_device, [&] { return uploadTexture(m_device, image, sampling, contents); });
        if (!made)
            return made.error();
        gpu.textures.resize(std::max(gpu.textures.size(), place + 1));
        gpu.textures[place] = *std::move(made);
        gpu.anisotropy = 1; // The next frame sets that of all.
    }
    for (const std::size_t other : own)
        if (other != place)
            gpu.textures[other] = {};
    for (auto& [use, uploaded] : gpu.textureOf)
        if (use.texture == index)
            uploaded = place;
    for (GpuMaterial& material : gpu.materials)
        bindTextures(material, gpu, *m_defaults);
    return {};
}

Result<void> Models::applyChanges(Model& model) {
    for (const auto& [index, change] : model.changedTextures) {
        if (model.gpu->findTexture(index) == nullptr)
            continue; // The source reads another file now.
        const Result<Image> read =
            change.source ? guarded("the source of a texture", change.source) : Result<Image>(change.image);
        if (!read)
            return read.error();
        if (Result<void> checked = check(*read); !checked)
            return checked;
        if (Result<void> replaced = replaceTexture(model, index, *read); !replaced)
            return replaced;
    }
    return {};
}

Result<ModelNames> Models::namesOf(ModelId id) const {
    const Model* const model = find(id);
    if (model == nullptr)
        return unknownModel();
    ModelNames names{
        .nodes = model->outline.nodes, .materials = {}, .variants = model->outline.scene.variants};
    for (const Material& material : model->outline.scene.materials)
        names.materials.push_back(material.name);
    return names;
}

} // namespace franken
