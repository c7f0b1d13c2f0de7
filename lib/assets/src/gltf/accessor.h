// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "gltf/document.h"

namespace franken::gltf {

/// The bytes of a valid view; empty, with an error, where its buffer has none.
std::span<const std::uint8_t> viewBytes(Document& source, int view);
/// Floats in one element of a valid accessor: 3 for VEC3, 16 for MAT4.
int width(const tinygltf::Accessor& accessor);
/// All elements of the accessor as floats, normalised integers in 0..1 or -1..1, sparse values applied.
/// `out` holds count * width(accessor) floats. Fails where a float is not finite.
bool readFloats(Document& source, int accessor, std::span<float> out);
/// All elements of a scalar integer accessor.
bool readIndices(Document& source, int accessor, std::vector<std::uint32_t>& out);
/// Four joint numbers for each vertex.
bool readJoints(Document& source, int accessor, std::vector<glm::uvec4>& out);

/// As readFloats(), into vectors. The accessor's width must be that of Vector.
template<typename Vector>
bool readVectors(Document& source, int accessor, std::vector<Vector>& out) {
    out.resize(source.model.accessors[at(accessor)].count);
    return readFloats(source, accessor,
                      {&out[0][0], out.size() * static_cast<std::size_t>(Vector::length())});
}

} // namespace franken::gltf
