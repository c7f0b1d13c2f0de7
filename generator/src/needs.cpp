// SPDX-License-Identifier: MIT
#include "needs.h"

#include "franken/generator/effect.h"

namespace franken {
namespace {

bool asks(const Permutation& p, unsigned traits) { return (p.effect.traits & traits) != 0; }

bool readsNormal(const Permutation& p, const Needs& n) {
    return n.surfaceHook || (n.lightHook && asks(p, kLightReadsNormal));
}

// Others than a first or second sun, which take a normal of any length.
bool needsUnitNormal(const Permutation& p, const Needs& n) {
    return n.skyLit || p.suns > 2 || p.punctualLights > 0 || readsNormal(p, n);
}

LightForm lightFormOf(const Permutation& p, const Needs& n) {
    const bool unitNormal = needsUnitNormal(p, n);
    if (!n.direct)
        return LightForm::None;
    if (p.precision == Precision::Fp16)
        return LightForm::PixelUnit;
    if (p.lightVectors == LightVectors::PerPixel || p.punctualLights > 0 || readsNormal(p, n) || n.toEye)
        return unitNormal ? LightForm::PixelUnit : LightForm::PixelFew;
    const bool worldNormal = unitNormal || (n.turned && p.facingWorkaround);
    return n.normalMap && !worldNormal ? LightForm::VertexTangent : LightForm::VertexWorld;
}

bool changes(const Permutation& p, const Needs& n, unsigned traits) {
    return n.surfaceHook && asks(p, traits);
}

// Views of the material show no light: of an effect, they have the hooks of vertices and base colour alone.
void findHooks(const Permutation& p, Needs& n) {
    n.vertexHook = n.material && asks(p, kVertexHook);
    n.surfaceHook = (n.direct || n.skyLit) && asks(p, kSurfaceHook);
    n.lightHook = n.material && n.shaded && asks(p, kLightHook);
    n.toEye = (n.surfaceHook && asks(p, kSurfaceReadsToEye)) || (n.lightHook && asks(p, kLightReadsToEye));
}

void findLight(const Permutation& p, Needs& n) {
    const bool lit = n.material && n.shaded && p.shading == Shading::Lit;
    n.direct = lit && p.suns + p.punctualLights > 0;
    n.ambient = lit && p.ambient != Ambient::None;
    n.skyLit = n.ambient && dependsOnNormal(p.ambient);
    n.reflection = n.ambient && p.reflection != Reflection::None;
    n.energy = (n.direct || n.reflection) && p.energy;
    n.emissive = lit && p.emissive != Emissive::None;
    findHooks(p, n);
    n.occlusion = (n.ambient || (n.material && p.view == View::Occlusion)) && p.occlusion != Occlusion::None;
    n.normal = n.direct || n.skyLit || readsNormal(p, n) || (n.material && p.view == View::Normal);
    n.normalMap = n.normal && p.normal == Normal::Map;
    n.turned = n.normal && p.sides == Sides::Double;
    n.lightForm = lightFormOf(p, n);
    n.toCamera = n.direct || n.reflection || n.toEye || (n.turned && p.facingWorkaround);
}

// An unlit texel that only a factor comes to. The exact curves have a straight part, which does not cancel.
bool staysEncoded(const Permutation& p, const Needs& n, bool baseColorAlone) {
    return baseColorAlone && p.baseColorTexture && p.decode != Decode::None && p.output == Output::SrgbFast &&
           !p.vertexColor && !n.baseColorHook && !n.lightHook;
}

void findMaterial(const Permutation& p, Needs& n) {
    const bool unlit = n.material && p.shading == Shading::Unlit && n.shaded;
    const bool overlay = p.program == Program::Overlay;
    const bool looked = n.material && p.view == View::BaseColor;
    n.color = unlit || overlay || looked || n.direct || n.ambient;
    n.base = n.color || (n.material && p.alpha != Alpha::Opaque);
    n.baseColorHook = n.material && n.base && asks(p, kBaseColorHook);
    n.encoded = staysEncoded(p, n, unlit || looked);
    n.metallic = n.direct || n.skyLit || (n.material && p.view == View::RoughnessMetallic);
    n.roughness = n.direct || n.reflection || changes(p, n, kSurfaceChangesRoughness) ||
                  (n.material && p.view == View::RoughnessMetallic);
    n.textured = p.metallicRoughness != MetallicRoughness::Factors ||
                 changes(p, n, kSurfaceChangesMetallic | kSurfaceChangesRoughness);
}

} // namespace

Needs needsOf(const Permutation& p) {
    Needs n{};
    n.material = p.program == Program::Surface;
    n.shaded = p.view == View::Shaded;
    n.skinned = n.material && p.influences > 0;
    findLight(p, n);
    findMaterial(p, n);
    const bool textures = (n.color && p.baseColorTexture) || (n.emissive && p.emissive == Emissive::Texture);
    const bool linearOverlay = p.program == Program::Overlay && p.output == Output::Linear;
    n.decode = textures && !n.encoded && p.decode != Decode::None && (n.material || linearOverlay);
    const bool numbers = n.material && !n.shaded && p.view != View::BaseColor;
    n.encode = p.output != Output::Linear && !n.encoded && p.program != Program::Overlay && !numbers;
    return n;
}

} // namespace franken
