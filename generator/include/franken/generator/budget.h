// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/interface.h"
#include "franken/generator/permutation.h"
#include "franken/result.h"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace FRANKEN_API franken {

/// What a GPU has a limited number of, and a program takes some of.
enum class Resource : std::uint8_t {
    Attributes,       ///< Vectors of vertex attributes; a matrix takes one a column. They are never packed.
    Varyings,         ///< Vectors of four floats, packed.
    VertexUniforms,   ///< Vectors of four floats, packed; those that the vertex shader declares.
    FragmentUniforms, ///< Likewise for the fragment shader. Samplers are no part of them.
    Samplers,         ///< Texture units of the fragment shader: no program samples in its vertex shader.
    Lights,           ///< Suns and punctual lights: what a compiler without spilling has registers for.
};

inline constexpr std::size_t kResourceCount = 6;

/// "varyings": one word, for tables and JSON.
std::string_view toText(Resource resource);

/// What one kind of GPU offers, as its GLES2 driver states it.
struct Profile {
    std::string_view name;
    std::string_view meaning; ///< Which machines it stands for, and who stated the figures.
    /// By Resource. Of lights at least so many: where a compiler cannot spill, a program that holds little
    /// else has registers for more of them.
    std::array<int, kResourceCount> limits;
};

/// vc4, v3d, mali-400, es2-minimum (what every GLES2 implementation has at least) and software (Mesa's
/// rasterisers).
std::span<const Profile> profiles();

/// Fails with "budget.unknown-profile"; the remedy lists the names.
Result<Profile> findProfile(std::string_view name);

/// How much of one resource a program takes.
struct Use {
    Resource resource;
    int used, limit;
    bool bursts() const { return used > limit; }
};

struct Budget {
    std::array<Use, kResourceCount> uses; ///< By Resource.
    /// The texture roles (texture_role.h) that have a unit which the GPU lacks, however few the program has.
    std::vector<std::string_view> rolesBeyond;

    const Use& operator[](Resource resource) const { return uses[static_cast<std::size_t>(resource)]; }
    bool fits() const; ///< Nothing bursts, and each role has its unit.
};

/// What a program takes of a GPU. Varyings and uniforms are packed by the method of the OpenGL ES Shading
/// Language 1.00 specification, appendix A.7, which every implementation must do as well as: `used` is the
/// smallest number of vectors that the method succeeds with. A driver may pack better, so a program that
/// bursts its budget by a vector may still link; one that fits must.
///
/// Not counted is what no interface lists: gl_FragCoord and gl_FrontFacing, which the GPUs of these profiles
/// deliver outside their varyings, and the constants that a compiler puts beside the uniforms. Whether a
/// program finds enough registers is not a question of budget either: only the driver's compiler knows.
Budget budget(const Interface& interface, const Profile& profile);

/// A choice that costs some of a resource.
struct Feature {
    std::string word; ///< As it stands in the permutation's name.
    int used;         ///< What the program would take without it.
};

/// Which choices of a canonical permutation to give up where its program bursts a resource: each one that
/// takes some of it by itself, the most relieving first; those whose `used` is within the profile's limit
/// are enough alone. Found by putting each choice to its default, canonicalising and composing anew: a choice
/// that another one needs (the packed texture under a packed occlusion) is therefore not among them.
std::vector<Feature> costlyFeatures(const Permutation& permutation, Resource resource);

} // namespace franken
