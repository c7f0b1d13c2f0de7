// SPDX-License-Identifier: MIT
#include "franken/generator/pack.h"

#include "numbers.h"
#include "pack_fields.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>

namespace franken {
namespace {

constexpr std::size_t kFactorBytes =
    std::accumulate(std::begin(kMaterialFactors), std::end(kMaterialFactors), std::size_t{0},
                    [](std::size_t sum, const FactorRow& row) { return sum + row.size; });
static_assert(kFactorBytes == sizeof(MaterialFactors), "each member has its row");

constexpr float kInversePi = std::numbers::inv_pi_v<float>;

// The coefficients of c^3, c^2 and c of a cubic through (0, 0) and (1, 1), fitted to the sRGB curve.
constexpr Float3 kDecodeCubic = {0.305306011f, 0.682171111f, 0.012522878f};

// The shadowing's coefficients as the lobes take them, with the rest of the lobe's constants folded in.
Float3 packLobe(float roughness, Brdf brdf) {
    const float clamped = std::max(roughness, kMinRoughness);
    const float alpha = clamped * clamped;
    const float alpha2 = alpha * alpha;
    const float slope = 1 - alpha2;
    const auto schlick = [&](float k) { return Float3{slope, (1 - k) * 2 / alpha, k * 2 / alpha}; };
    switch (brdf) {
    case Brdf::Gltf:
        return {slope, 4 * slope / (alpha2 * alpha2), 4 / alpha2};
    case Brdf::Fast:
        return {slope, 4 * (1 - alpha) / alpha2, 2 * alpha / alpha2};
    case Brdf::Seed:
        return schlick((roughness + 1) * (roughness + 1) / 8);
    case Brdf::Schlick:
        return schlick(alpha / 2);
    }
    return {};
}

// glTF mixes a dielectric and a metal; the seed takes one F0 for both, so that the specular layer takes its
// share from the base colour's channels.
Float4 packReflectance(float metallic, Brdf brdf) {
    const float dielectric = 0.04f * (1 - metallic);
    if (brdf == Brdf::Seed)
        return {(1 - metallic) * (1 - dielectric), metallic, dielectric, (1 - metallic) * metallic};
    return {kDielectricScatters * (1 - metallic), metallic, dielectric, 1 - dielectric};
}

// The constants of docs/energy_fit.py. They make log2(1 / E - 1) of log2 N.V, of the logarithm of the square
// under Smith's root, and of nothing.
Float4 packEnergy(float roughness) {
    const float r = std::max(roughness, kMinRoughness);
    const float alpha = r * r;
    return {2.1805f - 3.3946f * r + 2.0739f * alpha, -2.0794f + 2.5582f * r - 0.673f * alpha,
            0.6966f - 0.0497f * r + 0.5182f * alpha + 4.1169f * std::log2(r), alpha * alpha};
}

// The power part of the sRGB curve (IEC 61966-2-1) turns a factor of light into a scale and an offset of
// codes.
std::array<Float3, 2> packEncoded(const Float3& factor) {
    std::array<Float3, 2> encoded;
    for (std::size_t i = 0; i < factor.size(); ++i) {
        encoded[0][i] = std::pow(std::max(factor[i], 0.0f), 1 / 2.4f);
        encoded[1][i] = 0.055f * (encoded[0][i] - 1);
    }
    return encoded;
}

// The most radiance of a light (as in lights/distance_attenuation.fp16).
constexpr float kMostOfALightFp16 = 16;

} // namespace

float reflectionBend(float roughness, float metallic) { return roughness * roughness * (metallic + 0.6f); }

float energyCompensation(float nDotV, float roughness) {
    const Float4 energy = packEnergy(roughness);
    const float smith2 = nDotV * nDotV * (1 - energy[3]) + energy[3];
    return std::exp2(energy[0] * std::log2(nDotV) + energy[1] * std::log2(smith2) + energy[2]);
}

MaterialBlock packMaterial(const MaterialFactors& factors, Brdf brdf, float exposure) {
    const Float3 base = {factors.baseColor[0], factors.baseColor[1], factors.baseColor[2]};
    const float bend = reflectionBend(factors.roughness, factors.metallic);
    const Float3 emissive = scaled(factors.emissive, exposure);
    return {.baseColor = factors.baseColor,
            .baseColorCubic = {scaled(base, kDecodeCubic[0]), scaled(base, kDecodeCubic[1]),
                               scaled(base, kDecodeCubic[2])},
            .baseColorEncoded = packEncoded(base),
            .metallicRoughness = {factors.metallic, factors.roughness},
            .reflectance = packReflectance(factors.metallic, brdf),
            .lobe = packLobe(factors.roughness, brdf),
            .reflectionLobe = {factors.roughness, bend, 2 - bend},
            .energy = packEnergy(factors.roughness),
            .occlusion = {factors.occlusionStrength, 1 - factors.occlusionStrength},
            .emissive = emissive,
            .emissiveCubic = {scaled(emissive, kDecodeCubic[0]), scaled(emissive, kDecodeCubic[1]),
                              scaled(emissive, kDecodeCubic[2])},
            .normalScale = factors.normalScale,
            .alphaCutoff = factors.alphaCutoff,
            .uv = {}};
}

MaterialBlock packMaterial(const MaterialFactors& factors, Brdf brdf, float exposure, Precision precision) {
    if (precision == Precision::Fp32)
        return packMaterial(factors, brdf, exposure);
    MaterialFactors held = factors;
    held.roughness = std::max(factors.roughness, kMinRoughnessFp16);
    held.emissive = scaled(factors.emissive, exposure);
    limit(held.emissive, kMostRadianceFp16);
    return packMaterial(held, brdf, 1);
}

void packSun(LightsBlock& block, std::size_t index, const Sun& sun, float exposure) {
    assert(index < Permutation::kMaxLights);
    block.sunDirection[index] = scaled(unit(sun.direction), -1);
    block.sunRadiance[index] = scaled(sun.color, sun.illuminance * kInversePi * exposure);
}

void packPunctualLight(LightsBlock& block, std::size_t index, const PunctualLight& light,
                       const Double3& camera, float exposure) {
    assert(index < Permutation::kMaxLights);
    const float inverseRange2 = light.range > 0 ? 1 / (light.range * light.range) : 0;
    block.punctualPosition[index][3] = inverseRange2;
    for (std::size_t axis = 0; axis < 3; ++axis)
        block.punctualPosition[index][axis] = static_cast<float>(light.position[axis] - camera[axis]);
    block.punctualRadiance[index] = scaled(light.color, light.intensity * kInversePi * exposure);
    block.punctualAxis[index] = unit(light.direction);
    const float cosOuter = std::cos(light.outerCone);
    const float scale = 1 / std::max(0.001f, std::cos(light.innerCone) - cosOuter);
    block.punctualCone[index] = light.spot ? Float2{scale, -cosOuter * scale} : Float2{0, 1};
}

float lengthScaleFp16(float farthest) { return std::min(1.0f, kMaxLengthFp16 / std::max(farthest, 1.0f)); }

void fitToFp16(LightsBlock& block, float farthest) {
    fitToFp16(block.ambient);
    for (Float3& radiance : block.sunRadiance)
        limit(radiance, kMostOfALightFp16);
    for (std::size_t i = 0; i < block.punctualPosition.size(); ++i) {
        const Float4& position = block.punctualPosition[i];
        const float scale = lengthScaleFp16(std::hypot(position[0], position[1], position[2]) + farthest);
        block.punctualScale[i] = scale;
        block.punctualWindow[i] = std::min(position[3] / (scale * scale), kMostFp16);
        block.punctualRadiance[i] = scaled(block.punctualRadiance[i], scale * scale);
        limit(block.punctualRadiance[i], kMostFp16);
        const Float2& cone = block.punctualCone[i];
        block.punctualCone[i] = {cone[0] / 2, cone[0] + cone[1]}; // By 1 - cos instead of cos.
    }
}

std::size_t roomFor(Joints joints) {
    switch (joints) {
    case Joints::UpTo32:
        return 32;
    case Joints::UpTo64:
        return 64;
    case Joints::UpTo256:
        break;
    }
    return kMaxJoints;
}

Float3 packDither(const std::array<int, 3>& bits) {
    const auto step = [](int count) { return 1 / static_cast<float>((1 << count) - 1); };
    return {step(bits[0]), step(bits[1]), step(bits[2])};
}

namespace {

constexpr PackField kFields[] = {
    {Block::Frame, "uCameraPosition", offsetof(FrameBlock, cameraPosition)},
    {Block::Frame, "uClipToSky", offsetof(FrameBlock, clipToSky)},
    {Block::Frame, "uSkyRange", offsetof(FrameBlock, skyRange)},
    {Block::Frame, "uReflectionScale", offsetof(FrameBlock, reflectionScale)},
    {Block::Frame, "uDither", offsetof(FrameBlock, dither)},
    {Block::Frame, "uLengthScale", offsetof(FrameBlock, lengthScale)},
    {Block::Frame, "uLengthUnit", offsetof(FrameBlock, lengthUnit)},
    {Block::Lights, "uSun#Direction", offsetof(LightsBlock, sunDirection),
     sizeof(LightsBlock::sunDirection[0])},
    {Block::Lights, "uSun#Radiance", offsetof(LightsBlock, sunRadiance), sizeof(LightsBlock::sunRadiance[0])},
    {Block::Lights, "uPunctual#Position", offsetof(LightsBlock, punctualPosition),
     sizeof(LightsBlock::punctualPosition[0])},
    {Block::Lights, "uPunctual#Radiance", offsetof(LightsBlock, punctualRadiance),
     sizeof(LightsBlock::punctualRadiance[0])},
    {Block::Lights, "uPunctual#Axis", offsetof(LightsBlock, punctualAxis),
     sizeof(LightsBlock::punctualAxis[0])},
    {Block::Lights, "uPunctual#Cone", offsetof(LightsBlock, punctualCone),
     sizeof(LightsBlock::punctualCone[0])},
    {Block::Lights, "uPunctual#Scale", offsetof(LightsBlock, punctualScale),
     sizeof(LightsBlock::punctualScale[0])},
    {Block::Lights, "uPunctual#Window", offsetof(LightsBlock, punctualWindow),
     sizeof(LightsBlock::punctualWindow[0])},
    {Block::Material, "uBaseColor", offsetof(MaterialBlock, baseColor)},
    {Block::Material, "uBaseColorCubic", offsetof(MaterialBlock, baseColorCubic)},
    {Block::Material, "uBaseColorEncoded", offsetof(MaterialBlock, baseColorEncoded)},
    {Block::Material, "uMetallicRoughness", offsetof(MaterialBlock, metallicRoughness)},
    {Block::Material, "uReflectance", offsetof(MaterialBlock, reflectance)},
    {Block::Material, "uLobe", offsetof(MaterialBlock, lobe)},
    {Block::Material, "uReflectionLobe", offsetof(MaterialBlock, reflectionLobe)},
    {Block::Material, "uEnergy", offsetof(MaterialBlock, energy)},
    {Block::Material, "uOcclusion", offsetof(MaterialBlock, occlusion)},
    {Block::Material, "uEmissive", offsetof(MaterialBlock, emissive)},
    {Block::Material, "uEmissiveCubic", offsetof(MaterialBlock, emissiveCubic)},
    {Block::Material, "uNormalScale", offsetof(MaterialBlock, normalScale)},
    {Block::Material, "uAlphaCutoff", offsetof(MaterialBlock, alphaCutoff)},
    {Block::Material, "uUv0Transform", offsetof(MaterialBlock, uv) + offsetof(UvTransforms, uv0)},
    {Block::Material, "uUv1Transform", offsetof(MaterialBlock, uv) + offsetof(UvTransforms, uv1)},
    {Block::Object, "uModelViewProjection", offsetof(ObjectBlock, modelViewProjection)},
    {Block::Object, "uModel", offsetof(ObjectBlock, model)},
    {Block::Object, "uNormalMatrix", offsetof(ObjectBlock, normalMatrix)},
    {Block::Object, "uOverlay", offsetof(ObjectBlock, overlay)},
    {Block::Skin, "uJoints", offsetof(SkinBlock, joints)},
};

// Where the field's value for that uniform is, in bytes, if it is the field's at all.
std::optional<std::size_t> bytesIn(const PackField& field, std::string_view uniform) {
    if (field.stride == 0)
        return field.uniform == uniform ? std::optional(field.bytes) : std::nullopt;
    const std::size_t hash = field.uniform.find('#');
    const std::string_view head = field.uniform.substr(0, hash), tail = field.uniform.substr(hash + 1);
    if (uniform.size() <= head.size() + tail.size() || !uniform.starts_with(head) || !uniform.ends_with(tail))
        return std::nullopt;
    const char* const begin = uniform.data() + head.size();
    const char* const end = uniform.data() + uniform.size() - tail.size();
    std::size_t light = 0;
    const auto [stop, failed] = std::from_chars(begin, end, light);
    if (failed != std::errc() || stop != end || light >= Permutation::kMaxLights)
        return std::nullopt;
    return field.bytes + light * field.stride;
}

} // namespace

int fieldOffset(Block block, std::string_view uniform) {
    for (const auto& fields : std::array{std::span<const PackField>(kFields), ambientFields()})
        for (const PackField& field : fields)
            if (field.block == block)
                if (const auto bytes = bytesIn(field, uniform))
                    return static_cast<int>(*bytes / sizeof(float));
    return -1;
}

int fieldOffset(const Uniform& uniform) {
    constexpr int kFloats = sizeof(Float4) / sizeof(float);
    return uniform.block == Block::User ? kFloats * uniform.value : fieldOffset(uniform.block, uniform.name);
}

} // namespace franken
