// SPDX-License-Identifier: MIT
// The text of some programs, byte by byte. A golden is written by the target `update-goldens` alone, and
// then read by a person in the diff of the commit.
#include "franken/generator/choices.h"
#include "franken/generator/compose.h"
#include "franken/generator/covering.h"
#include "franken/generator/effect.h"
#include "population.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace franken {
namespace {

using namespace test;
namespace fs = std::filesystem;

struct Golden {
    std::string file, name;
    bool effect; ///< The name is of an effect, and without its hash.
};

const fs::path kGoldenFolder = FRANKEN_SOURCE_DIR "/tests/golden";

std::string trimmed(const std::string& text) {
    const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
    return text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

std::vector<Golden> readGoldens() {
    std::vector<Golden> goldens;
    for (const char* file : {"named.manifest", "effects.manifest"}) {
        std::ifstream manifest(kGoldenFolder / file);
        for (std::string line; std::getline(manifest, line);) {
            const std::size_t hash = line.find('#');
            if (hash != std::string::npos && hash > 0)
                goldens.push_back({trimmed(line.substr(hash + 1)), trimmed(line.substr(0, hash)),
                                   file == std::string_view("effects.manifest")});
        }
    }
    return goldens;
}

const SnippetSet& snippets() {
    static const SnippetSet all = [] {
        SnippetSet set = SnippetSet::builtIn();
        for (const char* file :
             {"examples/effects/fog.glsl", "examples/effects/rim.glsl", "tests/golden/effects/hooks.glsl"}) {
            const fs::path path = fs::path(FRANKEN_SOURCE_DIR) / file;
            std::ifstream stream(path, std::ios::binary);
            const std::string text{std::istreambuf_iterator<char>(stream), {}};
            set = *set.with(*Effect::parse(path.stem().string(), text, file));
        }
        return set;
    }();
    return all;
}

Permutation permutationOf(const Golden& golden) {
    return canonicalise(*parseName(golden.name, snippets()))->permutation;
}

Composed composed(const Golden& golden) { return compose(permutationOf(golden), snippets()); }

const std::vector<Golden>& goldens() {
    static const std::vector<Golden> all = readGoldens();
    return all;
}

const fs::path kFolder = kGoldenFolder / "text";
const std::string kHowTo = "\nrun 'cmake --build <build tree> --target update-goldens' and read the diff";

bool updating() { return std::getenv("FRANKEN_UPDATE_GOLDENS") != nullptr; }

std::string fileName(const Golden& golden, Stage stage) {
    return std::string(golden.file) + (stage == Stage::Vertex ? ".vert" : ".frag");
}

std::string firstDifference(const std::string& expected, const std::string& actual) {
    std::istringstream expectedLines(expected), actualLines(actual);
    std::string a, b;
    for (int line = 1;; ++line) {
        const bool more = !!std::getline(expectedLines, a);
        const bool moreToo = !!std::getline(actualLines, b);
        if (!more || !moreToo || a != b)
            return "first in line " + std::to_string(line) + ":\n-" + (more ? a : "(the end)") + "\n+" +
                   (moreToo ? b : "(the end)");
    }
}

void check(const fs::path& path, const std::string& text) {
    if (updating()) {
        std::ofstream(path, std::ios::binary) << text;
        return;
    }
    std::ifstream file(path, std::ios::binary);
    ASSERT_TRUE(file) << path << " is missing" << kHowTo;
    const std::string expected{std::istreambuf_iterator<char>(file), {}};
    EXPECT_TRUE(text == expected) << path << " differs, " << firstDifference(expected, text) << kHowTo;
}

TEST(Golden, TextsAreTheSameToTheByte) {
    for (const Golden& golden : goldens()) {
        const Composed program = composed(golden);
        check(kFolder / fileName(golden, Stage::Vertex), program.vertex.text);
        check(kFolder / fileName(golden, Stage::Fragment), program.fragment.text);
    }
}

// Its head and its main; what stands between is left out there.
TEST(Golden, TheReadmeShowsWhatIsComposed) {
    std::ifstream file(FRANKEN_SOURCE_DIR "/README.md", std::ios::binary);
    const std::string readme{std::istreambuf_iterator<char>(file), {}};
    const std::string text = compose(named("basecolor.normal+ambient+sun1")).fragment.text;
    const std::string head = text.substr(0, text.find("#ifdef"));
    const std::string expected = "```glsl\n" + head + "// (declarations and functions)\n\n" +
                                 text.substr(text.find("void main()")) + "```";
    EXPECT_NE(readme.find(expected), std::string::npos) << expected;
}

TEST(Golden, NoFileIsLeftOver) {
    std::set<std::string> expected;
    for (const Golden& golden : goldens()) {
        expected.insert(fileName(golden, Stage::Vertex));
        expected.insert(fileName(golden, Stage::Fragment));
    }
    EXPECT_EQ(expected.size(), 2 * goldens().size()) << "two goldens have one name";
    for (const auto& entry : fs::directory_iterator(kFolder))
        if (expected.count(entry.path().filename().string()) == 0) {
            if (updating())
                fs::remove(entry.path());
            else
                ADD_FAILURE() << entry.path() << " belongs to no golden" << kHowTo;
        }
}

TEST(Golden, NamesAreCanonical) {
    std::set<std::string_view> names;
    for (const Golden& golden : goldens()) {
        const std::string name = toName(permutationOf(golden), snippets());
        EXPECT_EQ(golden.effect ? name.substr(0, name.find('@')) : name, golden.name);
        EXPECT_TRUE(names.insert(golden.name).second) << golden.name << " stands twice";
    }
    EXPECT_GE(names.size(), 40u);
}

TEST(Golden, UseEverySnippet) {
    std::set<std::string> used;
    for (const Golden& golden : goldens()) {
        const Composed program = composed(golden);
        for (const ComposedStage* stage : {&program.vertex, &program.fragment})
            for (const LineOrigin& origin : stage->lines)
                used.insert(std::string(origin.snippet) + ".glsl");
    }
    const fs::path folder = FRANKEN_SOURCE_DIR "/generator/glsl";
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".glsl") {
            EXPECT_EQ(used.count(fs::relative(entry.path(), folder).generic_string()), 1u) << entry.path();
        }
}

// ... that any program shows: what changes no program today, covering_test.cpp prints.
TEST(Golden, UseEveryOption) {
    const std::vector<Permutation> programs = coveringSet();
    for (const Choice& choice : choices()) {
        std::set<unsigned> possible, used;
        for (const Permutation& p : programs)
            possible.insert(choice.get(p));
        for (const Golden& golden : goldens())
            used.insert(choice.get(permutationOf(golden)));
        for (const unsigned value : possible)
            EXPECT_EQ(used.count(value), 1u) << choice.options[value].word;
    }
}

} // namespace
} // namespace franken
