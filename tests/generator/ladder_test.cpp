// SPDX-License-Identifier: MIT
// The way down from every permutation: short, simpler at each rung, and to a program that nothing refuses.
#include "franken/generator/compose.h"
#include "franken/generator/ladder.h"
#include "population.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace franken::test {
namespace {

std::vector<Permutation> rungsBelow(const Permutation& permutation) {
    std::vector<Permutation> rungs;
    for (auto rung = simpler(permutation); rung && rungs.size() < 100; rung = simpler(*rung))
        rungs.push_back(*rung);
    return rungs;
}

std::vector<std::string> namesOf(const Permutation& permutation) {
    std::vector<std::string> names;
    for (const Permutation& rung : rungsBelow(permutation))
        names.push_back(toName(rung));
    return names;
}

TEST(Ladder, EveryRungIsCanonicalAndNew) {
    for (const Permutation& permutation : population()) {
        std::vector<Permutation> rungs = rungsBelow(permutation);
        EXPECT_LE(rungs.size(), 11u) << toName(permutation);
        for (const Permutation& rung : rungs) {
            EXPECT_EQ(canonical(rung), rung) << toName(rung);
            if (rung.program == Program::Surface && permutation.view == View::Shaded) {
                EXPECT_EQ(rung.output, permutation.output) << toName(rung);
            }
        }
        rungs.push_back(permutation);
        std::sort(rungs.begin(), rungs.end(),
                  [](const Permutation& a, const Permutation& b) { return toKey(a) < toKey(b); });
        EXPECT_EQ(std::adjacent_find(rungs.begin(), rungs.end()), rungs.end()) << toName(permutation);
    }
}

template<typename Part>
bool isAmong(const std::vector<Part>& few, const std::vector<Part>& many) {
    return std::all_of(few.begin(), few.end(), [&](const Part& part) {
        return std::any_of(many.begin(), many.end(),
                           [&](const Part& other) { return other.name == part.name; });
    });
}

TEST(Ladder, ARungReadsNoAttributeAndNoTextureThatTheOneAboveDoesNot) {
    for (const Permutation& permutation : population()) {
        Interface above = compose(permutation).interface;
        for (const Permutation& rung : rungsBelow(permutation)) {
            Interface below = compose(rung).interface;
            EXPECT_TRUE(isAmong(below.attributes, above.attributes)) << toName(rung);
            EXPECT_TRUE(isAmong(below.samplers, above.samplers)) << toName(rung);
            above = std::move(below);
        }
    }
}

TEST(Ladder, ASurfaceEndsAtOneColour) {
    for (const Permutation& permutation : population()) {
        if (permutation.program != Program::Surface)
            continue;
        const std::vector<Permutation> rungs = rungsBelow(permutation);
        const Interface last = compose(rungs.empty() ? permutation : rungs.back()).interface;
        EXPECT_EQ(last.attributes.size(), 1u) << toName(permutation);
        EXPECT_TRUE(last.samplers.empty()) << toName(permutation);
        EXPECT_TRUE(last.varyings.empty()) << toName(permutation);
    }
}

TEST(Ladder, GivesUpWhatIsSeenLeastFirst) {
    const std::vector<std::string> expected = {
        "basecolor.metalrough.normal.occlusion-packed.emissive+sh+reflection+sun4+punctual1+aces+dither",
        "basecolor.metalrough.normal.occlusion-packed.emissive+sh+reflection+sun4+punctual1+aces",
        "basecolor.metalrough.normal.occlusion-packed.emissive+sh+reflection+sun2+punctual1+aces",
        "basecolor.metalrough.normal.occlusion-packed.emissive+sh+reflection+sun1+aces",
        "basecolor.metalrough.normal.occlusion-packed.emissive+sh+sun1+aces",
        "basecolor.metalrough.emissive+sh+sun1+aces",
        "basecolor.emissive-factor+sh+sun1+aces",
        "basecolor.unlit",
        "unlit"};
    EXPECT_EQ(
        namesOf(named("basecolor.metalrough.normal.occlusion-packed.emissive+sh+reflection+sun4+punctual1+"
                      "aces+dither+vc4")),
        expected);
}

TEST(Ladder, KeepsAPunctualLightWhereThereIsNoSun) {
    EXPECT_EQ(namesOf(named("surface+punctual3+spots")),
              (std::vector<std::string>{"punctual2+spots", "punctual1+spots", "unlit"}));
}

TEST(Ladder, KeepsStreamsThatAreStillRead) {
    EXPECT_EQ(
        namesOf(named("basecolor.normal.normal-uv1.uv0-transform.uv1-transform+sun1")),
        (std::vector<std::string>{"basecolor.uv0-transform+sun1", "basecolor.uv0-transform.unlit", "unlit"}));
}

// The picture stays the same where the CPU moves the vertices, so that this is given up before all else.
TEST(Ladder, LeavesVerticesToTheCpuFirst) {
    EXPECT_EQ(namesOf(named("basecolor.skin3.joints64+ambient+sun1+dither")),
              (std::vector<std::string>{"basecolor+ambient+sun1+dither", "basecolor+ambient+sun1",
                                        "basecolor.unlit", "unlit"}));
    EXPECT_EQ(namesOf(named("unlit.skin4")), (std::vector<std::string>{"unlit"}));
}

TEST(Ladder, ASkyAndAnOverlayHaveAWayDownToo) {
    EXPECT_EQ(namesOf(named("sky+aces+dither")), (std::vector<std::string>{"sky+aces", "sky"}));
    EXPECT_EQ(namesOf(named("overlay")), (std::vector<std::string>{}));
}

} // namespace
} // namespace franken::test
