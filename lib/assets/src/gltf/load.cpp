// SPDX-License-Identifier: MIT
#include <algorithm>
#include <exception>
#include <new>

#include "franken/file.h"
#include "gltf/animation.h"
#include "gltf/material.h"
#include "gltf/node.h"

namespace franken {
namespace gltf {

bool Document::uses(std::string_view extension) const {
    return std::find(model.extensionsUsed.begin(), model.extensionsUsed.end(), extension) !=
           model.extensionsUsed.end();
}

namespace {

constexpr std::size_t kMaxParserBytes = 0xFFFFFFFF; ///< tinygltf counts in 32 bits.

bool load(Document& source, const std::filesystem::path* folder, Scene& scene) {
    Json root;
    NodePlaces places;
    if (!source.proceed(kReadFile, "JSON") || !source.charge(source.bytes.size(), 1, "") ||
        !openContainer(source) || !readJson(source, root) || !parseModel(source, root) ||
        !validateData(source) || !validateTree(source) || !source.proceed(kReadJson, "files") ||
        !loadResources(source, folder) || !readMaterials(source, materialsInScene(source), scene) ||
        !readSkeleton(source, scene, places) || !readNodes(source, places, scene) ||
        !readAnimations(source, places, scene) || !source.proceed(1, "done"))
        return false;
    source.warnOfUnneeded();
    return true;
}

Result<Scene> loadBytes(std::span<const std::uint8_t> bytes, const std::string& name,
                        const std::filesystem::path* folder, const LoadOptions& options, const Log& log) {
    Document source;
    source.file = name;
    source.options = options;
    source.log = log;
    source.bytes = bytes;
    if (folder != nullptr)
        source.files.push_back(name);
    Scene scene;
    try {
        if (load(source, folder, scene)) {
            scene.files = std::move(source.files);
            return scene;
        }
    } catch (const std::bad_alloc&) {
        source.fail("gltf.limit", "", "there is not enough memory for the file", "make the model smaller");
    } catch (const std::exception& exception) {
        source.fail("gltf.json", "", std::string("the parser failed: ") + exception.what());
    }
    return *std::move(source.error);
}

} // namespace
} // namespace gltf

namespace {

constexpr const char* kRaiseFileLimit = "make it smaller, or raise LoadOptions::maxFileBytes";

} // namespace

Result<Scene> loadGltf(const std::filesystem::path& path, const LoadOptions& options, const Log& log) {
    const auto bytes = readFile(path, std::min(options.maxFileBytes, gltf::kMaxParserBytes));
    if (!bytes)
        return Error{"gltf.file", path.string(), bytes.error().what,
                     bytes.error().code == "file.size" ? kRaiseFileLimit : bytes.error().remedy};
    const std::filesystem::path folder = path.parent_path();
    return gltf::loadBytes(*bytes, path.string(), &folder, options, log);
}

Result<Scene> loadGltf(std::span<const std::uint8_t> file, const std::string& name,
                       const LoadOptions& options, const Log& log) {
    const std::size_t limit = std::min(options.maxFileBytes, gltf::kMaxParserBytes);
    if (file.size() > limit)
        return Error{"gltf.file", name, "the file is over the limit of " + std::to_string(limit) + " bytes",
                     kRaiseFileLimit};
    return gltf::loadBytes(file, name, nullptr, options, log);
}

} // namespace franken
