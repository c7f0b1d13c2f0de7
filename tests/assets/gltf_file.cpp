// SPDX-License-Identifier: MIT
#include "gltf_file.h"

#include <algorithm>
#include <atomic>
#include <fstream>

#include <unistd.h>

std::filesystem::path GltfFile::write(bool binary) const {
    static std::atomic<int> counter = 0;
    const std::filesystem::path path =
        std::filesystem::path(testing::TempDir()) / ("franken_" + std::to_string(getpid()) + "_" +
                                                     std::to_string(counter++) + (binary ? ".glb" : ".gltf"));
    std::ofstream(path, std::ios::binary) << bytes(binary);
    return path;
}

franken::Result<franken::Scene> GltfFile::load(const franken::LoadOptions& options) {
    const std::filesystem::path path = write();
    auto scene = franken::loadGltf(
        path, options, [this](franken::LogLevel, std::string_view text) { warnings.emplace_back(text); });
    std::filesystem::remove(path);
    return scene;
}

franken::Scene GltfFile::loaded() {
    auto scene = load();
    if (scene)
        return *std::move(scene);
    ADD_FAILURE() << toString(scene.error());
    return {};
}

std::vector<std::filesystem::path> gltfFilesBelow(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    if (std::filesystem::exists(folder))
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
            if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb")
                files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

std::filesystem::path sharedFolder() {
    return std::filesystem::path(FRANKEN_SOURCE_DIR).parent_path() / "shared";
}
