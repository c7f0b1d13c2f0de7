// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/permutation.h"

namespace franken {

/// Where and how the vectors between surface, eye and lights are computed: one form of all that has to do
/// with them.
enum class LightForm : std::uint8_t {
    None,          ///< Neither sun nor punctual light shines.
    PixelUnit,     ///< Per pixel, from a unit normal in world space.
    PixelFew,      ///< Per pixel, one or two suns: the normal's length is divided out of each angle instead.
    VertexWorld,   ///< Suns' vectors in world space, interpolated.
    VertexTangent, ///< Suns' vectors in tangent space, interpolated: no normal leaves that space.
};

/// What follows from a permutation: the questions that more than one row of the recipe asks.
struct Needs {
    bool material; ///< A surface, rather than the sky or an overlay.
    bool shaded;   ///< The picture is wanted, not a look into the material.
    bool direct;   ///< Suns or punctual lights shine.
    LightForm lightForm;
    bool ambient;    ///< Ambient light, of any kind.
    bool skyLit;     ///< ... that depends on the normal, as a sky's does.
    bool color;      ///< The base colour's RGB is read.
    bool encoded;    ///< ... and stays in sRGB codes, because decode and encode would cancel.
    bool base;       ///< The base colour's RGB or alpha is read.
    bool reflection; ///< The sky's reflection.
    bool energy;     ///< What is scattered between facets is given back.
    bool skinned;    ///< Joints move the vertices.
    bool normal;     ///< A normal per pixel.
    bool normalMap;  ///< ... from a map.
    bool turned;     ///< The normal is turned on back faces.
    bool toCamera;   ///< The vector to the eye, per pixel.
    bool metallic;   ///< Metalness.
    bool roughness;  ///< Roughness.
    bool textured;   ///< Metalness and roughness per pixel: from textures, or changed by an effect.
    bool occlusion;
    bool emissive;
    bool decode;   ///< Textures are brought to linear light.
    bool encode;   ///< The output is encoded.
    bool uv0, uv1; ///< Streams that a form of the recipe reads: outlines() finds them.
    /// Hooks that an effect fills; the vector to the eye, as it takes it.
    bool vertexHook, baseColorHook, surfaceHook, lightHook, toEye;
};

/// All but the streams.
Needs needsOf(const Permutation& permutation);

} // namespace franken
