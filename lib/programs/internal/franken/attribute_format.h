// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/gl.h"

#include <array>

namespace FRANKEN_API franken {

/// The type of one attribute in a vertex buffer. What is not GL_FLOAT is normalised.
struct AttributeFormat {
    GLint size; ///< Components.
    GLenum type;
};

/// By attribute location (see attributeLocation()): position, normal, tangent, uv0, uv1, colour, joints,
/// weights. Every mesh
/// uses these, because vc4 and v3d compile a program again for another format.
inline constexpr std::array<AttributeFormat, 8> kAttributeFormats = {{
    {3, GL_FLOAT},
    {3, GL_FLOAT},
    {4, GL_FLOAT},
    {2, GL_FLOAT},
    {2, GL_FLOAT},
    {4, GL_UNSIGNED_SHORT},
    {4, GL_FLOAT},
    {4, GL_FLOAT},
}};

} // namespace franken
