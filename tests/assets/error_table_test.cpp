// SPDX-License-Identifier: MIT
// Every code of an error or a warning that the sources name stands in the table of lib/assets/README.md.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Two words of small letters with a dot between, the second perhaps with dashes ("gltf.index-range"); not
/// what ends as a file's name does.
bool isCode(std::string_view text) {
    const auto isWord = [](std::string_view word) {
        return !word.empty() &&
               word.find_first_not_of("abcdefghijklmnopqrstuvwxyz-") == std::string_view::npos;
    };
    const std::size_t dot = text.find('.');
    return dot != std::string_view::npos && isWord(text.substr(0, dot)) && isWord(text.substr(dot + 1)) &&
           !text.ends_with(".h");
}

/// What stands between two of the marks and is a code.
std::vector<std::string> codesBetween(const std::string& text, char mark) {
    std::vector<std::string> codes;
    for (std::size_t begin = text.find(mark); begin != std::string::npos;) {
        const std::size_t end = text.find(mark, begin + 1);
        if (end == std::string::npos)
            break;
        if (const std::string inside = text.substr(begin + 1, end - begin - 1); isCode(inside))
            codes.push_back(inside);
        begin = end; // An end may be the next one's beginning: code may have marks that stand alone.
    }
    return codes;
}

/// Codes, and a source that has them.
std::map<std::string, std::string> codesBelow(const fs::path& folder) {
    std::map<std::string, std::string> codes;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const fs::path& path = entry.path();
        if (path.extension() == ".cpp" || path.extension() == ".h")
            for (const std::string& code : codesBetween(textOf(path), '"'))
                codes.emplace(code, path.string());
    }
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
    for (const std::string& code : codesBetween(table, '`')) {
        EXPECT_TRUE(codes.contains(code)) << code;
    }
}

} // namespace
