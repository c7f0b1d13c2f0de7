// SPDX-License-Identifier: MIT
// The contract of a snippet file, kept by all files and enforced on bad ones.
#include "snippet.h"

#include "recipe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace franken {
namespace {

TEST(Snippets, AllParse) {
    for (const SnippetFile& file : embeddedSnippets()) {
        const auto snippet = parseSnippet(file);
        ASSERT_TRUE(snippet) << toString(snippet.error());
        EXPECT_TRUE(file.text.starts_with("// ")) << file.name << " begins with what it is for";
        EXPECT_LE(std::count(file.text.begin(), file.text.end(), '\n'), 120) << file.name;
    }
}

TEST(Snippets, AllAreInTheRecipe) {
    std::set<std::string> files, rows;
    for (const SnippetFile& file : embeddedSnippets())
        files.emplace(file.name);
    for (const Row& row : recipe())
        rows.insert((row.stage == Stage::Vertex ? "vertex/" : "fragment/") + std::string(row.snippet));
    EXPECT_EQ(files, rows);
}

struct BadSnippet {
    std::string_view text, what;
    int line;
};

constexpr BadSnippet kBad[] = {
    {"// A snippet.\nuniform float uX; // frame: x\n", "GLSL before the first section", 2},
    {"//! declaration\n", "the sections are", 1},
    {"//! main\n  x = ${colour};\n", "the placeholders are", 2},
    {"//! main\n  x = ${light;\n", "the placeholders are", 2},
    {"//! declarations\nuniform float uX;\n", "'// block: meaning'", 2},
    {"//! declarations\nuniform float uX; // camera: x\n", "'// block: meaning'", 2},
    {"//! declarations\nuniform int uX; // frame: x\n", "a type and a name", 2},
    {"//! declarations\nvarying vec3 ;\n", "a type and a name", 2},
    {"//! declarations\nuniform vec3 uX[]; // frame: x\n", "the length of an array", 2},
    {"//! declarations\nuniform vec3 uX[0]; // frame: x\n", "the length of an array", 2},
    {"//! declarations\nuniform vec3 uX[-2]; // frame: x\n", "the length of an array", 2},
    {"//! declarations\nuniform vec3 uX[9 ; // frame: x\n", "the length of an array", 2},
    {"//! declarations\nuniform vec3 uX[kCount]; // frame: x\n", "the length of an array", 2},
    {"//! declarations\nuniform vec3 uX[99999999999]; // frame: x\n", "the length of an array", 2},
};

TEST(Snippets, ArraysHaveAnyLength) {
    for (const auto& [text, count] : {std::pair("uSky", 1),
                                      {"uSky[1]", 1},
                                      {"uSky[9]", 9},
                                      {"uSky[10]", 10},
                                      {"uSky[90]", 90},
                                      {"uSky [128]", 128}}) {
        const std::string file =
            "//! declarations\nuniform vec3 " + std::string(text) + "; // lights: a sky\n";
        const auto snippet = parseSnippet({"fragment/array", file});
        ASSERT_TRUE(snippet) << toString(snippet.error());
        ASSERT_EQ(snippet->interface.size(), 1u);
        EXPECT_EQ(snippet->interface[0].count, count) << text;
    }
}

TEST(Snippets, RefusesBadOnesWithFileAndLine) {
    for (const BadSnippet& row : kBad) {
        const auto snippet = parseSnippet({"fragment/bad", row.text});
        ASSERT_FALSE(snippet) << row.text;
        EXPECT_EQ(snippet.error().code, "snippet.syntax");
        EXPECT_EQ(snippet.error().where, "generator/glsl/fragment/bad.glsl:" + std::to_string(row.line));
        EXPECT_NE(snippet.error().what.find(row.what), std::string::npos) << snippet.error().what;
    }
}

} // namespace
} // namespace franken
