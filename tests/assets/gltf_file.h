// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "franken/gltf.h"
#include "support/gltf_builder.h"

/// A glTF file that a test writes and loads.
class GltfFile : public GltfBuilder {
public:
    /// Writes the file below the test's folder for temporary files; as .glb where `binary`.
    std::filesystem::path write(bool binary = false) const;

    /// Writes and loads; warnings are added to `warnings`.
    franken::Result<franken::Scene> load(const franken::LoadOptions& options = {});
    /// As load(), and fails the test with an empty scene where it does not work.
    franken::Scene loaded();

    std::vector<std::string> warnings;
};

/// All .gltf and .glb files below `folder`, sorted; empty where there is no such folder.
std::vector<std::filesystem::path> gltfFilesBelow(const std::filesystem::path& folder);
/// The folder of files by others, next to the source tree.
std::filesystem::path sharedFolder();
