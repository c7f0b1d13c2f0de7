// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>
// The one place that includes tinygltf: its Model is what the loader's files hand to each other, and a copy
// of it in types of our own would only double it. Only gltf_*.cpp see this header.
#include <tiny_gltf.h>

#include "franken/gltf.h"
#include "franken/scene.h"

namespace franken::gltf {

inline constexpr std::string_view kDamaged = "the file is cut or damaged: copy or export it again";
inline constexpr std::string_view kFixExporter =
    "export the file again, or see what glTF-Validator says of it";

/// A buffer of the file. Its bytes are looked for, but their absence is an error only where they are drawn.
struct Buffer {
    std::string uri; ///< Empty: the binary chunk, or none at all.
    bool hasUri = false;
    std::size_t length = 0;              ///< As declared; the bytes may be none.
    std::span<const std::uint8_t> bytes; ///< Exactly `length`, or empty.
    std::vector<std::uint8_t> storage;   ///< What `bytes` points into, unless that is Source::bytes.
    std::string problem;                 ///< Why there are no bytes.
};

/// An image of the file, still as PNG or JPEG.
struct EncodedImage {
    std::string name;
    std::string uri;
    int view = kNone;                ///< The buffer view that holds it, where it has no URI.
    std::vector<std::uint8_t> bytes; ///< Where it has one.
    std::string problem;             ///< Why there are no bytes.
};

/// A file being loaded, and where complaints about it go. Functions that can fail return false after a call
/// of fail(); the first error stays.
struct Source {
    std::string file;
    LoadOptions options;
    Log log;
    std::span<const std::uint8_t> bytes;       ///< The file.
    std::span<const std::uint8_t> jsonText;    ///< In `bytes`.
    std::span<const std::uint8_t> binaryChunk; ///< In `bytes`; empty in a .gltf.
    std::vector<Buffer> buffers;
    std::vector<EncodedImage> images;
    int placeholderView = kNone; ///< Stands for "no buffer view" while tinygltf parses.
    tinygltf::Model model;       ///< Its own buffers and images are empty shells.
    std::size_t charged = 0;     ///< Bytes, of LoadOptions::maxMemoryBytes.
    std::optional<Error> error;
    std::set<std::string> warned;

