// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "support/gltf_builder.h"

/// A file with something wrong, made by a program: the same bytes on every run.
struct MalformedFile {
    std::string name; ///< What is wrong with it; a path by slashes.
    std::string extension;
    std::string bytes;
    std::string code;    ///< Of the error that refuses it; empty where the fault is harmless and it loads.
    std::string where{}; ///< What the error's `where` ends with, a JSON path mostly; empty: anything.
    std::vector<std::pair<std::string, std::string>> beside{}; ///< Names and bytes of files in its folder.
};

/// A model that uses all that the loader reads: a triangle with all attributes, indices, a morph target, a
/// skin, a sparse accessor, a material with five textures and three extensions, a camera, a light.
GltfBuilder soundModel();

// By what is wrong.
std::vector<MalformedFile> malformedContainers(); ///< The chunks of a .glb.
std::vector<MalformedFile> malformedJson();       ///< Syntax, depth, version, extensions.
std::vector<MalformedFile>
malformedSchemas();                         ///< Each property of soundModel() in turn: type, range, absence.
std::vector<MalformedFile> malformedData(); ///< Buffers, views, accessors, vertices, values, the node tree.
std::vector<MalformedFile> malformedUris(); ///< Names of other files.
std::vector<MalformedFile> malformedImages(); ///< PNG and JPEG inside of a model.
std::vector<MalformedFile> greedyFiles();     ///< Sound or nearly so, and ask for too much.
std::vector<MalformedFile> malformedSkies();  ///< .hdr files, and PNG and JPEG as skies.

/// All of these.
std::vector<MalformedFile> malformedFiles();
