// SPDX-License-Identifier: MIT
// After a warm-up a run compiles nothing, by the library's own count. What Mesa's drivers for the Pi compile
// by theirs is counted in tests/qpu.
#include "support/draw_scene.h"
#include "support/gl_recorder.h"
#include "support/kiosk_frames.h"
#include "support/shapes.h"

#include <map>
#include <numeric>
#include <set>
#include <thread>

namespace franken::test {
namespace {

class WarmUpTest : public PictureTest {
protected:
    DrawTarget target() { return {surface().framebuffer(), 64, 64}; }
};

INSTANTIATE_TEST_SUITE_P(Backends, WarmUpTest, allBackends(), backendName);

TEST_P(WarmUpTest, AThousandFramesCompileNothing) {
    KioskFrames kiosk;
    Renderer renderer(gl());
    ASSERT_TRUE(kiosk.load(renderer));
    const std::vector<ProgramUse> uses = kiosk.uses();
    const Result<WarmUpReport> report = renderer.warmUp(target(), uses);
    ASSERT_TRUE(report);
    EXPECT_EQ(report->failed, 0u);
    EXPECT_GE(report->programs, 30u);
    EXPECT_GE(report->draws, report->programs);
    const ProgramCounters before = renderer.programCounters();
    EXPECT_GT(before.compiles, 0u);
    const std::vector<DrawTarget> targets = {
        target(), {surface().framebuffer(), 40, 30}, {surface().framebuffer(), 17, 64}};
    for (int frame = 0; frame < 1000; ++frame) {
        const Result<void> drawn = kiosk.draw(renderer, frame, targets);
        ASSERT_TRUE(drawn) << "frame " << frame << ": " << toString(drawn.error());
    }
    const ProgramCounters after = renderer.programCounters();
    EXPECT_EQ(after.compiles, before.compiles);
    EXPECT_EQ(after.links, before.links);
    EXPECT_EQ(after.evictions, 0u);
    EXPECT_GT(after.hits, before.hits);
    EXPECT_TRUE(renderer.takeMisses().empty());
    EXPECT_EQ(gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
    std::cout << report->programs << " programs from " << before.compiles << " shaders, " << report->draws
              << " draws, in " << report->milliseconds << " ms\n";
}

TEST_P(WarmUpTest, WhatWasMissedIsKnownOnceAndWarmsUpTheNextRun) {
    KioskFrames kiosk;
    std::vector<ProgramUse> misses;
    {
        Renderer renderer(gl());
        ASSERT_TRUE(kiosk.load(renderer));
        for (int frame = 0; frame < 210; ++frame)
            ASSERT_TRUE(kiosk.draw(renderer, frame, {target()}));
        misses = renderer.takeMisses();
        EXPECT_FALSE(misses.empty());
        EXPECT_TRUE(renderer.takeMisses().empty());
    }
    KioskFrames again;
    Renderer renderer(gl());
    ASSERT_TRUE(again.load(renderer));
    ASSERT_TRUE(renderer.warmUp(target(), misses));
    const unsigned links = renderer.programCounters().links;
    for (int frame = 0; frame < 210; ++frame)
        ASSERT_TRUE(again.draw(renderer, frame, {target()}));
    EXPECT_EQ(renderer.programCounters().links, links);
    EXPECT_TRUE(renderer.takeMisses().empty());
}

TEST_P(WarmUpTest, ProgressCountsUpToTheTotal) {
    KioskFrames kiosk;
    Renderer renderer(gl());
    ASSERT_TRUE(kiosk.load(renderer));
    std::vector<std::size_t> seen;
    std::size_t last = 0;
    unsigned compiledAtFirst = 0;
    ASSERT_TRUE(renderer.warmUp(target(), kiosk.uses(), [&](std::size_t done, std::size_t total) {
        if (seen.empty())
            compiledAtFirst = renderer.programCounters().compiles;
        seen.push_back(done);
        last = total;
    }));
    std::vector<std::size_t> expected(seen.size());
    std::iota(expected.begin(), expected.end(), std::size_t{1});
    EXPECT_EQ(seen, expected);
    EXPECT_EQ(seen.size(), last);
    EXPECT_LE(compiledAtFirst, 2u) << "it begins with the first program, not when all have been compiled";
    EXPECT_GT(renderer.programCounters().compiles, 30u);
}

std::vector<bool> silhouetteOf(const Picture& picture) {
    std::vector<bool> covered;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
        covered.push_back(picture.rgba[i] + picture.rgba[i + 1] + picture.rgba[i + 2] > 0);
    return covered;
}

TEST_P(WarmUpTest, OverTheBudgetASimplerProgramStandsIn) {
    KioskFrames kiosk;
    const std::vector<DrawTarget> targets = {target()};
    Renderer renderer(gl());
    ASSERT_TRUE(kiosk.load(renderer));
    ASSERT_TRUE(kiosk.draw(renderer, 0, targets));
    const Picture wanted = readBack();

    KioskFrames streaming;
    Renderer small(gl());
    ASSERT_TRUE(streaming.load(small));
    small.setCompileBudget(0);
    ASSERT_TRUE(streaming.draw(small, 0, targets));
    const Picture standIn = readBack();
    EXPECT_EQ(small.programCounters().links, 1u) << "the last rung";
    EXPECT_GT(compareLit(standIn, wanted).max(), 10) << "something simpler";
    EXPECT_EQ(silhouetteOf(standIn), silhouetteOf(wanted)) << "of the same shape";
    EXPECT_TRUE(small.fallbacks().empty()) << "nothing failed";

    small.setCompileBudget(1);
    ASSERT_TRUE(streaming.draw(small, 0, targets));
    EXPECT_EQ(small.programCounters().links, 2u);
    EXPECT_EQ(compareLit(readBack(), wanted).max(), 0) << "its turn came";
}

#ifndef NDEBUG
TEST_P(WarmUpTest, DrawingInAnotherThreadIsABug) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    Renderer renderer(gl());
    EXPECT_DEATH(std::thread([&] { (void)renderer.prepare(); }).join(), "outside the thread");
}
#endif

/// Whether blending was on at each draw, by program.
std::map<GLuint, std::set<bool>> drawsByProgram(const std::vector<GlCall>& calls) {
    std::map<GLuint, std::set<bool>> blended;
    bool on = false;
    GLuint program = 0;
    for (const GlCall& call : calls) {
        if ((call.name == "Enable" || call.name == "Disable") && call.arguments[0] == GL_BLEND)
            on = call.name == "Enable";
        if (call.name == "UseProgram")
            program = static_cast<GLuint>(call.arguments[0]);
        if (call.name == "DrawElements" || call.name == "DrawArrays")
            blended[program].insert(on);
    }
    return blended;
}

// A driver compiles a program again for another state of blending: what is drawn with it must have been
// warmed up with it, the last rung that stands in included.
TEST_P(WarmUpTest, ABlendedSurfaceAndItsLastRungAreDrawnBlended) {
    SceneBuilder builder;
    Material material;
    material.alphaMode = AlphaMode::Blend;
    material.factors.baseColor[3] = 0.5f;
    builder.add(square(), builder.addMaterial(material));
    builder.addSun({0, 0, -1}, {1, 1, 1}, 1);
    const Lighting lighting = lightingOf(builder.scene);
    Renderer renderer(recordingGl(gl()));
    ASSERT_TRUE(renderer.load(builder.scene));
    renderer.setLighting(lighting);
    recordedCalls().clear();
    ASSERT_TRUE(renderer.warmUp(target(), *usesOf(builder.scene, lighting, {})));
    const auto warmed = drawsByProgram(recordedCalls());
    EXPECT_GE(warmed.size(), 2u) << "the surface's and the last rung";
    for (const auto& [program, states] : warmed)
        EXPECT_EQ(states, std::set<bool>{true}) << "program " << program;

    // Without a budget the last rung stands in for a program of another look: it is there, and proved.
    const ProgramCounters before = renderer.programCounters();
    renderer.setCompileBudget(0);
    renderer.setLook({.toneMap = ToneMap::Aces});
    Camera camera;
    camera.world[3] = glm::vec4(0, 0, 3, 1);
    recordedCalls().clear();
    ASSERT_TRUE(renderer.draw(viewpointOf(camera, 1), target()));
    EXPECT_EQ(renderer.programCounters().links, before.links);
    std::size_t draws = 0;
    for (const auto& [program, states] : drawsByProgram(recordedCalls()))
        draws += states.size();
    EXPECT_EQ(draws, 1u) << "one program, one state: nothing is proved in a frame";
}

// There is always a program to draw with: the last rung is not evicted for others, however small the cache.
TEST_P(WarmUpTest, TheLastRungStays) {
    ProgramManager programs(gl(), {}, {}, 2);
    const auto use = [](int suns, Output output) {
        Permutation permutation;
        permutation.suns = static_cast<std::uint8_t>(suns);
        permutation.output = output;
        return ProgramUse{canonicalise(permutation)->permutation, {}};
    };
    programs.setBudget(0);
    ASSERT_TRUE(programs.get(use(1, Output::Srgb), nullptr)->standIn);
    EXPECT_EQ(programs.counters().links, 1u);
    programs.setBudget(ProgramManager::kUnlimited);
    for (const int suns : {1, 2, 3, 4})
        ASSERT_TRUE(programs.get(use(suns, Output::Linear), nullptr));
    EXPECT_GT(programs.counters().evictions, 0u);
    programs.setBudget(0);
    const unsigned links = programs.counters().links;
    ASSERT_TRUE(programs.get(use(2, Output::Srgb), nullptr)->standIn);
    EXPECT_EQ(programs.counters().links, links);
}

TEST_P(WarmUpTest, ALostContextIsWarmedUpAgain) {
    KioskFrames kiosk;
    Renderer renderer(gl());
    ASSERT_TRUE(kiosk.load(renderer));
    ASSERT_TRUE(renderer.warmUp(target(), kiosk.uses()));
    renderer.contextLost();
    EXPECT_EQ(renderer.warmUp(target(), kiosk.uses()).error().code, "renderer.context-lost");
    ASSERT_TRUE(renderer.restore(gl()));
    const unsigned links = renderer.programCounters().links;
    const Result<WarmUpReport> report = renderer.warmUp(target(), kiosk.uses());
    ASSERT_TRUE(report);
    EXPECT_EQ(report->failed, 0u);
    EXPECT_EQ(renderer.programCounters().links, 2 * links);
}

} // namespace
} // namespace franken::test
