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

/// A resource of which a GPU has a limited number.
enum class Resource : std::uint8_t {
    Attributes,       ///< Vectors of vertex attributes, never packed; a matrix takes one per column.
    Varyings,         ///< Vectors of four floats, packed.
    VertexUniforms,   ///< Vectors of four floats, packed, that the vertex shader declares.
    FragmentUniforms, ///< The same of the fragment shader. Samplers do not count.
    Samplers,         ///< Texture units of the fragment shader: no program samples in its vertex shader.
    Lights,           ///< Suns and punctual lights; a compiler that cannot spill has registers for some only.
};

inline constexpr std::size_t kResourceCount = 6; ///< Values of Resource.

/// "varyings": one word, for tables and JSON.
std::string_view toText(Resource resource);

/// The limits of one kind of GPU, as its GLES2 driver states them.
struct Profile {
    std::string_view name;    ///< "vc4": what findProfile() takes.
    std::string_view meaning; ///< The machines that it represents, and the source of the figures.
    /// By Resource. The limit of lights is a lower bound: where a compiler cannot spill, a program that holds
    /// little else has registers for more lights.
    std::array<int, kResourceCount> limits;
};

/// vc4, v3d, mali-400, es2-minimum (what every GLES2 implementation has at least) and software (Mesa's
/// rasterisers).
std::span<const Profile> profiles();

/// Fails with "budget.unknown-profile"; the remedy lists the names.
Result<Profile> findProfile(std::string_view name);

/// A program's use of one resource.
struct Use {
    Resource resource;
    /// What the program takes, and what the GPU has.
    int used, limit;
    /// More than the GPU has.
    bool exceeded() const { return used > limit; }
};

/// What a program uses of each resource of a GPU.
struct Budget {
    std::array<Use, kResourceCount> uses; ///< By Resource.
    /// The program's texture roles (texture_role.h) whose fixed unit the GPU lacks, however few textures the
    /// program has.
    std::vector<std::string_view> rolesBeyond;

    /// The program's use of that resource.
    const Use& operator[](Resource resource) const { return uses[static_cast<std::size_t>(resource)]; }
    bool fits() const; ///< No limit is exceeded, and each role has its unit.
};

/// The resources that a program uses on a GPU. Varyings and uniforms are packed by the method of the OpenGL
/// ES Shading Language 1.00 specification, appendix A.7, which is the minimum that every implementation must
/// achieve: `used` is the smallest number of vectors with which the method succeeds. A driver may pack
/// better, so a program that exceeds its budget by a vector may still link; a program that fits must link.
///
/// Some things are in no interface and are not counted: gl_FragCoord and gl_FrontFacing, which the GPUs of
/// these profiles deliver outside their varyings, and the constants that a compiler puts beside the uniforms.
/// The budget does not count registers either: only the driver's compiler knows whether they suffice.
Budget budget(const Interface& interface, const Profile& profile);

/// A choice that costs some of a resource.
struct Feature {
    std::string word; ///< Its word in the permutation's name.
    int used;         ///< The program's use without it.
};

/// The choices of a canonical permutation, its effect included, that can be given up where its program
/// exceeds a resource: every choice that takes some of the resource by itself, the largest saving first. A
/// choice whose `used` is within the profile's limit suffices alone. The function sets one choice at a time
/// to its default, canonicalises and composes again; a choice that another one needs (the packed texture
/// under a packed occlusion) is therefore not in the list.
std::vector<Feature> costlyFeatures(const Permutation& permutation, Resource resource,
                                    const SnippetSet& snippets = SnippetSet::builtIn());

} // namespace franken
