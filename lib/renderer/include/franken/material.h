// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/pack.h"
#include "franken/generator/texture_role.h"
#include "franken/light.h"
#include "franken/log.h"
#include "franken/result.h"
#include "franken/scene.h"

#include <array>
#include <cstdint>
#include <optional>

namespace FRANKEN_API franken {

/// Choices for a whole picture, whatever its materials.
struct Look {
    Brdf brdf = Brdf::Gltf;
    /// Rough surfaces keep what is scattered between their facets (Permutation::energy). Not with Brdf::Seed,
    /// which draw() refuses beside it.
    bool energy = false;
    LightVectors lightVectors = LightVectors::PerPixel; ///< Per vertex: where a mesh is fine enough for it.
    Decode decode = Decode::Exact;
    ToneMap toneMap = ToneMap::None;
    Output output = Output::Srgb;
    /// The target encodes the colours that are written to it (platform::Surface::srgbTarget()): programs then
    /// write linear light, whatever `output` says. Such a target encodes the views of a material's numbers as
    /// well.
    bool srgbTarget = false;
    Dither dither = Dither::None;
    View view = View::Shaded;
    Target target = Target::Generic;
    bool facingWorkaround = false; ///< For drivers whose gl_FrontFacing lies (Capabilities).
    /// In the programs of all surfaces that it changes: SnippetSet::chooseEffect() of the renderer's
    /// snippets.
    EffectChoice effect = {};
    /// A renderer sets it to Capabilities::precision of its context.
    Precision precision = Precision::Fp32;
    /// The largest palette of joints; none: the CPU moves vertices. A renderer sets it to
    /// Capabilities::joints of its context.
    std::optional<Joints> joints = Joints::UpTo256;
    /// How many times longer than wide the part of a texture may be that a pixel takes its mean of: surfaces
    /// that are seen at a slant are sharper then, and a pixel there reads as many times more texels. From 1
    /// to Capabilities::maxAnisotropy, to which it is limited. For textures of models with mips, from the
    /// next draw() on.
    float anisotropy = 1;
};

/// The optional attributes of a primitive, and other properties of its vertices that choose programs.
struct VertexContents {
    bool tangents = false;    ///< TANGENT
    std::array<bool, 2> uv{}; ///< TEXCOORD_0, TEXCOORD_1
    bool colors = false;      ///< COLOR_0
    bool fine = false;        ///< Normals turn by no more than kFineNormalTurn (tessellation.h).
    /// Joints that move a vertex, at most; 0 where none do, or a program cannot do it: see
    /// isForVertexShader().
    std::uint8_t influences = 0;
    Joints joints = Joints::UpTo32; ///< Room for all of its joints, or the most there is.
    friend bool operator==(const VertexContents&, const VertexContents&) = default;
};

/// Whether a vertex shader can move the vertices to where their joints are: it has at most
/// Permutation::kMaxInfluences of them for each, and normals that are not those of moved triangles.
bool isForVertexShader(const Primitive& primitive);

VertexContents contentsOf(const Primitive& primitive); ///< What a primitive of a scene has.

/// A material as programs see it, on vertices with certain contents.
struct MaterialPlan {
    Permutation permutation; ///< The material's choices alone; see permutationOf().
    MaterialFactors factors; ///< Numbers and colours.
    UvTransforms uvTransforms;
    std::array<int, kUsedTextureUnits> textures; ///< Scene texture of each sampler unit, or kNone.
    std::array<int, 2> uvSets{};                 ///< Which TEXCOORD_n feeds each of the two streams.
    bool fine = false;                           ///< Light vectors may be per vertex.
};

/// Distributes a material's textures over the two UV streams of a program. A stream is one TEXCOORD set with
/// one KHR_texture_transform; textures that share both share a stream. Some textures are left out, each with
/// a warning that names the material: a texture whose TEXCOORD set the vertices lack, a texture that would
/// need a third stream, and a normal map on vertices without tangents.
MaterialPlan planMaterial(const Scene& scene, int material, const VertexContents& contents,
                          const Log& log = {});

/// The factors of a material that differs in them alone from the one that was planned, and glows as it did or
/// did not. Allocates nothing.
void replaceFactors(MaterialPlan& plan, const Material& material);

/// The program that draws such a material in that light, canonical. Fails where canonicalise() does.
Result<Permutation> permutationOf(const MaterialPlan& plan, const Lighting& lighting, const Look& look);

/// The program that draws a sky behind all, canonical.
Result<Permutation> skyPermutation(const Look& look);

} // namespace franken
