// SPDX-License-Identifier: MIT
#include "feature_lines.h"

#include <vector>

using namespace franken;

namespace price {
namespace {

using Features = std::map<std::string, int>;

void addIf(Features& features, bool has, const char* line, int times = 1) {
    if (has && times > 0)
        features[line] += times;
}

void addSurface(Features& features, const Permutation& p) {
    addIf(features, p.baseColorTexture, "base colour texture");
    addIf(features, p.vertexColor, "vertex colour");
    addIf(features, p.normal == Normal::Map, "normal map");
    addIf(features, p.metallicRoughness == MetallicRoughness::Packed, "metallic-roughness texture");
    addIf(features, p.metallicRoughness == MetallicRoughness::Separate,
          "metalness and roughness, two textures");
    addIf(features, p.occlusion == Occlusion::Texture, "occlusion texture");
    addIf(features, p.occlusion == Occlusion::Packed, "occlusion in the metallic-roughness texture");
    addIf(features, p.emissive == Emissive::Factor, "emission by factor");
    addIf(features, p.emissive == Emissive::Texture, "emissive texture");
    addIf(features, p.alpha == Alpha::Mask, "alpha mask");
    addIf(features, p.alpha == Alpha::Blend, "alpha blending");
    addIf(features, p.sides == Sides::Double, "double-sided");
    addIf(features, p.uv0Transform || p.uv1Transform, "texture transform");
    bool second = false;
    for (const UvStream stream :
         {p.baseColorUv, p.metallicRoughnessUv, p.normalUv, p.occlusionUv, p.emissiveUv})
        second = second || stream == UvStream::Uv1;
    addIf(features, second, "second texture coordinates");
    if (p.influences > 0)
        ++features["skin, " + std::to_string(p.influences) + (p.influences == 1 ? " joint" : " joints") +
                   " a vertex"];
}

void addLights(Features& features, const Permutation& p) {
    addIf(features, p.ambient != Ambient::None, "ambient colour");
    addIf(features, p.ambient == Ambient::Sky, "sky (SH) instead of the ambient colour");
    addIf(features, p.reflection != Reflection::None, "reflection of the sky as well");
    addIf(features, p.suns > 0, "1st sun");
    addIf(features, p.suns > 1, "2nd sun");
    addIf(features, p.suns > 2, "3rd and 4th sun, together");
    const bool perVertex = p.lightVectors == LightVectors::PerVertex;
    addIf(features, perVertex,
          p.suns > 2 ? "light vectors per vertex, 4 suns" : "light vectors per vertex, 1 sun");
    addIf(features, p.punctualLights > 0, "1st punctual light");
    addIf(features, p.punctualLights > 1, "2nd punctual light", p.punctualLights - 1);
    addIf(features, p.spots, "the light is a spot", p.punctualLights);
    addIf(features, p.brdf == Brdf::Seed, "BRDF of the seed instead of glTF's");
    addIf(features, p.brdf == Brdf::Fast, "BRDF fast instead of glTF's");
    addIf(features, p.brdf == Brdf::Schlick, "BRDF schlick instead of glTF's");
    const bool isTextured = p.metallicRoughness != MetallicRoughness::Factors;
    addIf(features, p.energy,
          p.reflection != Reflection::None ? "energy, with the reflection of the sky"
          : isTextured                     ? "energy, roughness by texture"
                                           : "energy, roughness by factor");
}

void addPicture(Features& features, const Permutation& p) {
    addIf(features, p.decode == Decode::Exact, "exact sRGB decode instead of the cubic");
    addIf(features, p.decode == Decode::None, "no decode instead of the cubic");
    addIf(features, p.output == Output::Srgb, "exact sRGB encode instead of the fast one");
    addIf(features, p.output == Output::Pow22, "encode by 1/2.2 instead of fast sRGB");
    addIf(features, p.output == Output::Linear, "no encode instead of fast sRGB");
    addIf(features, p.toneMap == ToneMap::Reinhard, "tone map: Reinhard");
    addIf(features, p.toneMap == ToneMap::Aces, "tone map: ACES");
    addIf(features, p.toneMap == ToneMap::Neutral, "tone map: Khronos neutral");
    addIf(features, p.dither != Dither::None, "dither");
}

} // namespace

Features featuresOf(const Permutation& program) {
    Features features;
    addSurface(features, program);
    addLights(features, program);
    addPicture(features, program);
    return features;
}

} // namespace price
