// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>

#include "franken/log.h"
#include "franken/result.h"
#include "franken/scene.h"

namespace franken {

/// How much of a file is believed. A file that asks for more is refused, not cut.
struct LoadOptions {
    std::size_t maxFileBytes = std::size_t{1} << 30; ///< Of the file, and of each that it refers to.
    std::size_t maxElements = 4'194'304;             ///< Of one accessor, whether or not it has bytes.
    std::size_t maxVertices = 16'777'216; ///< Of all meshes and poses together, indices counted too.
    int maxImageSize = kMaxImageSize;     ///< Width and height of an image, pixels.
};

/// Reads a glTF 2.0 file (.gltf or .glb, told apart by content) with all that it refers to.
///
/// What comes out is at rest: the default scene (else the first, else all root nodes), with the default
/// morph weights and the skins of the file's own pose applied once, strips and fans as lists, every integer
/// format as float, missing normals flat and missing tangents computed, as the glTF 2.0 text has it.
/// Animations, points, lines and optional extensions that are not known are left out, each with one warning.
///
/// Known extensions: KHR_lights_punctual, KHR_materials_emissive_strength, KHR_materials_unlit,
/// KHR_mesh_quantization, KHR_texture_transform. Another one that the file requires is an error that names
/// it.
///
/// Files that it refers to are looked for in its folder and below, nowhere else: not over a network, not by
/// an absolute path, not by "..". An image that is missing or broken is a warning. Everything else is an
/// error, whose `where` is "file: /json/path":
///
///     gltf.file            cannot be read, or is too large
///     gltf.buffer          the bytes of a buffer that is drawn are missing
///     gltf.container       a .glb whose chunks do not fit
///     gltf.json            not JSON, or nothing that a glTF parser takes
///     gltf.version         not glTF 2.x
///     gltf.extension       requires an extension that is not known
///     gltf.index-range     an index that points at nothing
///     gltf.bounds          an accessor or view that reaches outside its buffer
///     gltf.type            a component type, element type or count that glTF does not allow there
///     gltf.value           a number that glTF does not allow there (not finite, an unknown enumerator, ...)
///     gltf.node-tree       nodes in a cycle, or with two parents
///     gltf.vertex-range    a vertex index that is not below the vertex count
///     gltf.limit           more than the options allow, or than there is memory
///
/// Safe on any thread; decodes images on several of its own.
Result<Scene> loadGltf(const std::filesystem::path& path, const LoadOptions& options = {},
                       const Log& log = {});

} // namespace franken
