// SPDX-License-Identifier: MIT
#pragma once

#include "franken/scene.h"
#include "json.h"

#include <cstdint>

namespace franken::web {

/// Where an array is in memory, and how many numbers or bytes it has: [address, count].
template<typename Elements>
void writeArray(Json& json, std::string_view name, const Elements& elements, std::size_t each) {
    json.key(name).begin('[').value(reinterpret_cast<std::uintptr_t>(elements.data()));
    json.value(elements.size() * each).end(']');
}

/// An object of its arrays.
inline void writePrimitive(Json& json, const Primitive& primitive) {
    json.begin('{').member("material", primitive.material);
    writeArray(json, "positions", primitive.positions, 3);
    writeArray(json, "normals", primitive.normals, 3);
    writeArray(json, "tangents", primitive.tangents, 4);
    writeArray(json, "uv0", primitive.uv[0], 2);
    writeArray(json, "uv1", primitive.uv[1], 2);
    writeArray(json, "colors", primitive.colors, 4);
    writeArray(json, "indices", primitive.indices, 1);
    json.end('}');
}

} // namespace franken::web
