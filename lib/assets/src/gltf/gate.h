// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

#include "gltf/source.h"

// What comes before a parser that trusts its input.
namespace franken::gltf {

using Json = nlohmann::json;

/// Finds the JSON text and the binary chunk in Source::bytes.
bool openContainer(Source& source);

/// Checks the syntax, depth and size of the JSON text.
bool checkJson(Source& source);

/// checkJson(); then checks version, required extensions, and names and types of all properties. `root` holds
/// nothing then but what the loader reads.
bool readJson(Source& source, Json& root);

/// Checks that all members that the loader reads are there where glTF requires them, and have the type, the
/// range and the array length that glTF gives them. All others are removed from `root`, extras and
/// unknown extensions among them, so that the parser sees nothing that was not checked, and never drops
/// anything in silence. A null counts as absent. A faulty element of an array that something drawn need not
/// use becomes an empty one, and its fault is deferred. Recursion is bounded by the depth of the schema, not
/// of the file.
bool checkSchema(Source& source, Json& root);

/// The member, or null where there is none or `object` is not an object.
const Json& member(const Json& object, const char* key);

/// Refuses what requires an extension that is not known, in words or because it has no data without it; warns
/// of the others.
bool checkExtensions(Source& source, const Json& root);

/// Fills the bytes, from the binary chunk, data URIs, and files in `folder` or below (none: no files). Fails
/// only where it would be too much.
bool loadResources(Source& source, const std::filesystem::path* folder);

struct UriContents {
    std::vector<std::uint8_t> bytes;
    std::filesystem::path file; ///< Empty for a data URI.
};

/// What a data URI holds, or the file in `folder` that a relative one names. No scheme, no absolute path, no
/// ".." that leaves the folder and no symbolic link out of it is followed. A backslash separates where no
/// file has it in its name. Fails with "gltf.uri", "file.outside", "file.open" or "file.size".
Result<UriContents> readUri(const std::string& uri, const std::filesystem::path* folder,
                            std::size_t maxBytes);
bool isDataUri(const std::string& uri);

} // namespace franken::gltf
