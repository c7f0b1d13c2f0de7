// SPDX-License-Identifier: MIT
// What must hold for every permutation, asked of some thousands of them.
#include "franken/generator/choices.h"
#include "franken/generator/compose.h"
#include "franken/generator/covering.h"
#include "population.h"

#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <set>
#include <thread>

namespace franken {
namespace {

using namespace test;

std::string wholeText(const Permutation& permutation) {
    const Composed program = compose(permutation);
    return withoutComments(program.vertex.text) + withoutComments(program.fragment.text);
}

const std::string& stageText(const Composed& program, Stage stage) {
    return stage == Stage::Vertex ? program.vertex.text : program.fragment.text;
}

// Remembers texts and keys, and complains where one of them has changed and the other has not.
class TextsAndKeys {
public:
    const std::string& textOf(const Permutation& canonicalPermutation) {
        const Key key = toKey(canonicalPermutation);
        const auto [entry, isNew] = m_texts.try_emplace(key);
        if (!isNew)
            return entry->second;
        entry->second = wholeText(canonicalPermutation);
        const auto [owner, first] = m_owners.try_emplace(entry->second, key);
        EXPECT_TRUE(first) << "two keys, one text: " << toName(canonicalPermutation) << " and "
                           << toName(*fromKey(owner->second));
        return entry->second;
    }
    std::size_t size() const { return m_texts.size(); }

private:
    std::map<Key, std::string> m_texts;
    std::map<std::string, Key> m_owners;
};

TEST(Population, NamesAndKeysComeBack) {
    std::vector<Permutation> all = randomPermutations(2000, 3);
    all.insert(all.end(), population().begin(), population().end());
    for (const Permutation& p : all) {
        const auto byKey = fromKey(toKey(p));
        ASSERT_TRUE(byKey) << toString(byKey.error());
        EXPECT_EQ(*byKey, p) << toName(p);
        const auto byName = parseName(toName(p));
        ASSERT_TRUE(byName) << toString(byName.error());
        EXPECT_EQ(*byName, p) << toName(p);
    }
}

TEST(Population, CanonicalIsIdempotent) {
    for (const Permutation& raw : randomPermutations(2000, 4)) {
        const auto once = canonicalise(raw);
        ASSERT_TRUE(once) << toName(raw);
        const auto twice = canonicalise(once->permutation);
        ASSERT_TRUE(twice) << toName(raw) << " becomes the contradictory " << toName(once->permutation);
        EXPECT_EQ(twice->permutation, once->permutation) << toName(raw);
        EXPECT_TRUE(twice->dropped.empty()) << toName(raw);
    }
}

TEST(Population, CanonicalSaysAllThatItDropped) {
    for (const Permutation& raw : randomPermutations(500, 5)) {
        const Canonical result = *canonicalise(raw);
        std::size_t changed = 0;
        for (const Choice& choice : choices())
            changed += choice.get(raw) != 0 && choice.get(raw) != choice.get(result.permutation);
        EXPECT_EQ(result.dropped.size(), changed) << toName(raw);
    }
}

TEST(Population, DroppedChoicesLeaveTheTextAlone) {
    for (const Permutation& raw : randomPermutations(1000, 6))
        EXPECT_EQ(wholeText(raw), wholeText(canonical(raw))) << toName(raw);
}

TEST(Population, EqualTextIsEqualKey) {
    TextsAndKeys texts;
    for (const Permutation& p : population())
        texts.textOf(p);
    EXPECT_EQ(texts.size(), population().size());
}

TEST(Population, EachFlipChangesTextAndKeyTogether) {
    TextsAndKeys texts;
    std::map<std::string_view, std::size_t> flipsThatMatter;
    std::vector<Permutation> bases = coveringSet();
    bases.push_back(richSurface());
    for (const Permutation& base : bases)
        for (const Choice& choice : choices())
            for (unsigned value = 0; value < choice.options.size(); ++value) {
                Permutation flipped = base;
                choice.set(flipped, value);
                const auto result = canonicalise(flipped);
                if (flipped == base || !result)
                    continue;
                const bool otherKey = toKey(result->permutation) != toKey(base);
                EXPECT_EQ(otherKey, texts.textOf(result->permutation) != texts.textOf(base))
                    << toName(base) << " with " << choice.options[value].word;
                flipsThatMatter[choice.name] += otherKey;
            }
    for (const Choice& choice : choices())
        EXPECT_GT(flipsThatMatter[choice.name], 0u) << choice.name << " changes no program";
    std::cout << texts.size() << " programs seen by flipping single choices\n";
}

TEST(Population, EqualStageKeyIsEqualStageText) {
    for (const Stage stage : {Stage::Vertex, Stage::Fragment}) {
        std::map<Key, std::string> texts;
        for (const Permutation& p : population()) {
            const std::string text = stageText(compose(p), stage);
            EXPECT_EQ(texts.try_emplace(stageKey(p, stage), text).first->second, text) << toName(p);
        }
        std::cout << texts.size() << (stage == Stage::Vertex ? " vertex" : " fragment") << " shaders in "
                  << population().size() << " programs\n";
    }
}

TEST(Population, NoTwoVertexShadersAreTheSame) {
    std::map<std::string, Key> keys;
    for (const Permutation& p : population()) {
        const Key key = stageKey(p, Stage::Vertex);
        EXPECT_EQ(keys.try_emplace(withoutComments(compose(p).vertex.text), key).first->second, key)
            << toName(p);
    }
}

TEST(Population, TheEndOfTheFragmentShaderIsNoBusinessOfTheVertexShader) {
    for (const Permutation& base : population())
        for (const Choice& choice : choices()) {
            if (choice.name != "output" && choice.name != "toneMap" && choice.name != "dither" &&
                choice.name != "brdf" && choice.name != "energy")
                continue;
            Permutation other = base;
            choice.set(other, (choice.get(base) + 1) % static_cast<unsigned>(choice.options.size()));
            if (other.energy && other.brdf == Brdf::Seed) // They contradict each other.
                continue;
            other = canonical(other);
            EXPECT_EQ(compose(other).vertex.text, compose(base).vertex.text)
                << toName(base) << " against " << toName(other);
            EXPECT_EQ(stageKey(other, Stage::Vertex), stageKey(base, Stage::Vertex)) << toName(base);
        }
}

TEST(Population, EightThreadsComposeTheSameBytes) {
    const std::vector<Permutation>& all = population();
    constexpr std::size_t kThreads = 8;
    std::vector<std::vector<std::string>> texts(kThreads, std::vector<std::string>(all.size()));
    std::vector<std::thread> threads;
    for (std::size_t thread = 0; thread < kThreads; ++thread)
        threads.emplace_back([&, thread] {
            for (std::size_t i = 0; i < all.size(); ++i) {
                const std::size_t at = (i + thread * all.size() / kThreads) % all.size();
                const Composed program = compose(all[at]);
                texts[thread][at] = program.vertex.text + program.fragment.text;
            }
        });
    for (std::thread& thread : threads)
        thread.join();
    for (const auto& others : texts)
        EXPECT_EQ(others, texts.front());
}

} // namespace
} // namespace franken
