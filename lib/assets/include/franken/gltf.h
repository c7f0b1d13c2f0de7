// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>

#include "franken/api.h"
#include "franken/log.h"
#include "franken/result.h"
#include "franken/scene.h"

namespace FRANKEN_API franken {

/// How the images of a scene come out.
enum class ImageForm {
    Pixels,  ///< Image::rgba: decoded, all of them at once in memory.
    Encoded, ///< Image::encoded: to be decoded one at a time, by whoever uploads them. Only headers are read.
};

/// Called with the share of loading that is done, 0 to 1 and never less than before, and with what is being
/// done ("images"). In the thread that loads; exceptions that it throws are dropped.
using LoadProgress = std::function<void(float done, std::string_view what)>;

/// Limits for loading a file, and how to load it. A file that exceeds the limits is refused, not cut.
struct LoadOptions {
    /// Of the file, and of each that it refers to.
    std::size_t maxFileBytes = std::size_t{128} << 20;

    /// Of all that loading allocates: files, parsed JSON, decoded images and vertices, counted before they
    /// are allocated and never subtracted again. Some 16 MiB go uncounted (code, and rounding by the
    /// allocator), so that any process that loads a file stays below 256 MiB. That is much for a Raspberry Pi
    /// 3, and little for a film's set: 12 textures of 2048 x 2048, or two million vertices.
    std::size_t maxMemoryBytes = std::size_t{240} << 20;

    int maxImageSize = kMaxImageSize; ///< Width and height of an image, pixels.

    /// For a scene that goes to a renderer, Encoded: five JPEGs of 4096 x 4096 take 320 MiB as pixels. An
    /// image with a good header that cannot be decoded is only found when it is uploaded, then.
    ImageForm images = ImageForm::Pixels;

    LoadProgress progress = {}; ///< Called between images and meshes; empty for none.

    /// Ends loading with "gltf.cancelled" where it is requested, from any thread; after one image or mesh at
    /// most.
    std::stop_token cancel = {};
};

/// Reads a glTF 2.0 file (.gltf or .glb, distinguished by content) with all files that it refers to.
///
/// What comes out is at rest: the default scene (else the first, else all root nodes), with the default
/// morph weights and the skins of the file's own pose applied once, strips and fans as lists, every integer
/// format as float, missing normals flat and missing tangents computed, as the glTF 2.0 text has it.
/// Points, lines and optional extensions that are not known are left out, each with one warning.
/// Animations, skins and morph targets come along (pose.h, deform.h).
///
/// Known extensions: EXT_mesh_gpu_instancing, KHR_animation_pointer (of nodes), KHR_lights_punctual,
/// KHR_materials_emissive_strength, KHR_materials_unlit, KHR_materials_variants, KHR_mesh_quantization,
/// KHR_node_visibility, KHR_texture_transform. Another one that the file requires is an error that names it,
/// unless a picture at rest is right without.
///
/// The file may be malicious. Its container, JSON, names and types are checked before a parser sees them, the
/// parser's result is checked again, and image headers are read before images are decoded. Accessors' `min`
/// and `max` are not trusted: boxes are measured.
///
/// What endangers memory or has two readings is an error. What has one reading is drawn by it, and what is
/// wrong with a part that nothing drawn needs costs that part alone: a warning names the fault then. The
/// table of both is in lib/assets/README.md.
///
/// Files that it refers to are read from its folder and below, nowhere else: not over a network, not by an
/// absolute path, not by a ".." that leaves the folder, not by a symbolic link out of it. An image that is
/// missing or broken is a warning. An error's `where` is "file: /json/path" ("file: byte N" for a syntax
/// error, only the file where the container is at fault):
///
///     gltf.file            cannot be read, or is over maxFileBytes
///     gltf.buffer          the bytes of a buffer that is drawn are missing
///     gltf.container       a .glb whose chunks do not fit
///     gltf.json            not JSON
///     gltf.schema          a property is missing, or has another JSON type or array length than glTF's
///     gltf.version         not glTF 2.x, or for readers of more than 2.0
///     gltf.extension       requires an extension that is not known
///     gltf.index-range     an index that points at nothing
///     gltf.bounds          an accessor or view that reaches outside its buffer
///     gltf.type            a component type, element type or count that glTF does not allow there
///     gltf.value           a number that glTF does not allow there (not finite, an unknown enumerator, ...)
///     gltf.node-tree       nodes in a cycle, or with two parents
///     gltf.vertex-range    a vertex index that is not below the vertex count
///     gltf.limit           deeper than 64, more than the options allow, or than there is memory
///     gltf.cancelled       LoadOptions::cancel was requested: nothing is wrong with the file
///
/// Warnings end with their code in brackets:
///
///     gltf.mended          a fault that has one reading, by which it is drawn
///     gltf.unneeded        a fault in a part that nothing drawn needs; with the code that it would have
///     gltf.left-out        a part that is not drawn
///
/// Safe on any thread; decodes images on several of its own.
Result<Scene> loadGltf(const std::filesystem::path& path, const LoadOptions& options = {},
                       const Log& log = {});

/// Reads a glTF 2.0 file from memory. `name` is for messages. Files that it refers to are not read: their
/// images are left out, and their buffers fail with "gltf.buffer". Otherwise as the function above.
Result<Scene> loadGltf(std::span<const std::uint8_t> file, const std::string& name,
                       const LoadOptions& options = {}, const Log& log = {});

} // namespace franken
