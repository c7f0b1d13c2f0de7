// SPDX-License-Identifier: MIT
// Where each value of each choice must stand, besides the enum: a place that was forgotten is named
// (CONTRIBUTING.md, "Add a value of a choice").
#include "franken/generator/choices.h"
#include "franken/generator/manifest.h"
#include "population.h"
#include "support/shell.h"

#include <set>

namespace franken::test {
namespace {

template<typename Visit>
void forEachValue(Visit visit) {
    for (const Choice& choice : choices())
        for (unsigned value = 0; value < choice.options.size(); ++value)
            visit(choice, value, std::string(choice.options[value].word));
}

TEST(Places, EachValueIsInTheReadmesTable) {
    const std::string readme = readText(FRANKEN_SOURCE_DIR "/README.md");
    const std::size_t begin = readme.find("## The choices"), end = readme.find("\n## ", begin + 1);
    ASSERT_NE(begin, std::string::npos);
    const std::string table = readme.substr(begin, end - begin);
    forEachValue([&](const Choice& choice, unsigned value, const std::string& word) {
        const bool counted = word.find_first_of("0123456789") == word.size() - 1; // "sun1" to "sun4".
        const bool isDefault = value == 0 && choice.options.size() == 2; // A thing that is not there.
        if (!counted && !isDefault) {
            EXPECT_NE(table.find("`" + word + "`"), std::string::npos)
                << "README.md, The choices: '" << word << "' is missing";
        }
    });
}

TEST(Places, EachValueHasAGolden) {
    const std::string manifest = readText(FRANKEN_SOURCE_DIR "/tests/golden/named.manifest");
    std::set<std::pair<std::string_view, unsigned>> shown;
    for (const ManifestLine& line : manifestLines(manifest))
        for (const Choice& choice : choices())
            shown.insert({choice.name, choice.get(named(line.name))});
    forEachValue([&](const Choice& choice, unsigned value, const std::string& word) {
        const bool isAnother = word == "view-basecolor"; // 'unlit' stands for it.
        if (!isAnother) {
            EXPECT_TRUE(shown.count({choice.name, value}))
                << "tests/golden/named.manifest: no permutation has '" << word << "'";
        }
    });
}

TEST(Places, EachValueChangesAText) {
    std::set<std::pair<std::string_view, unsigned>> alive;
    for (const Permutation& permutation : population())
        for (const Choice& choice : choices())
            alive.insert({choice.name, choice.get(permutation)});
    forEachValue([&](const Choice& choice, unsigned value, const std::string& word) {
        if (word != "view-basecolor") {
            EXPECT_TRUE(alive.count({choice.name, value}))
                << "recipe.cpp: no form of any slot asks for '" << word << "', so that it is always dropped";
        }
    });
}

TEST(Places, EachValueSaysWhatItMeans) {
    std::set<std::string_view> meanings;
    forEachValue([&](const Choice& choice, unsigned value, const std::string& word) {
        EXPECT_FALSE(choice.options[value].meaning.empty()) << "choices.cpp: '" << word << "' has no meaning";
        EXPECT_TRUE(meanings.insert(choice.options[value].meaning).second)
            << "choices.cpp: '" << word << "' means what another word means";
    });
}

} // namespace
} // namespace franken::test