    /// Records an error at the JSON path `where`; false, to be returned.
    bool fail(std::string_view code, const std::string& where, std::string what,
              std::string_view remedy = kFixExporter);
    /// Takes `count` times `bytesEach` from the memory that the file may use, for `where`, before it is
    /// allocated. Nothing is ever given back: so it bounds the work as well.
    bool charge(std::size_t count, std::size_t bytesEach, const std::string& where);
    /// What is left of it.
    std::size_t room() const { return options.maxMemoryBytes - charged; }
    /// Logs a warning at the JSON path `where`.
    void warn(const std::string& where, const std::string& what) const;
    /// Logs a warning whose text was not there before.
    void warnOnce(const std::string& what);
    bool uses(std::string_view extension) const;
};

/// "/meshes/0/primitives/1" from ("meshes", 0, "primitives", 1).
template<typename... Parts>
std::string pathOf(const Parts&... parts) {
    std::string path;
    const auto add = [&path](const auto& part) {
        path += '/';
        if constexpr (std::is_arithmetic_v<std::decay_t<decltype(part)>>)
            path += std::to_string(part);
        else
            path += part;
    };
    (add(parts), ...);
    return path;
}

inline std::size_t at(int index) { return static_cast<std::size_t>(index); }

// gltf_container.cpp, gltf_gate.cpp, gltf_json.cpp, gltf_resources.cpp: what comes before a parser that
// trusts its input.

/// Finds the JSON text and the binary chunk in Source::bytes.
bool openContainer(Source& source);
/// Checks the syntax, depth and size of the JSON text.
bool checkJson(Source& source);
/// checkJson(); checks version, required extensions, and names and types of all properties; fills
/// Source::buffers and Source::images but for their bytes; and returns JSON for tinygltf that it accepts and
/// in which nothing refers to anything outside it.
bool readJson(Source& source, std::string& text);
/// Fills the bytes, from the binary chunk, data URIs, and files in `folder` or below (none: no files). Fails
/// only where it would be too much.
bool loadResources(Source& source, const std::filesystem::path* folder);

// gltf_uri.cpp

/// What a data URI holds, or the file in `folder` that a relative one names. No scheme, no absolute path, no
/// ".." and no symbolic link out of the folder is followed. Fails with "gltf.uri", "file.outside",
/// "file.open" or "file.size".
Result<std::vector<std::uint8_t>> readUri(const std::string& uri, const std::filesystem::path* folder,
                                          std::size_t maxBytes);

// gltf_validate_data.cpp and gltf_validate_tree.cpp: what has to hold for the parsed model. After these two,
// every index in Source::model is in range, every accessor lies inside its buffer and every attribute has a
// type that its semantic allows. Only the contents of the buffers are still unknown.

bool validateData(Source& source);
bool validateTree(Source& source);

/// False with an error unless `index` is -1 (absent) or below `size`.
bool checkIndex(Source& source, int index, std::size_t size, const std::string& where);
/// False with an error unless `index` is below `size`.
bool checkPresent(Source& source, int index, std::size_t size, const std::string& where);
/// False with an error unless all numbers are finite as floats.
bool checkFinite(Source& source, const std::vector<double>& numbers, const std::string& where);

// gltf_accessor.cpp

/// The bytes of a valid view; empty, with an error, where its buffer has none.
std::span<const std::uint8_t> viewBytes(Source& source, int view);
/// Floats in one element of a valid accessor: 3 for VEC3, 16 for MAT4.
int width(const tinygltf::Accessor& accessor);
/// All elements of the accessor as floats, normalised integers in 0..1 or -1..1, sparse values applied.
/// `out` holds count * width(accessor) floats. Fails where a float is not finite.
bool readFloats(Source& source, int accessor, std::span<float> out);
/// All elements of a scalar integer accessor.
bool readIndices(Source& source, int accessor, std::vector<std::uint32_t>& out);
/// Four joint numbers for each vertex.
bool readJoints(Source& source, int accessor, std::vector<glm::uvec4>& out);

/// As readFloats(), into vectors. The accessor's width must be that of Vector.
template<typename Vector>
bool readVectors(Source& source, int accessor, std::vector<Vector>& out) {
    out.resize(source.model.accessors[at(accessor)].count);
    return readFloats(source, accessor,
                      {&out[0][0], out.size() * static_cast<std::size_t>(Vector::length())});
}

// gltf_image.cpp

/// Decodes the images that are `used`; warns of those that cannot be decoded and marks them as `broken`.
/// These and the unused ones come out as one white pixel. Fails where a buffer that holds one is missing.
bool readImages(Source& source, const std::vector<bool>& used, std::vector<bool>& broken,
                std::vector<Image>& images);

// gltf_material.cpp

/// Fills materials, textures and images.
bool readMaterials(Source& source, Scene& scene);

// gltf_mesh.cpp

/// How a node bends its mesh: morph weights, and for a skin what moves a vertex from the mesh into the world.
struct Pose {
    std::vector<double> weights;
    std::vector<glm::mat4> joints; ///< jointWorld * inverseBindMatrix; empty without a skin.
    bool mirrored =
        false; ///< Of a skin: the node's determinant is negative, so that front faces wind clockwise.
};

/// The file's mesh in the given pose. Its primitives' materials are indices into scene.materials, to which a
/// default is added where it is needed; a mesh of which nothing can be drawn comes out without primitives.
bool readMesh(Source& source, int mesh, const Pose& pose, Scene& scene, Mesh& out);

// gltf_pose.cpp

/// Adds the weighted morph targets to positions, and to normals and tangents where the primitive has them.
bool applyMorph(Source& source, const tinygltf::Primitive& from, const std::string& where,
                const std::vector<double>& weights, Primitive& primitive);
/// Moves positions, normals and tangents by the weighted joints of JOINTS_0 and WEIGHTS_0.
bool applySkin(Source& source, const tinygltf::Primitive& from, const std::string& where,
               const std::vector<glm::mat4>& joints, Primitive& primitive);

// gltf_view.cpp: the camera and the light of that number, without their place in the world.

bool readCamera(Source& source, int index, Camera& camera);
/// False, with a warning, for a type that is none of directional, point and spot.
bool isKnownLight(Source& source, int index);
bool readLight(Source& source, int index, Light& light);

// gltf_node.cpp

/// Walks the scene's nodes: meshes, instances, cameras and lights. Needs the materials.
bool readNodes(Source& source, Scene& scene);

} // namespace franken::gltf
