// SPDX-License-Identifier: MIT
// Every code of an error or a warning that the sources name stands in the table of lib/assets/README.md.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Codes, and a source that has them. A string of two words of small letters with a dot between is one,
/// unless it ends as a file's name does.
std::map<std::string, std::string> codesBelow(const fs::path& folder) {
    static const std::regex kCode("\"([a-z]+\\.[a-z]+(-[a-z]+)*)\"");
    std::map<std::string, std::string> codes;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const fs::path& path = entry.path();
        if (path.extension() != ".cpp" && path.extension() != ".h")
            continue;
        const std::string text = textOf(path);
        for (std::sregex_iterator match(text.begin(), text.end(), kCode), end; match != end; ++match)
            codes.emplace((*match)[1], path.string());
    }
    std::erase_if(codes, [](const auto& code) { return code.first.ends_with(".h"); });
    return codes;
}

TEST(ErrorTable, HasEachCodeOfTheSources) {
    const fs::path root = FRANKEN_SOURCE_DIR;
    const std::string table = textOf(root / "lib/assets/README.md");
    std::map<std::string, std::string> codes = codesBelow(root / "lib/assets");
    for (const auto& [code, file] : codesBelow(root / "lib/base"))
        if (code.starts_with("file."))
            codes.emplace(code, file);
    EXPECT_GE(codes.size(), 25u) << "the search finds what it looks for";
    for (const auto& [code, file] : codes)
        EXPECT_NE(table.find("`" + code + "`"), std::string::npos) << code << " of " << file;
}

// And nothing that the sources do not have.
TEST(ErrorTable, HasNoOtherCodes) {
    const fs::path root = FRANKEN_SOURCE_DIR;
    std::map<std::string, std::string> codes = codesBelow(root / "lib/assets");
    codes.merge(codesBelow(root / "lib/base"));
    const std::string table = textOf(root / "lib/assets/README.md");
    static const std::regex kCode("`((gltf|image|hdr|sky|height|file)\\.[a-z]+(-[a-z]+)*)`");
    for (std::sregex_iterator match(table.begin(), table.end(), kCode), end; match != end; ++match)
        EXPECT_TRUE((*match)[1] == "gltf.h" || codes.contains((*match)[1])) << (*match)[1];
}

} // namespace
