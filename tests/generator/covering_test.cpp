// SPDX-License-Identifier: MIT
// Looks for combinations of three options that the covering set has missed.
#include "franken/generator/choices.h"
#include "franken/generator/covering.h"
#include "population.h"

#include <gtest/gtest.h>

#include <iostream>
#include <set>
#include <unordered_set>

namespace franken {
namespace {

using namespace test;

// The numbers of three options, counted over all choices, in one.
using Triple = std::size_t;
constexpr std::size_t kMaxOptions = 128;

std::string_view wordOf(std::size_t option) {
    for (const Choice& choice : choices()) {
        if (option < choice.options.size())
            return choice.options[option].word;
        option -= choice.options.size();
    }
    return "?";
}

std::string wordsOf(Triple triple) {
    std::string words(wordOf(triple / kMaxOptions / kMaxOptions));
    words.append(", ").append(wordOf(triple / kMaxOptions % kMaxOptions));
    return words.append(", ").append(wordOf(triple % kMaxOptions));
}

template<typename Visit>
void forEachTriple(const Permutation& permutation, Visit visit) {
    std::vector<std::size_t> options;
    std::size_t first = 0;
    for (const Choice& choice : choices()) {
        options.push_back(first + choice.get(permutation));
        first += choice.options.size();
    }
    ASSERT_LE(first, kMaxOptions);
    for (auto a = options.begin(); a != options.end(); ++a)
        for (auto b = a + 1; b != options.end(); ++b)
            for (auto c = b + 1; c != options.end(); ++c)
                visit((*a * kMaxOptions + *b) * kMaxOptions + *c);
}

class Covering : public testing::Test {
protected:
    static void SetUpTestSuite() {
        s_set = coveringSet();
        for (const Permutation& permutation : s_set)
            forEachTriple(permutation, [](const Triple& triple) { s_covered.insert(triple); });
    }

    static void expectCovered(const Permutation& permutation) {
        forEachTriple(permutation, [&](const Triple& triple) {
            if (s_covered.count(triple) == 0 && s_missed.insert(triple).second) {
                ADD_FAILURE() << wordsOf(triple) << " of " << toName(permutation);
            }
        });
    }

    static inline std::vector<Permutation> s_set;
    static inline std::unordered_set<Triple> s_covered, s_missed;
};

TEST_F(Covering, IsCanonicalWithoutDuplicates) {
    std::set<Key> keys;
    for (const Permutation& permutation : s_set) {
        EXPECT_EQ(canonical(permutation), permutation) << toName(permutation);
        EXPECT_TRUE(keys.insert(toKey(permutation)).second) << toName(permutation);
    }
    std::cout << s_set.size() << " permutations cover " << s_covered.size() << " triples\n";
}

TEST_F(Covering, IsTheSameEachTime) { EXPECT_EQ(coveringSet(), s_set); }

TEST_F(Covering, HoldsTheTriplesOfRandomPermutations) {
    for (const Permutation& permutation : randomPermutations(3000, 7))
        expectCovered(canonical(permutation));
}

TEST_F(Covering, HoldsTheTriplesOfItsNeighbours) {
    std::set<Key> seen;
    for (const Permutation& permutation : s_set)
        for (const Permutation& flipped : singleFlips(permutation))
            if (const Permutation neighbour = canonical(flipped); seen.insert(toKey(neighbour)).second)
                expectCovered(neighbour);
    std::cout << seen.size() << " neighbours\n";
}

// What stands in no canonical permutation changes no program: worth knowing.
TEST_F(Covering, HoldsEveryChoice) {
    for (const Choice& choice : choices()) {
        std::set<unsigned> values;
        for (const Permutation& permutation : s_set)
            values.insert(choice.get(permutation));
        EXPECT_GT(values.size(), 1u) << choice.name << " changes no program";
        for (unsigned value = 0; value < choice.options.size(); ++value)
            if (values.count(value) == 0)
                std::cout << "'" << choice.options[value].word << "' changes no program today\n";
    }
}

} // namespace
} // namespace franken
