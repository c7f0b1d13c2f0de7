// SPDX-License-Identifier: MIT
// The cache of programs: what it compiles, shares, keeps, forgets and remembers as failed.
#include "franken/key_table.h"
#include "franken/program_cache.h"
#include "support/offscreen.h"

#include <thread>

namespace franken::test {
namespace {

using ProgramCacheTest = OffscreenTest;

INSTANTIATE_TEST_SUITE_P(Backends, ProgramCacheTest, allBackends(), backendName);

Permutation named(std::string_view name) { return canonicalise(*parseName(name))->permutation; }

ProgramHandle make(ProgramCache& cache, std::string_view name) {
    Result<ProgramHandle> program = cache.get(named(name));
    EXPECT_TRUE(program) << toString(program.error());
    return program ? *program : nullptr;
}

TEST_P(ProgramCacheTest, ASecondLookUpIsAHit) {
    ProgramCache cache(gl());
    const ProgramHandle first = make(cache, "surface+sun1");
    EXPECT_EQ(make(cache, "surface+sun1"), first);
    EXPECT_EQ(cache.find(toKey(named("surface+sun1"))), first);
    EXPECT_EQ(cache.find(toKey(named("surface+sun2"))), nullptr);
    EXPECT_EQ(cache.counters().compiles, 2u);
    EXPECT_EQ(cache.counters().links, 1u);
    EXPECT_EQ(cache.counters().hits, 2u);
    EXPECT_GT(cache.counters().milliseconds, 0);
}

TEST_P(ProgramCacheTest, ShadersAreSharedByTheirStage) {
    ProgramCache cache(gl());
    make(cache, "surface+sun1");
    make(cache, "surface+sun1+aces");
    EXPECT_EQ(cache.counters().compiles, 3u) << "one vertex shader, two fragment shaders";
    EXPECT_EQ(cache.counters().links, 2u);
}

TEST_P(ProgramCacheTest, WhatBeganIsFinishedByGet) {
    ProgramCache cache(gl(), {.parallelCompile = true});
    cache.compileInBackground(named("surface+sun1"));
    cache.compileInBackground(named("surface+sun1"));
    EXPECT_EQ(cache.counters().links, 1u);
    EXPECT_EQ(cache.find(toKey(named("surface+sun1"))), nullptr);
    while (cache.pending(named("surface+sun1")))
        std::this_thread::yield();
    EXPECT_NE(make(cache, "surface+sun1"), nullptr);
    EXPECT_EQ(cache.counters().links, 1u);
    EXPECT_EQ(gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_P(ProgramCacheTest, TheLeastRecentlyUsedMakesRoom) {
    ProgramCache cache(gl(), {.capacity = 2});
    make(cache, "sun1");
    make(cache, "sun1+aces");
    make(cache, "sun1");
    make(cache, "sun1+neutral");
    EXPECT_EQ(cache.counters().evictions, 1u);
    EXPECT_EQ(cache.size(), 2u);
    EXPECT_NE(cache.find(toKey(named("sun1"))), nullptr);
    EXPECT_EQ(cache.find(toKey(named("sun1+aces"))), nullptr);
    const unsigned compiles = cache.counters().compiles;
    make(cache, "sun1+aces");
    EXPECT_EQ(cache.counters().compiles, compiles + 1)
        << "its fragment shader went with it, the vertex shader is shared";
}

TEST_P(ProgramCacheTest, WhatIsHeldIsNotEvicted) {
    std::vector<std::string> messages;
    ProgramCache cache(gl(), {.capacity = 1, .log = [&](LogLevel, std::string_view message) {
                                  messages.emplace_back(message);
                              }});
    ProgramHandle held = make(cache, "surface+sun1");
    const ProgramHandle other = make(cache, "surface+sun2");
    const ProgramHandle third = make(cache, "surface+sun3");
    EXPECT_EQ(cache.size(), 3u) << "in use, all of them";
    EXPECT_EQ(messages.size(), 1u) << "said once";
    EXPECT_TRUE(gl().IsProgram(held->name()));
    const GLuint name = held->name();
    held = nullptr;
    make(cache, "surface+sun4");
    EXPECT_FALSE(gl().IsProgram(name));
    EXPECT_EQ(cache.find(toKey(named("surface+sun1"))), nullptr);
}

TEST_P(ProgramCacheTest, ARejectedProgramFailsFromThenOn) {
    ProgramCache cache(gl());
    const ProgramHandle held = make(cache, "surface+sun1");
    EXPECT_EQ(cache.failure(named("surface+sun1")), nullptr);
    cache.reject(named("surface+sun1"), {"program.draw", "", "it draws nothing", ""});
    const Result<ProgramHandle> again = cache.get(named("surface+sun1"));
    ASSERT_FALSE(again);
    EXPECT_EQ(again.error().code, "program.draw");
    ASSERT_NE(cache.failure(named("surface+sun1")), nullptr);
    EXPECT_TRUE(gl().IsProgram(held->name())) << "whoever holds it may go on";
    EXPECT_EQ(cache.counters().failures, 1u);
    EXPECT_EQ(cache.size(), 0u);
}

TEST_P(ProgramCacheTest, AnAbandonedCacheDeletesNothing) {
    static int deleted;
    deleted = 0;
    Gl counting = gl();
    counting.DeleteProgram = [](GLuint) { ++deleted; };
    counting.DeleteShader = [](GLuint) { ++deleted; };
    {
        ProgramCache cache(counting);
        const ProgramHandle held = make(cache, "surface+sun1");
        cache.compileInBackground(named("surface+sun2"));
        cache.lost();
        EXPECT_EQ(held->name(), 0u);
        EXPECT_EQ(cache.size(), 0u);
    }
    EXPECT_EQ(deleted, 0);
}

TEST_P(ProgramCacheTest, ThousandsOfKeysAreToldApart) {
    KeyTable table;
    std::vector<Key> keys;
    for (const char* name : {"surface", "sky", "overlay"})
        for (unsigned bits = 0; bits < 1024; ++bits)
            for (const unsigned word : {0u, 1u}) {
                keys.push_back(toKey(named(name)));
                keys.back().words[word] ^= std::uint64_t{bits} << 22;
            }
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (table.find(keys[i]) == KeyTable::kAbsent)
            table.insert(keys[i], static_cast<std::uint32_t>(i));
    for (const Key& key : keys)
        EXPECT_EQ(keys[table.find(key)], key);
    Key other = keys[0];
    other.words[0] ^= std::uint64_t{1} << 40;
    EXPECT_EQ(table.find(other), KeyTable::kAbsent);
}

#ifndef NDEBUG
TEST_P(ProgramCacheTest, AnotherThreadIsABug) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    ProgramCache cache(gl());
    EXPECT_DEATH(std::thread([&] { cache.find(toKey(Permutation{})); }).join(), "outside the thread");
}
#endif

TEST_P(ProgramCacheTest, TextsAreComposedInAnyThreadAtATime) {
    const Permutation permutation = named("basecolor.normal.metalrough+sh+sun2+punctual2+spots+aces");
    const std::string expected = compose(permutation).fragment.text;
    std::vector<std::string> texts(4);
    std::vector<std::thread> threads;
    for (std::string& text : texts)
        threads.emplace_back([&text, &permutation] {
            for (int i = 0; i < 50; ++i)
                text = compose(permutation).fragment.text;
        });
    ProgramCache cache(gl());
    make(cache, "basecolor.normal.metalrough+sh+sun2");
    for (std::thread& thread : threads)
        thread.join();
    for (const std::string& text : texts)
        EXPECT_EQ(text, expected);
}

} // namespace
} // namespace franken::test
