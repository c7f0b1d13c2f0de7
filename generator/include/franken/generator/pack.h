// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/ambient.h"
#include "franken/generator/effect.h"
#include "franken/generator/interface.h"
#include "franken/generator/light.h"
#include "franken/generator/permutation.h"

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string_view>

namespace FRANKEN_API franken {

// What uniforms alone decide is computed here, once, instead of in every fragment. The runtime, a foreign
// engine and a web page call the same functions and so feed a program the same numbers. All blocks are
// plain floats; fieldOffset() says where a uniform's value lies in its block.

/// Roughness is kept above this, or the lobe would be 0/0 at 0: alpha^2 = 1e-12. A sun's highlight on a
/// smoother surface has no size, and is not seen, as in glTF's own formulas.
inline constexpr float kMinRoughness = 0.001f;

/// For fragments that compute in 16-bit floats: glTF's shadowing would overflow on a smoother surface, whose
/// 4 / alpha^4 is 65,504 and more.
inline constexpr float kMinRoughnessFp16 = 0.3f;

/// The largest number that such a fragment is handed.
inline constexpr float kMostFp16 = 60'000;

/// The longest vector that such a fragment is handed: its square, times what is white in any light, is below
/// 65,504.
inline constexpr float kMaxLengthFp16 = 60;

/// The levels of a ReflectionAtlas, prefiltered for rising roughness. Level i holds the roughness 2^((i - 8)
/// / 2): 0.0625, 0.088 ... 0.707, 1; smoother surfaces show the first.
inline constexpr int kReflectionLevels = 9;

/// What a dielectric scatters of the light that comes in; it reflects the rest where it faces the eye.
inline constexpr float kDielectricScatters = 0.96f;

/// How far the direction in which a rough surface reflects the sky is bent towards N: the direction is
/// (2 N.V + bend (1 - N.V)) N - V. A dielectric's is bent less than a metal's: at an angle it shows mostly
/// what Fresnel's term adds, which is light off facets that face away from the eye. Fitted to brute force
/// (generator/docs/sky.md). roughness, metallic: 0-1.
float reflectionBend(float roughness, float metallic);

/// What a rough surface scatters between its facets: 1 / E - 1, where E is the share of a white sky's light
/// that leaves after one reflection by GGX with height-correlated Smith shadowing. A metal of that colour
/// reflects F0 E + (1 - F0) B of the sky, and 1 + F0 (1 / E - 1) times as much with Permutation::energy
/// (Turquin, "Practical multiple scattering compensation for microfacet models", 2019). The fit that programs
/// compute from MaterialBlock::energy: within 0.8 % of 1 / E for roughness from 0.1 and N.V from 0.02 up
/// (generator/docs/energy.md). nDotV: 1e-4 to 1; roughness: 0-1.
float energyCompensation(float nDotV, float roughness);

/// A glTF material's numbers, as they stand in the file; colours linear. kMaterialFactors has their ranges.
struct MaterialFactors {
    Float4 baseColor{1, 1, 1, 1}; ///< Linear; the alpha last. Multiplies texture and vertex colour.
    float metallic = 1;           ///< 0 (a dielectric) to 1.
    float roughness = 1;          ///< Perceptual: 0 (a mirror) to 1.
    float normalScale = 1;        ///< Of X and Y in the normal map.
    float occlusionStrength = 1;  ///< How much of the occlusion map counts, 0-1.
    Float3 emissive{0, 0, 0};     ///< Factor times KHR_materials_emissive_strength; radiance
    float alphaCutoff = 0.5f;     ///< Alpha::Mask: what is less is not drawn.
};

/// What a factor may be: finite, and from `least` to `most`.
struct FactorRange {
    /// Both are allowed.
    float least, most;
    std::string_view rule; ///< The same in words
};
/// For shares: metallic, roughness, occlusion.
inline constexpr FactorRange kUnitFactor{0, 1, "it must be 0 to 1"};
/// For what has no upper end: emission.
inline constexpr FactorRange kAmountFactor{0, std::numeric_limits<float>::max(),
                                           "it must be finite, and 0 or more"};
/// For what has no end: the scale of a normal map.
inline constexpr FactorRange kAnyFactor{std::numeric_limits<float>::lowest(),
                                        std::numeric_limits<float>::max(), "it must be finite"};

/// All that is known of a factor but its default, which is its member's.
struct FactorRow {
    std::string_view name;   ///< Its member's
    std::size_t bytes, size; ///< Where its floats are in the struct, and how long they are together
    FactorRange range;       ///< In a scene
    FactorRange inFile;      ///< What a glTF file may say; what is beyond it is clamped
    std::string_view gltf;   ///< Where a material of a glTF file has it, a JSON pointer

