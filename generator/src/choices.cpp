// SPDX-License-Identifier: MIT
#include "franken/generator/choices.h"

#include <algorithm>
#include <array>

namespace franken {
namespace {

template<auto Member>
constexpr Choice choice(std::string_view name, bool material, unsigned shift, unsigned bits,
                        std::span<const Option> options) {
    using Value = std::remove_cvref_t<decltype(std::declval<Permutation>().*Member)>;
    return {name,
            material,
            shift,
            bits,
            options,
            [](const Permutation& p) { return static_cast<unsigned>(p.*Member); },
            [](Permutation& p, unsigned value) { p.*Member = static_cast<Value>(value); }};
}

constexpr Option kProgram[] = {
    {"surface", "a model's surface"}, {"sky", "the background"}, {"overlay", "text and pictures on top"}};
constexpr Option kBaseColor[] = {{"basecolor-factor", "base colour: the factor"},
                                 {"basecolor", "base colour: factor times texture"}};
constexpr Option kVertexColor[] = {{"no-vertexcolor", "vertex colours are not used"},
                                   {"vertexcolor", "base colour: times the vertex colour"}};
constexpr Option kMetallicRoughness[] = {{"metalrough-factors", "metalness and roughness by factor"},
                                         {"metalrough", "one texture: G roughness, B metalness"},
                                         {"metalrough-separate", "two textures: R of each"}};
constexpr Option kNormal[] = {{"normal-vertex", "vertex normals"}, {"normal", "a normal map with a scale"}};
constexpr Option kOcclusion[] = {{"no-occlusion", "ambient light is not occluded"},
                                 {"occlusion", "R of a texture of its own"},
                                 {"occlusion-packed", "R of the packed metallic-roughness texture"}};
constexpr Option kEmissive[] = {{"no-emissive", "nothing is emitted"},
                                {"emissive-factor", "emission by factor"},
                                {"emissive", "emission: factor times texture"}};
constexpr Option kAlpha[] = {{"opaque", "alpha is ignored"},
                             {"mask", "nothing is drawn below the cutoff"},
                             {"blend", "alpha is written, for blending"}};
constexpr Option kSides[] = {{"single", "front faces"}, {"double", "both faces; normals face the viewer"}};
constexpr Option kBaseColorUv[] = {{"basecolor-uv0", "base colour reads stream 0"},
                                   {"basecolor-uv1", "base colour reads stream 1"}};
constexpr Option kMetallicRoughnessUv[] = {{"metalrough-uv0", "metalness and roughness read stream 0"},
                                           {"metalrough-uv1", "metalness and roughness read stream 1"}};
constexpr Option kNormalUv[] = {{"normal-uv0", "the normal map reads stream 0"},
                                {"normal-uv1", "the normal map reads stream 1"}};
constexpr Option kOcclusionUv[] = {{"occlusion-uv0", "occlusion reads stream 0"},
                                   {"occlusion-uv1", "occlusion reads stream 1"}};
constexpr Option kEmissiveUv[] = {{"emissive-uv0", "emission reads stream 0"},
                                  {"emissive-uv1", "emission reads stream 1"}};
constexpr Option kUv0Transform[] = {{"uv0-plain", "stream 0 as it is"},
                                    {"uv0-transform", "stream 0 through a KHR_texture_transform matrix"}};
constexpr Option kUv1Transform[] = {{"uv1-plain", "stream 1 as it is"},
                                    {"uv1-transform", "stream 1 through a KHR_texture_transform matrix"}};
constexpr Option kInfluences[] = {{"skin0", "no joint moves a vertex in the vertex shader"},
                                  {"skin1", "one joint moves a vertex"},
                                  {"skin2", "two joints move a vertex"},
                                  {"skin3", "three joints move a vertex"},
                                  {"skin4", "four joints move a vertex"}};
constexpr Option kJoints[] = {{"joints32", "room for 32 joints"},
                              {"joints64", "room for 64 joints"},
                              {"joints256", "room for 256 joints"}};
constexpr Option kShading[] = {{"lit", "lit by ambient light, suns and punctual lights"},
                               {"unlit", "base colour alone (KHR_materials_unlit)"}};
constexpr Option kAmbient[] = {{"no-ambient", "no ambient light"},
                               {"ambient", "one colour from everywhere"},
                               {"sh", "a sky's irradiance, nine SH coefficients"}};
constexpr Option kReflection[] = {
    {"no-reflection", "the sky lights, and is not reflected"},
    {"reflection", "surfaces reflect the sky: prefiltered levels and a lookup"}};
constexpr Option kSuns[] = {{"sun0", "no sun"},
                            {"sun1", "one sun"},
                            {"sun2", "two suns"},
                            {"sun3", "three suns"},
                            {"sun4", "four suns"}};
constexpr Option kPunctualLights[] = {{"punctual0", "no punctual light"},
                                      {"punctual1", "one point or spot light"},
                                      {"punctual2", "two point or spot lights"},
                                      {"punctual3", "three point or spot lights"},
                                      {"punctual4", "four point or spot lights"}};
constexpr Option kSpots[] = {{"points", "point lights: punctual lights shine everywhere"},
                             {"spots", "punctual lights may have cones"}};
constexpr Option kLightVectors[] = {{"pixellight", "light vectors per pixel, exact"},
                                    {"vertexlight", "light vectors per vertex, cheaper"}};
constexpr Option kBrdf[] = {{"gltf", "glTF 2.0, appendix B"},
                            {"seed", "Schlick-GGX, k = (r+1)^2/8"},
                            {"fast", "Hammon 2017"},
                            {"schlick", "Schlick-GGX, k = alpha/2"}};
constexpr Option kEnergy[] = {{"no-energy", "what is scattered between facets is lost"},
                              {"energy", "rough surfaces keep what is scattered between their facets"}};
constexpr Option kDecode[] = {{"decode-srgb", "textures decoded by the exact sRGB curve"},
                              {"decode-fast", "textures decoded by a cubic"},
                              {"decode-none", "textures taken as linear"}};
constexpr Option kToneMap[] = {{"clip", "no tone map"},
                               {"reinhard", "c / (1 + c)"},
                               {"aces", "Narkowicz's fit of ACES"},
                               {"neutral", "Khronos PBR Neutral"}};
constexpr Option kOutput[] = {{"srgb", "encoded by the exact sRGB curve"},
                              {"srgb-fast", "within one code of sRGB from code 10 up"},
                              {"pow22", "encoded by c^(1/2.2)"},
                              {"linear", "not encoded, for an sRGB target"}};
constexpr Option kDither[] = {{"no-dither", "not dithered"}, {"dither", "ordered dither"}};
constexpr Option kView[] = {{"shaded", "the picture"},
                            {"view-basecolor", "the base colour"},
                            {"view-normal", "the normal, 0.5 + 0.5 n"},
                            {"view-metalrough", "G roughness, B metalness"},
                            {"view-occlusion", "the occlusion"}};
constexpr Option kTarget[] = {{"generic", "any GPU"}, {"vc4", "forms that VideoCore IV runs best (Pi 0-3)"}};
constexpr Option kFacing[] = {{"frontfacing", "gl_FrontFacing is trusted"},
                              {"workaround-facing", "back faces are found by N.V"}};

constexpr Option kPrecision[] = {{"fp32", "fragments compute in 32-bit floats"},
                                 {"fp16", "fragments compute in 16-bit floats; roughness from 0.3 up"}};

constexpr bool staysInOneWord(const Choice& choice) {
    return choice.shift / 64 == (choice.shift + choice.bits - 1) / 64;
}

// Order of names. Shifts are part of the schema: append, never renumber. Material choices are in the first 64
// bits.
constexpr std::array kChoices = {
    choice<&Permutation::program>("program", false, 0, 2, kProgram),
    choice<&Permutation::baseColorTexture>("baseColorTexture", true, 2, 1, kBaseColor),
    choice<&Permutation::vertexColor>("vertexColor", true, 3, 1, kVertexColor),
    choice<&Permutation::metallicRoughness>("metallicRoughness", true, 4, 2, kMetallicRoughness),
    choice<&Permutation::normal>("normal", true, 6, 2, kNormal),
    choice<&Permutation::occlusion>("occlusion", true, 8, 2, kOcclusion),
    choice<&Permutation::emissive>("emissive", true, 10, 2, kEmissive),
    choice<&Permutation::alpha>("alpha", true, 12, 3, kAlpha),
    choice<&Permutation::sides>("sides", true, 15, 1, kSides),
    choice<&Permutation::baseColorUv>("baseColorUv", true, 16, 1, kBaseColorUv),
    choice<&Permutation::metallicRoughnessUv>("metallicRoughnessUv", true, 17, 1, kMetallicRoughnessUv),
    choice<&Permutation::normalUv>("normalUv", true, 18, 1, kNormalUv),
    choice<&Permutation::occlusionUv>("occlusionUv", true, 19, 1, kOcclusionUv),
    choice<&Permutation::emissiveUv>("emissiveUv", true, 20, 1, kEmissiveUv),
    choice<&Permutation::uv0Transform>("uv0Transform", true, 21, 1, kUv0Transform),
    choice<&Permutation::uv1Transform>("uv1Transform", true, 22, 1, kUv1Transform),
    choice<&Permutation::influences>("influences", true, 47, 3, kInfluences),
    choice<&Permutation::joints>("joints", true, 56, 2, kJoints),
    choice<&Permutation::shading>("shading", true, 23, 1, kShading),
    choice<&Permutation::ambient>("ambient", false, 64, 3, kAmbient),
    choice<&Permutation::reflection>("reflection", false, 67, 3, kReflection),
    choice<&Permutation::suns>("suns", false, 70, 3, kSuns),
    choice<&Permutation::punctualLights>("punctualLights", false, 73, 3, kPunctualLights),
    choice<&Permutation::spots>("spots", false, 76, 1, kSpots),
    choice<&Permutation::lightVectors>("lightVectors", false, 77, 2, kLightVectors),
    choice<&Permutation::brdf>("brdf", false, 79, 4, kBrdf),
    choice<&Permutation::energy>("energy", false, 110, 1, kEnergy),
    choice<&Permutation::decode>("decode", false, 83, 3, kDecode),
    choice<&Permutation::toneMap>("toneMap", false, 86, 4, kToneMap),
    choice<&Permutation::output>("output", false, 90, 4, kOutput),
    choice<&Permutation::dither>("dither", false, 94, 2, kDither),
    choice<&Permutation::view>("view", false, 24, 4, kView),
    choice<&Permutation::target>("target", false, 96, 3, kTarget),
    choice<&Permutation::facingWorkaround>("facingWorkaround", false, 99, 1, kFacing),
    choice<&Permutation::precision>("precision", false, 113, 1, kPrecision),
};
static_assert(std::all_of(kChoices.begin(), kChoices.end(), staysInOneWord));

// Beside them stand values to come of choices that are there: a second form of the reflection, premultiplied
// blending (alpha), more tone maps, BRDFs and encodings.
constexpr ReservedBits kReserved[] = {
    {"clear coat and its three textures", 28, 4},
    {"clear coat's streams", 32, 3},
    {"specular and its textures", 35, 3},
    {"specular's streams", 38, 2},
    {"sheen or anisotropy, and their textures", 40, 4},
    {"sheen's or anisotropy's streams", 44, 2},
    {"vertices in object space", 46, 1},
    {"spare material bits", 58, 6},
    {"driver workarounds", 100, 4},
    {"shadows of four suns", 104, 4},
    {"shadow filter", 108, 2},
    {"specular occlusion", 111, 1},
    {"roughness from normals", 112, 1},
    {"spare bits", 114, 6},
};

} // namespace

std::span<const Choice> choices() { return kChoices; }
std::span<const ReservedBits> reservedBits() { return kReserved; }

} // namespace franken
