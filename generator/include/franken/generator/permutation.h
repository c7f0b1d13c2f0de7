// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/ambient.h"
#include "franken/generator/snippet_set.h"
#include "franken/result.h"

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace FRANKEN_API franken {

/// What a program draws.
enum class Program : std::uint8_t {
    Surface, ///< A model's surface.
    Sky,     ///< The background: the sky's cube map, behind everything.
    Overlay, ///< Text and pictures on top, in the display's own encoding: neither decoded nor lit.
};

/// Where metalness and roughness come from.
enum class MetallicRoughness : std::uint8_t {
    Factors,  ///< From uniforms alone.
    Packed,   ///< glTF's texture: G is roughness, B is metalness; times the factors.
    Separate, ///< Two textures, R of each; times the factors.
};

/// Where a surface's normal comes from.
enum class Normal : std::uint8_t {
    Vertex, ///< The interpolated vertex normal.
    Map,    ///< A tangent-space normal map with a scale; needs tangents.
};

/// What dims the ambient light. It never dims suns and punctual lights (glTF 2.0, 3.9.3).
enum class Occlusion : std::uint8_t {
    None,
    Texture, ///< R of a texture of its own.
    Packed,  ///< R of the packed metallic-roughness texture: no second fetch.
};

/// What a surface emits: nothing, a colour, or a texture times a colour.
enum class Emissive : std::uint8_t { None, Factor, Texture };

/// What the alpha of the base colour does.
enum class Alpha : std::uint8_t {
    Opaque, ///< Alpha is ignored and written as 1.
    Mask,   ///< Below the cutoff nothing is drawn; the rest is opaque.
    Blend,  ///< Written as it is (not premultiplied), for source-over blending.
};

/// Which sides of a triangle are seen.
enum class Sides : std::uint8_t {
    Single,
    Double, ///< The normal is turned towards the viewer on back faces.
};

/// The two streams of texture coordinates.
enum class UvStream : std::uint8_t { Uv0, Uv1 };

/// Whether light shades a surface.
enum class Shading : std::uint8_t {
    Lit,
    Unlit, ///< KHR_materials_unlit: base colour alone; not tone-mapped, still encoded.
};

/// The reflectance model of suns and punctual lights; all use the GGX distribution and Schlick's Fresnel
/// term.
enum class Brdf : std::uint8_t {
    Gltf,    ///< glTF 2.0, appendix B: height-correlated Smith visibility.
    Seed,    ///< Schlick-GGX with k = (roughness + 1)^2 / 8, denominator kept above 0.001.
    Fast,    ///< Hammon 2017: visibility 0.5 / mix(2 nL nV, nL + nV, alpha).
    Schlick, ///< Schlick-GGX with k = alpha / 2.
};

/// The reflection of the sky, besides its irradiance: by the specular lobe of glTF's BRDF, even where suns
/// and punctual lights have another BRDF. Needs Ambient::Sky.
enum class Reflection : std::uint8_t {
    None,   ///< No reflection: metals are black but for suns and punctual lights.
    Lookup, ///< Prefiltered levels in one texture, and how much is reflected in another.
};

/// How many joints' matrices the vertex shader's palette has room for: what the GPU's uniforms hold, and what
/// is uploaded for each draw.
enum class Joints : std::uint8_t {
    UpTo32,  ///< 96 vectors: within the least that OpenGL ES 2.0 allows.
    UpTo64,  ///< 192 vectors.
    UpTo256, ///< 768 vectors.
};

/// Where the vectors between surface, eye and suns are computed. Punctual lights are always per pixel.
enum class LightVectors : std::uint8_t {
    PerPixel,  ///< Exact.
    PerVertex, ///< Half vectors and Fresnel interpolated: cheaper, for finely tessellated meshes.
};

/// How base colour and emissive textures are brought to linear light.
enum class Decode : std::uint8_t {
    Exact, ///< The piecewise sRGB curve (IEC 61966-2-1).
    Fast,  ///< A cubic through 0 and 1.
    None,  ///< Texels are taken as linear, as the seed's program takes them.
};

/// How the sum of all light is brought into 0-1, before it is encoded.
enum class ToneMap : std::uint8_t {
    None,     ///< Clipped at 1.
    Reinhard, ///< c / (1 + c).
    Aces,     ///< Narkowicz's fit of the ACES reference curve.
    Neutral,  ///< Khronos PBR Neutral.
};

/// What the framebuffer receives.
enum class Output : std::uint8_t {
    Srgb,     ///< The piecewise sRGB curve.
    SrgbFast, ///< Within one code of it from code 10 up.
    Pow22,    ///< c^(1/2.2).
    Linear,   ///< Not encoded: for a target that encodes by itself.
};

/// Whether rounding to the target's codes is spread over neighbours.
enum class Dither : std::uint8_t {
    None,
    Ordered, ///< A 4x4 Bayer pattern with an amplitude per channel: for 8-bit, 18-bit and 565 panels.
};

/// What is shown of a material, to look into it. All but Shaded and BaseColor show numbers unencoded.
enum class View : std::uint8_t { Shaded, BaseColor, Normal, RoughnessMetallic, Occlusion };

/// Which of several equal forms of a snippet is used.
enum class Target : std::uint8_t { Generic, Vc4 };

/// What a GPU computes fragments in (franken::Capabilities measures it; GL's own answers are wrong).
enum class Precision : std::uint8_t {
    Fp32, ///< 32-bit floats, or nearly.
    Fp16, ///< 16-bit floats: roughness from 0.3 up, and lengths scaled by the vertex shader.
};

/// An effect of the application's (effect.h), by its slot in the registry of a SnippetSet, with what of it
/// shapes a program. Effect::choice() and SnippetSet::chooseEffect() make it; default-constructed it is none.
struct EffectChoice {
    static constexpr std::uint8_t kMaxSlot = 63; ///< Effects that one SnippetSet can have.

    std::uint8_t slot = 0;    ///< From 1; 0 is no effect.
    std::uint16_t traits = 0; ///< Bits of EffectTrait: its hooks, and what they read.

    friend bool operator==(const EffectChoice&, const EffectChoice&) = default;
};

/// Every choice that changes the text of a program, and nothing else. A default-constructed one is an
/// opaque, untextured, unlit-by-anything surface; each member's first value is its default.
struct Permutation {
    static constexpr std::uint8_t kMaxLights = 4;     ///< Suns, and punctual lights, in one program.
    static constexpr std::uint8_t kMaxInfluences = 4; ///< As many as one attribute holds.

    Program program = Program::Surface;

    bool baseColorTexture = false; ///< A texture multiplies the base colour.
    bool vertexColor = false;      ///< COLOR_0 of the mesh multiplies the base colour.
    MetallicRoughness metallicRoughness = MetallicRoughness::Factors;
    Normal normal = Normal::Vertex;
    Occlusion occlusion = Occlusion::None;
    Emissive emissive = Emissive::None;
    Alpha alpha = Alpha::Opaque;
    Sides sides = Sides::Single;

    /// Which stream of texture coordinates each texture is read with.
    UvStream baseColorUv = UvStream::Uv0;
    UvStream metallicRoughnessUv = UvStream::Uv0;
    UvStream normalUv = UvStream::Uv0;
    UvStream occlusionUv = UvStream::Uv0;
    UvStream emissiveUv = UvStream::Uv0;
    bool uv0Transform = false; ///< Stream 0 passes through a KHR_texture_transform matrix.
    bool uv1Transform = false; ///< The same for stream 1.

    std::uint8_t influences = 0;    ///< Joints that move a vertex in the vertex shader, 0 to kMaxInfluences.
    Joints joints = Joints::UpTo32; ///< The palette, where there are influences.

    Shading shading = Shading::Lit;
    Brdf brdf = Brdf::Gltf;
    /// What a rough surface scatters between its facets is given back, for lights and the sky's reflection:
    /// all of a white metal's light. Each colour's specular light is multiplied by 1 + F0 (1 / E - 1), with
    /// the share E that leaves after one reflection (Turquin, "Practical multiple scattering compensation for
    /// microfacet models", 2019). Brdf::Seed has no such form.
    bool energy = false;
    Ambient ambient = Ambient::None;
    Reflection reflection = Reflection::None;
    std::uint8_t suns = 0;           ///< Directional lights, 0 to kMaxLights.
    std::uint8_t punctualLights = 0; ///< Punctual lights with a position, 0 to kMaxLights.
    bool spots = false;              ///< Punctual lights have cones; a point light's is the whole sphere.
    LightVectors lightVectors = LightVectors::PerPixel;

    Decode decode = Decode::Exact;
    ToneMap toneMap = ToneMap::None;
    Output output = Output::Srgb;
    Dither dither = Dither::None;
    View view = View::Shaded;

    Target target = Target::Generic;
    bool facingWorkaround = false; ///< Back faces are found by N.V: for drivers whose gl_FrontFacing lies.
    Precision precision = Precision::Fp32;

    EffectChoice effect{}; ///< The application's own; none at first.

    friend bool operator==(const Permutation&, const Permutation&) = default;
};

/// The permutation packed into 128 bits, schema version included. For a canonical permutation: equal text,
/// equal key. A default-constructed one is no permutation's.
struct Key {
    std::array<std::uint64_t, 2> words{}; ///< Bits 0 to 63, which are the material's, and 64 to 127.

    friend bool operator==(const Key&, const Key&) = default;
    /// Not defaulted: the arrays of clang 14's library have no <=>.
    friend std::strong_ordering operator<=>(const Key& a, const Key& b) {
        const std::strong_ordering first = a.words[0] <=> b.words[0];
        return first != 0 ? first : a.words[1] <=> b.words[1];
    }
};

/// Spreads keys over the upper bits: multilinear hashing (Lemire and Kaser, "Strongly universal string
/// hashing is fast", 2014). Only says where to look; whoever looks compares whole keys.
constexpr std::uint64_t hashOf(const Key& key) {
    return key.words[0] * 0x9E3779B97F4A7C15u + key.words[1] * 0xC2B2AE3D27D4EB4Fu;
}

/// "0x02000000000000000000000000000004": the upper word first.
std::string toHex(const Key& key);

/// Reads what toHex() writes; leading zeros may be missing. Fails with "permutation.key".
Result<Key> parseHex(std::string_view hex);

/// Changes whenever the meaning of a key's bits does; 0 is never used.
inline constexpr unsigned kSchemaVersion = 2;

/// Packs; any values of the members are allowed as long as they are in range (asserted).
Key toKey(const Permutation& permutation);

/// The same for permutations from outside. Fails with "permutation.range" for a value that no choice has.
Result<Key> checkedKey(const Permutation& permutation);

/// Unpacks. Fails with "permutation.schema" for another schema version, with "permutation.key" where a bit
/// pattern means nothing or a reserved bit is set, and with "effect.missing" where the set has no effect in
/// the slot that the key has.
Result<Permutation> fromKey(const Key& key, const SnippetSet& snippets = SnippetSet::builtIn());

/// A shader of a program.
enum class Stage : std::uint8_t { Vertex, Fragment };

/// Tells one stage's text from another's: canonical permutations with equal stage keys have equal texts
/// there, and share that shader. No permutation's key: fromKey() does not read it.
Key stageKey(const Permutation& permutation, Stage stage);

/// The name: words for all choices that are not the default, material words joined by '.', the rest by
/// '+', in the order of choices.h: "basecolor.normal+ambient+sun2". The default permutation is "surface". An
/// effect stands at the end, with a hash of its text: "basecolor+sun1+fog@afb248b9". A set that has not got
/// it writes its slot, "effect#3", which no name has.
std::string toName(const Permutation& permutation, const SnippetSet& snippets = SnippetSet::builtIn());

/// Reads a name; words may stand in any order and be separated by '.' or '+', defaults may be spelled
/// out. Fails with "permutation.unknown-word" (the nearest word is offered) or "permutation.twice" where
/// two words answer the same choice. An effect's name may stand without its hash. Fails with "effect.missing"
/// and "effect.changed" for an effect that the set has not got, or has with another text.
Result<Permutation> parseName(std::string_view name, const SnippetSet& snippets = SnippetSet::builtIn());

/// A choice that canonicalising put back to its default, because it changes nothing here.
struct Dropped {
    std::string word;   ///< As it stood in the name.
    std::string reason; ///< One sentence.
    friend bool operator==(const Dropped&, const Dropped&) = default;
};

/// What canonicalise() returns.
struct Canonical {
    Permutation permutation;
    std::vector<Dropped> dropped; ///< Choices that changed nothing, in the order of choices.h.
};

/// Refuses contradictions ("permutation.contradiction") and values that no choice has ("permutation.range"),
/// and drops no-ops. Idempotent. It never looks at a machine: whether a GPU can hold the program is
/// budget.h's question.
Result<Canonical> canonicalise(const Permutation& permutation);

} // namespace franken

template<>
/// For std::unordered_map.
struct std::hash<franken::Key> {
    /// hashOf(), folded to the size of a std::size_t.
    std::size_t operator()(const franken::Key& key) const noexcept {
        const std::uint64_t mixed = franken::hashOf(key);
        return static_cast<std::size_t>(mixed ^ mixed >> 32); // Tables of a power of two take the lower bits.
    }
};
