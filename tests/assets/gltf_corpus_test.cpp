// SPDX-License-Identifier: MIT
// Files by others: sound ones load, broken ones are refused or harmless, none is a crash.
#include <iostream>
#include <map>

#include "gltf_file.h"

namespace {

/// Every index of the scene in range, every array as long as it has to be.
void expectConsistent(const franken::Scene& scene, const std::string& name) {
    for (const franken::Instance& instance : scene.instances)
        ASSERT_LT(static_cast<std::size_t>(instance.mesh), scene.meshes.size()) << name;
    for (const franken::Mesh& mesh : scene.meshes)
        for (const franken::Primitive& primitive : mesh.primitives) {
            const std::size_t count = primitive.positions.size();
            ASSERT_LT(static_cast<std::size_t>(primitive.material), scene.materials.size()) << name;
            ASSERT_EQ(primitive.indices.size() % 3, 0u) << name;
            for (const std::uint32_t index : primitive.indices)
                ASSERT_LT(index, count) << name;
            ASSERT_EQ(primitive.normals.size(), count) << name;
            for (const std::size_t size : {primitive.tangents.size(), primitive.uv[0].size(),
                                           primitive.uv[1].size(), primitive.colors.size()})
                ASSERT_TRUE(size == 0 || size == count) << name;
        }
    for (const franken::Image& image : scene.images)
        ASSERT_EQ(image.rgba.size(),
                  4u * static_cast<unsigned>(image.width) * static_cast<unsigned>(image.height));
}

/// Loads all files and prints how many were refused, by code; the messages come back.
std::map<std::string, std::vector<std::string>> loadAll(const std::filesystem::path& folder) {
    std::map<std::string, std::vector<std::string>> refused;
    std::size_t loaded = 0;
    for (const std::filesystem::path& path : gltfFilesBelow(folder)) {
        const auto scene = franken::loadGltf(path);
        if (scene) {
            ++loaded;
            expectConsistent(*scene, path.string());
        } else {
            EXPECT_TRUE(scene.error().code.starts_with("gltf.")) << toString(scene.error());
            refused[scene.error().code].push_back(toString(scene.error()));
        }
    }
    std::cout << folder.filename().string() << ": " << loaded << " loaded\n";
    for (const auto& [code, errors] : refused)
        std::cout << folder.filename().string() << ": " << errors.size() << " refused with " << code << "\n";
    return refused;
}

TEST(GltfCorpus, ValidFilesLoadOrNameTheExtension) {
    const auto folder = sharedFolder() / "assets/valid";
    if (!std::filesystem::exists(folder))
        GTEST_SKIP() << "no " << folder;
    for (const auto& [code, errors] : loadAll(folder))
        for (const std::string& error : errors)
            EXPECT_TRUE(code == "gltf.extension" || error.find("/asset/minVersion") != std::string::npos)
                << error;
}

TEST(GltfCorpus, ReferenceScenesLoad) {
    const auto folder = sharedFolder() / "reference";
    if (!std::filesystem::exists(folder))
        GTEST_SKIP() << "no " << folder;
    EXPECT_TRUE(loadAll(folder).empty());
}

TEST(GltfCorpus, AssimpModelsLoad) {
    const std::filesystem::path folder = "/usr/share/assimp/models/glTF2";
    if (!std::filesystem::exists(folder))
        GTEST_SKIP() << "no " << folder << " (package assimp-testmodels)";
    loadAll(folder); // broken ones are among them
}

TEST(GltfCorpus, InvalidFilesAreNoCrash) {
    const auto folder = sharedFolder() / "assets/invalid";
    if (!std::filesystem::exists(folder))
        GTEST_SKIP() << "no " << folder;
    EXPECT_FALSE(loadAll(folder).empty());
}

} // namespace
