// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "finite.h"
#include "gltf/material.h"

namespace franken::gltf {
namespace {

glm::vec2 pairOr(const Json& object, const char* key, glm::vec2 otherwise) {
    const Json& pair = member(object, key);
    if (pair.size() != 2 || !pair[0].is_number() || !pair[1].is_number())
        return otherwise;
    return {pair[0].get<float>(), pair[1].get<float>()};
}

// KHR_texture_transform: T * R * S. Which way R turns was read from the extension's first example (the lower
// left quadrant, turned by 90 degrees clockwise): (u, v) goes to (c u + s v, -s u + c v).
glm::mat3 uvTransform(const Json& extension) {
    const glm::vec2 offset = pairOr(extension, "offset", glm::vec2(0.0f));
    const glm::vec2 scale = pairOr(extension, "scale", glm::vec2(1.0f));
    const Json& rotation = member(extension, "rotation");
    const double angle = rotation.is_number() ? rotation.get<double>() : 0;
    const float c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
    return {c * scale.x, -s * scale.x, 0.0f, s * scale.y, c * scale.y, 0.0f, offset.x, offset.y, 1.0f};
}

bool readRef(Document& source, const Json& info, const std::string& where, TextureRef& ref) {
    if (!info.is_object())
        return true;
    ref.texture = info.value("index", kNone);
    ref.uvSet = info.value("texCoord", 0);
    if (const Json& moved = member(member(info, "extensions"), "KHR_texture_transform"); moved.is_object()) {
        ref.transform = uvTransform(moved);
        ref.transformed = ref.transform != glm::mat3(1.0f);
        ref.uvSet = moved.value("texCoord", ref.uvSet);
    }
    if (!isFinite(ref.transform))
        return source.fail("gltf.value", where + "/extensions/KHR_texture_transform",
                           "a number is not finite");
    if (ref && (ref.uvSet < 0 || ref.uvSet > 1)) {
        source.warn(kLeftOut, where,
                    "TEXCOORD_" + std::to_string(ref.uvSet) + " is not supported, only 0 and 1: left out");
        ref = {};
    }
    return true;
}

void readFactor(const Document& source, const FactorRow& row, const std::vector<double>& numbers,
                const std::string& material, MaterialFactors& factors) {
    const std::span<float> factor = row.of(factors);
    for (std::size_t i = 0; i < std::min(numbers.size(), factor.size()); ++i) {
        const double held = std::clamp<double>(numbers[i], row.inFile.least, row.inFile.most);
        if (held != numbers[i])
            source.warn(kMended, material + std::string(row.gltf),
                        "a factor is out of range: clamped, for " + std::string(row.inFile.rule));
        factor[i] = static_cast<float>(held);
    }
}

float emissiveStrength(const tinygltf::Material& material) {
    const auto found = material.extensions.find("KHR_materials_emissive_strength");
    if (found == material.extensions.end() || !found->second.IsObject())
        return 1.0f;
    const tinygltf::Value& strength = found->second.Get("emissiveStrength");
    return strength.IsNumber() ? static_cast<float>(strength.GetNumberAsDouble()) : 1.0f;
}

bool readFactors(Document& source, std::size_t index, const std::string& where, Material& material) {
    for (std::size_t i = 0; i < std::size(kMaterialFactors); ++i)
        readFactor(source, kMaterialFactors[i], source.materials[index].factors[i], where, material.factors);
    const float strength = emissiveStrength(source.model.materials[index]);
    if (!std::isfinite(strength) || strength < 0.0f)
        return source.fail("gltf.value", where + "/extensions/KHR_materials_emissive_strength",
                           "the strength is negative or not finite");
    for (float& channel : material.factors.emissive)
        channel *= strength;
    return true;
}

// The texture says where a surface glows, and most of it does not: without it, none of it may.
bool darken(Material& material, bool hadTexture) {
    if (hadTexture && !material.textures[TextureRole::Emissive])
        material.factors.emissive = {};
    return true;
}

bool readTextures(Document& source, std::size_t index, const std::string& where, Material& material) {
    for (const TextureRoleRow& role : textureRoles())
        if (isMaterials(role.role) && !readRef(source, source.materials[index][role.role],
                                               where + std::string(role.gltf), material.textures[role.role]))
            return false;
    return true;
}

bool readMaterial(Document& source, std::size_t index, const std::string& where, Material& material) {
    const tinygltf::Material& from = source.model.materials[index];
    material.name = from.name;
    material.doubleSided = from.doubleSided;
    material.unlit = from.extensions.contains("KHR_materials_unlit");
    if (from.alphaMode == "MASK")
        material.alphaMode = AlphaMode::Mask;
    else if (from.alphaMode == "BLEND")
        material.alphaMode = AlphaMode::Blend;
    else if (from.alphaMode != "OPAQUE")
        return source.fail("gltf.value", where + "/alphaMode", "there is no alpha mode " + from.alphaMode);
    return readFactors(source, index, where, material) && readTextures(source, index, where, material) &&
           darken(material, from.emissiveTexture.index != kNone);
}

bool readWrap(Document& source, int value, const std::string& where, Wrap& wrap) {
    switch (value) {
    case TINYGLTF_TEXTURE_WRAP_REPEAT:
        wrap = Wrap::Repeat;
        return true;
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
        wrap = Wrap::ClampToEdge;
        return true;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
        wrap = Wrap::MirroredRepeat;
        return true;
    default:
        return source.fail("gltf.value", where, "there is no wrap mode " + std::to_string(value));
    }
}

bool readFilter(Document& source, int value, bool isMag, const std::string& where, Filter& filter) {
    const int last = isMag ? TINYGLTF_TEXTURE_FILTER_LINEAR : TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
    switch (value <= last ? value : 0) {
    case kNone:
        return true; // the default stays
    case TINYGLTF_TEXTURE_FILTER_NEAREST:
        filter = Filter::Nearest;
        return true;
    case TINYGLTF_TEXTURE_FILTER_LINEAR:
        filter = Filter::Linear;
        return true;
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
        filter = Filter::NearestMipmapNearest;
        return true;
    case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST:
        filter = Filter::LinearMipmapNearest;
        return true;
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR:
        filter = Filter::NearestMipmapLinear;
        return true;
    case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR:
        filter = Filter::LinearMipmapLinear;
        return true;
    default:
        return source.fail("gltf.value", where, "there is no such filter: " + std::to_string(value));
    }
}

bool readTexture(Document& source, std::size_t index, Texture& texture) {
    const tinygltf::Texture& from = source.model.textures[index];
    texture.image = from.source;
    if (from.sampler == kNone)
        return true;
    const tinygltf::Sampler& sampler = source.model.samplers[at(from.sampler)];
    const std::string where = pathOf("samplers", from.sampler);
    return source.need(where) && readWrap(source, sampler.wrapS, where + "/wrapS", texture.wrapS) &&
           readWrap(source, sampler.wrapT, where + "/wrapT", texture.wrapT) &&
           readFilter(source, sampler.magFilter, true, where + "/magFilter", texture.magFilter) &&
           readFilter(source, sampler.minFilter, false, where + "/minFilter", texture.minFilter);
}

// Decodes what the materials use, and drops their uses of what cannot be had.
bool resolveImages(Document& source, Scene& scene) {
    std::vector<bool> used(source.images.size(), false), broken;
    const auto imageOf = [&scene](const TextureRef& ref) { return scene.textures[at(ref.texture)].image; };
    for (Material& material : scene.materials)
        for (const TextureRef& ref : material.textures)
            if (ref && imageOf(ref) != kNone)
                used[at(imageOf(ref))] = true;
    if (!readImages(source, used, broken, scene.images))
        return false;
    for (Material& material : scene.materials) {
        const bool glowed = static_cast<bool>(material.textures[TextureRole::Emissive]);
        for (TextureRef& ref : material.textures) {
            if (ref && imageOf(ref) == kNone)
                source.warn(kLeftOut, pathOf("textures", ref.texture),
                            "the texture has no PNG or JPEG image: left out");
            if (ref && (imageOf(ref) == kNone || broken[at(imageOf(ref))]))
                ref = {};
        }
        darken(material, glowed);
    }
    return true;
}

} // namespace

bool readMaterials(Document& source, const std::vector<bool>& used, Scene& scene) {
    scene.textures.resize(source.model.textures.size());
    scene.materials.resize(source.model.materials.size());
    std::vector<bool> sampled(scene.textures.size(), false);
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        Material& material = scene.materials[i];
        const std::string where = pathOf("materials", i);
        if (used[i] && (!source.need(where) || !readMaterial(source, i, where, material)))
            return false;
        for (const TextureRef& ref : material.textures)
            if (ref)
                sampled[at(ref.texture)] = true;
    }
    for (std::size_t i = 0; i < scene.textures.size(); ++i) {
        const std::string where = pathOf("textures", i);
        if (!(source.need(where) && readTexture(source, i, scene.textures[i])) &&
            (sampled[i] || !source.defer(where)))
            return false;
    }
    return resolveImages(source, scene);
}

} // namespace franken::gltf
