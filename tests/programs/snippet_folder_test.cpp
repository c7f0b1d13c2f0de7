// SPDX-License-Identifier: MIT
// Programs from snippets that are read from a folder.
#include "franken/generator/compose.h"
#include "franken/snippet_folder.h"
#include "support/shell.h"

#include <thread>

namespace fs = std::filesystem;

namespace franken {
namespace {

class SnippetSetTest : public testing::Test {
protected:
    void SetUp() override {
        fs::copy(fs::path(FRANKEN_SOURCE_DIR) / "generator/glsl", m_folder, fs::copy_options::recursive);
    }

    std::string read(const std::string& name) const { return test::readText(m_folder / name); }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(m_folder / name) << text;
    }
    Error failure() const {
        const Result<SnippetSet> set = readSnippets(m_folder);
        return set ? Error{"none", "", "", ""} : set.error();
    }

    static Permutation permutation(const char* name) { return canonicalise(*parseName(name))->permutation; }

    const fs::path m_folder = test::emptyTestFolder();
};

TEST_F(SnippetSetTest, TheSourceTreesFolderIsWhatIsBuiltIn) {
    const Result<SnippetSet> set = readSnippets(m_folder);
    ASSERT_TRUE(set) << toString(set.error());
    for (const char* name :
         {"sun1", "basecolor.normal.metalrough.emissive+sh+sun2+punctual1+spots+aces+dither", "sky",
          "overlay", "normal+sun1+vertexlight", "unlit"}) {
        const Composed built = compose(permutation(name)), read = compose(permutation(name), *set);
        EXPECT_EQ(built.vertex.text, read.vertex.text) << name;
        EXPECT_EQ(built.fragment.text, read.fragment.text) << name;
        EXPECT_EQ(built.interface.uniforms.size(), read.interface.uniforms.size()) << name;
    }
}

TEST_F(SnippetSetTest, AChangedFileChangesTheProgramsThatHaveIt) {
    write("fragment/ambient/none.glsl",
          read("fragment/ambient/none.glsl") + "  sum.diffuse += vec3(0.25);\n");
    const Result<SnippetSet> set = readSnippets(m_folder);
    ASSERT_TRUE(set) << toString(set.error());
    const Composed lit = compose(permutation("sun1"), *set);
    EXPECT_NE(lit.fragment.text.find("  sum.diffuse += vec3(0.25);\n"), std::string::npos);
    EXPECT_EQ(lit.vertex.text, compose(permutation("sun1")).vertex.text);
    EXPECT_EQ(compose(permutation("sky"), *set).fragment.text, compose(permutation("sky")).fragment.text);
    EXPECT_EQ(compose(permutation("sun1")).fragment.text.find("0.25)"), std::string::npos);
}

TEST_F(SnippetSetTest, LinesNameTheirSnippetWhenTheSetIsGone) {
    ComposedStage stage;
    {
        const Result<SnippetSet> set = readSnippets(m_folder);
        ASSERT_TRUE(set);
        stage = compose(permutation("sun1"), *set).fragment;
    }
    const std::string text = annotateLog("0:" + std::to_string(stage.lines.size() - 1) + "(1): error", stage);
    EXPECT_NE(text.find("[" + (m_folder / "fragment/output/write_opaque.glsl:").string()), std::string::npos)
        << text;
}

TEST_F(SnippetSetTest, ComposesOnManyThreadsAtOnce) {
    const Result<SnippetSet> set = readSnippets(m_folder);
    ASSERT_TRUE(set);
    const std::string expected = compose(permutation("basecolor+sun2"), *set).fragment.text;
    std::vector<std::string> texts(8);
    {
        std::vector<std::jthread> threads;
        for (std::string& text : texts)
            threads.emplace_back([&text, snippets = *set] {
                text = compose(permutation("basecolor+sun2"), snippets).fragment.text;
            });
    }
    for (const std::string& text : texts)
        EXPECT_EQ(text, expected);
}

TEST_F(SnippetSetTest, WhatBreaksTheContractIsRefusedWithFileAndLine) {
    write("fragment/ambient/none.glsl", "// Dark.\n//! maine\n");
    EXPECT_EQ(failure().code, "snippet.syntax");
    EXPECT_EQ(failure().where, (m_folder / "fragment/ambient/none.glsl:2").string());
}

TEST_F(SnippetSetTest, AByteOrderMarkBelongsToNoSnippet) {
    write("fragment/ambient/none.glsl", "\xEF\xBB\xBF" + read("fragment/ambient/none.glsl"));
    const Result<SnippetSet> set = readSnippets(m_folder.string() + "/");
    ASSERT_TRUE(set) << toString(set.error());
    EXPECT_EQ(compose(permutation("sun1"), *set).fragment.text, compose(permutation("sun1")).fragment.text);
}

TEST_F(SnippetSetTest, WhatTheBuildCannotFeedIsRefused) {
    struct Row {
        const char *declaration, *name;
    };
    for (const Row& row :
         {Row{"uniform vec3 uNew; // frame: new", "uNew"},
          Row{"uniform vec4 uAmbient; // lights: another type", "uAmbient"},
          Row{"uniform vec3 uAmbient; // frame: another block", "uAmbient"},
          Row{"uniform vec3 uBaseColorCubic[9]; // material: longer", "uBaseColorCubic"},
          Row{"uniform sampler2D uNoise; // frame: new", "uNoise"}, Row{"attribute vec3 aWind;", "aWind"}}) {
        write("fragment/ambient/none.glsl",
              std::string("// Dark.\n//! declarations\n") + row.declaration + "\n");
        EXPECT_EQ(failure().code, "snippet.interface") << row.declaration;
        EXPECT_EQ(failure().where, (m_folder / "fragment/ambient/none.glsl:3").string()) << row.declaration;
        EXPECT_NE(failure().what.find(row.name), std::string::npos) << failure().what;
    }
}

TEST_F(SnippetSetTest, AFileThatIsMissingOrHugeOrEmptyIsRefused) {
    write("fragment/ambient/none.glsl", std::string(70000, ' '));
    EXPECT_EQ(failure().code, "snippet.file");
    write("fragment/ambient/none.glsl", "");
    EXPECT_EQ(failure().code, "snippet.file");
    fs::remove(m_folder / "fragment/ambient/none.glsl");
    fs::create_directory(m_folder / "fragment/ambient/none.glsl");
    EXPECT_EQ(failure().code, "snippet.file");
    fs::remove(m_folder / "fragment/ambient/none.glsl");
    ASSERT_EQ(mkfifo((m_folder / "fragment/ambient/none.glsl").c_str(), 0600), 0);
    EXPECT_EQ(failure().code, "snippet.file") << "a pipe is not waited for";
    fs::remove(m_folder / "fragment/ambient/none.glsl");
    EXPECT_EQ(failure().code, "snippet.file");
    EXPECT_EQ(failure().where, (m_folder / "fragment/ambient/none.glsl").string());
    EXPECT_EQ(readSnippets("no/such/folder").error().code, "snippet.file");
}

} // namespace
} // namespace franken
