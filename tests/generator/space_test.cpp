// SPDX-License-Identifier: MIT
#include "franken/generator/choices.h"
#include "franken/generator/space.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace franken;

namespace {

Space spaceWith(const std::vector<std::string_view>& words) {
    Space space;
    for (const std::string_view word : words)
        EXPECT_TRUE(space.require(word)) << word;
    return space;
}

std::vector<Key> keysOf(const Space& space, std::size_t limit = 1000000) {
    std::vector<Key> keys;
    space.forEachCanonical([&](const Permutation& permutation) {
        keys.push_back(toKey(permutation));
        return keys.size() < limit;
    });
    return keys;
}

std::size_t wordCount(const Permutation& permutation) {
    std::size_t count = 0;
    for (const Choice& choice : choices())
        count += choice.get(permutation) != 0 ? 1 : 0;
    return count;
}

TEST(Space, ProductIsThatOfTheChoices) {
    std::uint64_t product = 1;
    for (const Choice& choice : choices())
        product *= choice.options.size();
    EXPECT_EQ(Space().product(), product);
    EXPECT_EQ(spaceWith({"sun2"}).product(), product / 5);
    Space space;
    EXPECT_TRUE(space.forbid("sun2"));
    EXPECT_EQ(space.product(), product / 5 * 4);
    EXPECT_TRUE(space.contains(Permutation{}));
    EXPECT_FALSE(spaceWith({"sun2"}).contains(Permutation{}));
}

TEST(Space, RefusesWhatIsNoWordOrLeavesNothing) {
    EXPECT_EQ(Space().require("nromal").error().code, "permutation.unknown-word");
    EXPECT_EQ(Space().require("normal+sun1").error().code, "space.word");
    EXPECT_EQ(spaceWith({"sun1"}).require("sun2").error().code, "space.empty");
    EXPECT_EQ(spaceWith({"sun1"}).forbid("sun1").error().code, "space.empty");
}

TEST(Space, ListsCanonicalPermutationsOnceShortNamesFirst) {
    std::set<Key> seen;
    std::size_t words = 0;
    Space().forEachCanonical([&](const Permutation& permutation) {
        EXPECT_TRUE(seen.insert(toKey(permutation)).second) << toName(permutation);
        const auto canonical = canonicalise(permutation);
        EXPECT_TRUE(canonical && canonical->permutation == permutation) << toName(permutation);
        EXPECT_GE(wordCount(permutation), words);
        words = wordCount(permutation);
        return seen.size() < 5000;
    });
    EXPECT_EQ(seen.size(), 5000U);
}

TEST(Space, TheSameEachTime) { EXPECT_EQ(keysOf(Space(), 3000), keysOf(Space(), 3000)); }

TEST(Space, ASmallSpaceComesToItsEnd) {
    // 4 tone maps, 4 outputs, dithered or not, for 32 bits or 16.
    EXPECT_EQ(keysOf(spaceWith({"sky"})).size(), 64U);
    EXPECT_TRUE(keysOf(spaceWith({"sky", "normal"})).empty()) << "the sky has no normal map";
}

// What canonicalising makes of random permutations must be in the list; a list that is too short misses some.
TEST(Space, NothingIsMissing) {
    std::size_t looked = 0;
    for (const std::string_view word :
         {"sky", "overlay", "unlit", "view-basecolor", "view-normal", "view-metalrough", "view-occlusion"}) {
        const Space space = spaceWith({word});
        const std::vector<Key> keys = keysOf(space);
        const std::set<Key> listed(keys.begin(), keys.end());
        std::mt19937 random(7);
        for (int i = 0; i < 20000; ++i) {
            Permutation permutation;
            for (const Choice& choice : choices())
                choice.set(permutation, static_cast<unsigned>(random() % choice.options.size()));
            const auto narrowed = parseName(word);
            for (const Choice& choice : choices())
                if (choice.get(*narrowed) != 0)
                    choice.set(permutation, choice.get(*narrowed));
            const auto canonical = canonicalise(permutation);
            if (!canonical || !space.contains(canonical->permutation))
                continue;
            ++looked;
            EXPECT_TRUE(listed.count(toKey(canonical->permutation))) << toName(canonical->permutation);
        }
    }
    EXPECT_GT(looked, 1000U);
    RecordProperty("looked", static_cast<int>(looked));
}

// The lit space is too large to list to its end: names of up to three words are looked for in it.
TEST(Space, NoShortNameIsMissing) {
    std::set<Key> listed;
    Space().forEachCanonical([&](const Permutation& permutation) {
        listed.insert(toKey(permutation));
        return wordCount(permutation) <= 3;
    });
    std::mt19937 random(11);
    std::size_t looked = 0;
    for (int i = 0; i < 200000; ++i) {
        Permutation permutation;
        for (int word = 0; word < 3; ++word) {
            const Choice& choice = choices()[random() % choices().size()];
            choice.set(permutation, static_cast<unsigned>(random() % choice.options.size()));
        }
        const auto canonical = canonicalise(permutation);
        if (!canonical)
            continue;
        ++looked;
        EXPECT_TRUE(listed.count(toKey(canonical->permutation))) << toName(canonical->permutation);
    }
    EXPECT_GT(looked, 10000U);
}

} // namespace
