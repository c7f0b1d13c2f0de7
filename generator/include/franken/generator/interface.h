// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace FRANKEN_API franken {

/// GLSL ES types that a program's interface uses.
enum class Type : std::uint8_t { Float, Vec2, Vec3, Vec4, Mat3, Mat4, Sampler2D, SamplerCube };

/// "vec3"
std::string_view toGlsl(Type type);

/// The number of floats in a value of that type: 9 for a mat3, 0 for samplers.
int componentCount(Type type);

/// How often a uniform changes, and therefore when it is uploaded.
enum class Block : std::uint8_t {
    Frame,    ///< With the camera and the target.
    Lights,   ///< With suns, punctual lights, ambient light or exposure.
    Material, ///< With the material.
    Object,   ///< With every object drawn.
    Skin,     ///< With the pose of every skinned object, or part of one.
    User,     ///< When the application says so: the values of its effect (effect.h).
};
inline constexpr std::size_t kBlocks = 6; ///< Values of Block.

std::string_view toText(Block block); ///< "material": one word, for tables and JSON.

/// An input of the vertex shader: what differs from vertex to vertex.
struct Attribute {
    std::string name; ///< "aPosition"
    Type type;
    int location; ///< Fixed per name over all programs; see attributeLocation.
};

/// What the vertex shader hands to the fragment shader, interpolated.
struct Varying {
    std::string name; ///< "vNormal"
    Type type;
};

/// A value that is the same for a whole draw; fieldOffset() (pack.h) says where it is found.
struct Uniform {
    std::string name; ///< "uBaseColor"
    Type type;
    int count; ///< Array length; 1 if it is no array.
    Block block;
    bool vertex, fragment; ///< The stages that declare it.
    int value = 0;         ///< Of Block::User: which of the effect's values it is.
};

/// A texture that the fragment shader reads.
struct Sampler {
    std::string name; ///< "uBaseColorTexture"
    Type type;
    int unit; ///< Fixed per name over all programs; see samplerUnit.
    Block block;
};

/// All inputs of a program. The runtime reads them from here, so that it cannot disagree with the text.
struct Interface {
    /// Each in the order of the text.
    std::vector<Attribute> attributes;
    std::vector<Varying> varyings;
    std::vector<Uniform> uniforms;
    std::vector<Sampler> samplers;
    int lights = 0; ///< Suns and punctual lights that the fragment shader adds up.
};

/// aPosition 0, aNormal 1, aTangent 2, aUv0 3, aUv1 4, aColor 5, aJoints 6, aWeights 7.
/// -1 for a name that is no attribute.
int attributeLocation(std::string_view name);

/// The texture unit of a sampler, from the table of roles (texture_role.h). -1 for a name that is no sampler.
int samplerUnit(std::string_view name);

} // namespace franken
