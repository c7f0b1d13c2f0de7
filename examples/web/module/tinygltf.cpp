// SPDX-License-Identifier: MIT
// The parser itself, which Debian has as a library for its own processors only. It reads no file and decodes
// no image (CMakeLists.txt).
#include <fstream> // which the parser forgets where it reads no file

#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