    /// The factor in a material: as many floats as it has.
    std::span<float> of(MaterialFactors& factors) const {
        return {reinterpret_cast<float*>(&factors) + bytes / sizeof(float), size / sizeof(float)};
    }
    /// The factor in a material: as many floats as it has.
    std::span<const float> of(const MaterialFactors& factors) const {
        return {reinterpret_cast<const float*>(&factors) + bytes / sizeof(float), size / sizeof(float)};
    }
};

/// All factors.
inline constexpr FactorRow kMaterialFactors[] = {
    {"baseColor", offsetof(MaterialFactors, baseColor), sizeof(Float4), kAnyFactor, kUnitFactor,
     "/pbrMetallicRoughness/baseColorFactor"},
    {"metallic", offsetof(MaterialFactors, metallic), sizeof(float), kUnitFactor, kUnitFactor,
     "/pbrMetallicRoughness/metallicFactor"},
    {"roughness", offsetof(MaterialFactors, roughness), sizeof(float), kUnitFactor, kUnitFactor,
     "/pbrMetallicRoughness/roughnessFactor"},
    {"normalScale", offsetof(MaterialFactors, normalScale), sizeof(float), kAnyFactor, kAnyFactor,
     "/normalTexture/scale"},
    {"occlusionStrength", offsetof(MaterialFactors, occlusionStrength), sizeof(float), kUnitFactor,
     kUnitFactor, "/occlusionTexture/strength"},
    {"emissive", offsetof(MaterialFactors, emissive), sizeof(Float3), kAmountFactor, kUnitFactor,
     "/emissiveFactor"},
    {"alphaCutoff", offsetof(MaterialFactors, alphaCutoff), sizeof(float), kAmountFactor, kAmountFactor,
     "/alphaCutoff"},
};

/// KHR_texture_transform of the two streams of texture coordinates.
struct UvTransforms {
    /// Column by column, as uniforms have them; at first they change nothing.
    Float9 uv0{1, 0, 0, 0, 1, 0, 0, 0, 1}, uv1{1, 0, 0, 0, 1, 0, 0, 0, 1};
};

/// The uniforms of Block::Material.
struct MaterialBlock {
    Float4 baseColor;                       ///< The factor, linear.
    std::array<Float3, 3> baseColorCubic;   ///< The fast decode's coefficients times the factor
    std::array<Float3, 2> baseColorEncoded; ///< On sRGB codes: k = factor^(1/2.4), and 0.055 (k - 1)
    Float2 metallicRoughness;               ///< The factors, for textured materials.
    Float4 reflectance; ///< Scattered, m, 0.04 (1 - m), what of `scattered` goes with the base (seed) or 1 -
                        ///< 0.04 (1 - m)
    Float3 lobe;        ///< 1 - alpha^2, and the two coefficients of the BRDF's shadowing
    Float3 reflectionLobe;               ///< Roughness; reflectionBend(), and 2 less that
    Float4 energy;                       ///< What of energyCompensation() follows from the roughness
    Float2 occlusion;                    ///< strength, 1 - strength
    Float3 emissive;                     ///< The factor, times the exposure.
    std::array<Float3, 3> emissiveCubic; ///< As baseColorCubic
    float normalScale;                   ///< MaterialFactors::normalScale.
    float alphaCutoff;                   ///< MaterialFactors::alphaCutoff.
    UvTransforms uv;                     ///< Those of packMaterial() change nothing
};

/// Folds a material for programs with that BRDF. Exposure multiplies what the surface emits.
MaterialBlock packMaterial(const MaterialFactors& factors, Brdf brdf, float exposure);

/// The same for programs of a precision: in 16-bit floats the roughness has its floor, and light its limit.
MaterialBlock packMaterial(const MaterialFactors& factors, Brdf brdf, float exposure, Precision precision);

/// The uniforms of Block::Lights.
struct LightsBlock {
    AmbientBlock ambient;                                         ///< See packAmbient()
    std::array<Float3, Permutation::kMaxLights> sunDirection;     ///< Towards the sun, unit
    std::array<Float3, Permutation::kMaxLights> sunRadiance;      ///< Irradiance / pi
    std::array<Float4, Permutation::kMaxLights> punctualPosition; ///< From the eye, m; 1 / range^2
    std::array<Float3, Permutation::kMaxLights> punctualRadiance; ///< Intensity / pi
    std::array<Float3, Permutation::kMaxLights> punctualAxis;     ///< Unit
    std::array<Float2, Permutation::kMaxLights> punctualCone;     ///< Scale, offset
    /// For 16-bit floats alone, see fitToFp16(): what the vector to the light is scaled with, and 1 / range^2
    /// over the square of it.
    std::array<float, Permutation::kMaxLights> punctualScale{}, punctualWindow{};
};

/// Each writes one light's share of the block. Exposure multiplies all light, so that it costs nothing per
/// pixel. index: 0 to kMaxLights - 1.
void packSun(LightsBlock& block, std::size_t index, const Sun& sun, float exposure);
void packPunctualLight(LightsBlock& block, std::size_t index, const PunctualLight& light,
                       const Double3& cameraPosition, float exposure);

/// Brings a packed block within 16-bit floats, for programs of Precision::Fp16. farthest: of what is lit,
/// from the eye, m. No light becomes dimmer that does not make every surface white.
void fitToFp16(LightsBlock& block, float farthest);

/// The uniforms of Block::Frame.
struct FrameBlock {
    Float3 cameraPosition; ///< In the space that ObjectBlock::model leads to, m
    Float9 clipToSky;      ///< (x, y, 1) in clip space to a direction in the sky
    float skyRange;        ///< The largest radiance that a sky texel can hold, times the exposure
    float reflectionScale; ///< Root of the range, times the exposure, of the sky as rough mirrors show it
    Float3 dither;         ///< Amplitude per channel, in output units
    float lengthScale = 1; ///< Of vectors to the eye in 16-bit floats: see lengthScaleFp16()
    float lengthUnit = 1;  ///< 1 / lengthScale
};

/// FrameBlock::lengthScale for a farthest surface at that distance from the eye, m; at most 1.
float lengthScaleFp16(float farthest);

/// The dither amplitude of a target with that many bits in each channel (1-16): one step of its codes.
Float3 packDither(const std::array<int, 3>& bits);

/// The uniforms of Block::Object.
struct ObjectBlock {
    Float16 modelViewProjection; ///< Column by column, from the mesh to clip space.
    Float16 model;       ///< To the world, or to the world as seen from the eye: the camera is at 0 then
    Float9 normalMatrix; ///< Inverse transpose of the model's upper 3x3; any scale
    Float9 overlay;      ///< Overlays alone: (x, y, 1) in their units to clip space
};

/// The most joints of a program's palette (Joints).
inline constexpr std::size_t kMaxJoints = 256;

/// The palette of a skin: for each joint the rows of its matrix, from where the mesh was bound to the space
/// that ObjectBlock::model starts from. aJoints says where a joint's rows begin.
struct SkinBlock {
    std::array<Float4, 3 * kMaxJoints> joints; ///< Three rows each.
};

/// How many joints a program's palette has room for.
std::size_t roomFor(Joints joints);

/// The values of an effect, in the order in which its text declares them; they mean what it says.
struct EffectBlock {
    std::array<Float4, kEffectValues> values; ///< As the text declares them.
};

/// Where a uniform's value starts in its block, in floats; -1 where the block has no such uniform. Tests
/// hold that every uniform of every program has one.
int fieldOffset(Block block, std::string_view uniform);

/// The same, of an effect's uniform in the EffectBlock as well.
int fieldOffset(const Uniform& uniform);

} // namespace franken
