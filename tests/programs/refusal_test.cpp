// SPDX-License-Identifier: MIT
// Drivers that refuse programs at each rung of the ladder, in each way: the picture is never empty.
#include "franken/generator/covering.h"
#include "franken/generator/ladder.h"
#include "support/draw_scene.h"
#include "support/fake_driver.h"
#include "support/shapes.h"

#include <algorithm>

namespace franken::test {
namespace {

using RefusalTest = PictureTest;

INSTANTIATE_TEST_SUITE_P(Backends, RefusalTest, allBackends(), backendName);

constexpr std::array kRefusals = {Refusal::Compile, Refusal::Link, Refusal::Draw};

// Where most rungs of the ladder matter.
Shot richShot(AlphaMode alpha = AlphaMode::Opaque) {
    SceneBuilder builder;
    Material material = tiledMaterial(builder);
    material.alphaMode = alpha;
    builder.add(sphere(12), builder.addMaterial(material));
    for (const float x : {-1.0f, -0.5f, 0.5f})
        builder.addSun({x, -1, -1}, {1, 1, 1}, 1);
    Shot shot{.scene = builder.scene,
              .camera = framingCamera(builder.scene.bounds(), 1),
              .lighting = lightingOf(builder.scene),
              .look = {.toneMap = ToneMap::Aces, .dither = Dither::Ordered}};
    shot.lighting.ambient = {.kind = Ambient::Color, .color = {0.1f, 0.1f, 0.1f}};
    return shot;
}

std::vector<Permutation> ladderOf(const Shot& shot) {
    std::vector<Permutation> rungs = {usesOf(shot.scene, shot.lighting, shot.look)->at(0).permutation};
    while (const auto next = simpler(rungs.back()))
        rungs.push_back(*next);
    return rungs;
}

struct Drawn {
    std::size_t covered = 0; ///< Pixels that are not the background.
    std::vector<Fallback> steps;
    std::vector<std::string> log;
    Result<void> result;
};

class Kiosk {
public:
    Kiosk(const Gl& gl, platform::Surface& surface) : m_gl(gl), m_target{surface.framebuffer(), 64, 64} {}

    bool warm = false;

    Drawn draw(const Shot& shot) {
        Drawn drawn;
        Renderer renderer(m_gl, [&](LogLevel, std::string_view text) { drawn.log.emplace_back(text); });
        EXPECT_TRUE(renderer.load(shot.scene));
        renderer.setLighting(shot.lighting);
        renderer.setLook(shot.look);
        if (warm) {
            EXPECT_TRUE(renderer.warmUp(m_target, *usesOf(shot.scene, shot.lighting, shot.look)));
        }
        for (int frame = 0; frame < 2; ++frame)
            if (Result<void> result = renderer.draw(viewpointOf(shot.camera, 1), m_target); !result)
                drawn.result = result;
        EXPECT_EQ(m_gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
        std::vector<std::array<std::uint8_t, 4>> pixels(64 * 64);
        m_gl.ReadPixels(0, 0, 64, 64, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        drawn.covered =
            static_cast<std::size_t>(std::count_if(pixels.begin(), pixels.end(), [](const auto& pixel) {
                return pixel[0] + pixel[1] + pixel[2] > 0;
            }));
        drawn.steps = renderer.fallbacks();
        m_gl.GetError(); // Of reading, where the driver cannot.
        return drawn;
    }

private:
    Gl m_gl;
    DrawTarget m_target;
};

TEST_P(RefusalTest, EachRungGivesWayToTheNextAndSomethingIsDrawn) {
    const Shot shot = richShot();
    const std::vector<Permutation> rungs = ladderOf(shot);
    ASSERT_GE(rungs.size(), 6u);
    const std::size_t whole = Kiosk(gl(), surface()).draw(shot).covered;
    ASSERT_GT(whole, 900u);
    for (const Refusal refusal : kRefusals)
        for (const bool warm : {false, true})
            for (std::size_t count = 1; count < rungs.size(); ++count) {
                const std::vector<Permutation> refused(rungs.begin(),
                                                       rungs.begin() + static_cast<std::ptrdiff_t>(count));
                Kiosk kiosk(refusingDriver(gl(), refusal, refused), surface());
                kiosk.warm = warm;
                const Drawn drawn = kiosk.draw(shot);
                EXPECT_TRUE(drawn.result) << toString(drawn.result.error());
                EXPECT_EQ(drawn.covered, whole) << toName(rungs[count]);
                ASSERT_EQ(drawn.steps.size(), count) << "each is reported once";
                EXPECT_EQ(drawn.log.size(), count);
                for (std::size_t i = 0; i < count; ++i) {
                    EXPECT_EQ(drawn.steps[i].failed, rungs[i]);
                    EXPECT_EQ(drawn.steps[i].next, rungs[i + 1]);
                }
            }
}

TEST_P(RefusalTest, AWrongColorGivesWayAsWell) {
    const Shot shot = richShot();
    const std::vector<Permutation> rungs = ladderOf(shot);
    const std::size_t whole = Kiosk(gl(), surface()).draw(shot).covered;
    for (const Refusal refusal : {Refusal::Black, Refusal::Nan})
        for (const std::size_t count : {std::size_t{1}, std::size_t{4}, rungs.size() - 1}) {
            const std::vector<Permutation> refused(rungs.begin(),
                                                   rungs.begin() + static_cast<std::ptrdiff_t>(count));
            const Drawn drawn = Kiosk(refusingDriver(gl(), refusal, refused), surface()).draw(shot);
            EXPECT_TRUE(drawn.result) << toString(drawn.result.error());
            EXPECT_EQ(drawn.covered, whole) << toName(rungs[count]);
            ASSERT_EQ(drawn.steps.size(), count);
            EXPECT_EQ(drawn.steps[0].error.code, "program.draw");
        }
}

// What is right is known of every program, in both precisions.
TEST_P(RefusalTest, NoRightProgramIsRefused) {
    for (const bool blend : {false, true}) {
        std::vector<ProgramUse> uses;
        for (const Permutation& permutation : coveringSet())
            uses.push_back({permutation, {.blend = blend}});
        ProgramManager manager(gl(), Capabilities::query(gl()), {});
        const DrawTarget target{surface().framebuffer(), 64, 64};
        ASSERT_TRUE(manager.warmUp(uses, target));
        for (const Fallback& fallback : manager.fallbacks())
            ADD_FAILURE() << toString(fallback.error);
    }
}

TEST_P(RefusalTest, AReportNamesStageLineAndWhatReproducesIt) {
    const Shot shot = richShot();
    const Permutation first = ladderOf(shot)[0];
    const Drawn compiled = Kiosk(refusingDriver(gl(), Refusal::Compile, {first}), surface()).draw(shot);
    ASSERT_EQ(compiled.log.size(), 1u);
    for (const std::string& part :
         {std::string("(fragment shader)"), std::string("0:40(5): error: refused [generator/glsl/fragment/"),
          "frankenshader dump " + toName(first), std::string("program.compile"),
          "; key " + toHex(toKey(first)), std::string(" instead")})
        EXPECT_NE(compiled.log[0].find(part), std::string::npos) << part << " in " << compiled.log[0];
    const Drawn silent = Kiosk(refusingDriver(gl(), Refusal::Draw, {first}), surface()).draw(shot);
    ASSERT_EQ(silent.log.size(), 1u);
    EXPECT_NE(silent.log[0].find("program.draw"), std::string::npos) << silent.log[0];
}

TEST_P(RefusalTest, BlendedAndMaskedSurfacesHaveALadderToo) {
    for (const AlphaMode alpha : {AlphaMode::Blend, AlphaMode::Mask}) {
        const Shot shot = richShot(alpha);
        const std::vector<Permutation> rungs = ladderOf(shot);
        const std::vector<Permutation> refused(rungs.begin(), rungs.end() - 1);
        const std::size_t whole = Kiosk(gl(), surface()).draw(shot).covered;
        const Drawn drawn = Kiosk(refusingDriver(gl(), Refusal::Draw, refused), surface()).draw(shot);
        EXPECT_EQ(drawn.steps.size(), refused.size());
        EXPECT_EQ(drawn.covered, whole);
    }
}

// The last rung of a glass is a glass: what is behind it shows through, by its alpha.
TEST_P(RefusalTest, ABlendedSurfaceStaysTransparentOnEveryRung) {
    SceneBuilder builder;
    Material material = tiledMaterial(builder);
    material.alphaMode = AlphaMode::Blend;
    material.factors.baseColor = {0, 1, 0, 0.25f};
    material.textures[TextureRole::BaseColor] = {};
    builder.add(square(), builder.addMaterial(material));
    builder.addSun({0, 0, -1}, {1, 1, 1}, 1);
    Shot shot{.scene = builder.scene, .camera = {}, .lighting = lightingOf(builder.scene)};
    shot.camera.world[3] = glm::vec4(0, 0, 2, 1);
    const std::vector<Permutation> rungs = ladderOf(shot);
    ASSERT_GE(rungs.size(), 3u);
    for (std::size_t count = 0; count < rungs.size(); ++count) {
        Renderer renderer(refusingDriver(
            gl(), Refusal::Link, {rungs.begin(), rungs.begin() + static_cast<std::ptrdiff_t>(count)}));
        ASSERT_TRUE(renderer.load(shot.scene));
        renderer.setLighting(shot.lighting);
        ASSERT_TRUE(renderer.draw(
            viewpointOf(shot.camera, 1),
            {.framebuffer = surface().framebuffer(), .width = 64, .height = 64, .background = {1, 0, 0}}));
        EXPECT_EQ(renderer.fallbacks().size(), count);
        EXPECT_NEAR(readBack().pixel(32, 32)[0], 0.75 * 255, 24) << toName(rungs[count]) << ": red behind it";
    }
}

TEST_P(RefusalTest, WhereNothingWorksTheErrorSaysSo) {
    for (const Refusal refusal : kRefusals) {
        const Drawn drawn = Kiosk(refusingDriver(gl(), refusal), surface()).draw(richShot());
        ASSERT_FALSE(drawn.result);
        EXPECT_EQ(drawn.result.error().code.substr(0, 8), "program.");
        ASSERT_FALSE(drawn.steps.empty());
        EXPECT_FALSE(drawn.steps.back().next);
    }
}

TEST_P(RefusalTest, ABlackSurfaceIsDrawnAndNotTakenForAFailure) {
    Shot shot = richShot();
    shot.scene.materials[0] = {};
    shot.scene.materials[0].factors.baseColor = {0, 0, 0, 1};
    shot.lighting = {};
    EXPECT_TRUE(Kiosk(gl(), surface()).draw(shot).steps.empty());
}

TEST_P(RefusalTest, WhatGlWasLeftAtIsNotTakenForAFailure) {
    Shot shot = richShot();
    shot.scene.materials[0].doubleSided = true;
    disturbState(gl()); // Fronts wind clockwise, for one.
    const Drawn drawn = Kiosk(gl(), surface()).draw(shot);
    EXPECT_TRUE(drawn.steps.empty());
    EXPECT_TRUE(drawn.log.empty()) << drawn.log[0];
}

/// A driver whose glReadPixels fails in one framebuffer, as with samples that are not resolved.
struct PartlyBlind {
    static inline Gl real;
    static inline GLint blind;

    static Gl driver(const Gl& gl, unsigned framebuffer) {
        real = gl;
        blind = static_cast<GLint>(framebuffer);
        Gl table = gl;
        table.ReadPixels = [](GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type,
                              void* pixels) {
            GLint bound = 0;
            real.GetIntegerv(GL_FRAMEBUFFER_BINDING, &bound);
            if (bound == blind)
                real.Enable(GL_NONE); // Leaves an error.
            else
                real.ReadPixels(x, y, width, height, format, type, pixels);
        };
        return table;
    }
};

TEST_P(RefusalTest, ATargetThatCannotBeReadHidesNoFailure) {
    const Shot shot = richShot();
    const Gl blind = PartlyBlind::driver(gl(), surface().framebuffer());
    const Drawn right = Kiosk(blind, surface()).draw(shot);
    EXPECT_TRUE(right.result);
    EXPECT_TRUE(right.steps.empty());
    EXPECT_TRUE(right.log.empty()) << right.log[0];
    const std::vector<Permutation> refused = {ladderOf(shot)[0]};
    for (const bool warm : {false, true}) {
        Kiosk kiosk(refusingDriver(blind, Refusal::Draw, refused), surface());
        kiosk.warm = warm;
        const Drawn drawn = kiosk.draw(shot);
        EXPECT_TRUE(drawn.result);
        ASSERT_EQ(drawn.steps.size(), 1u);
        EXPECT_EQ(drawn.steps[0].failed, refused[0]);
    }
}

TEST_P(RefusalTest, WhereNoTargetCanBeReadProgramsAreTakenOnTrust) {
    Gl blind = gl();
    blind.ReadPixels = [](GLint, GLint, GLsizei width, GLsizei height, GLenum, GLenum, void* pixels) {
        std::fill_n(static_cast<std::uint8_t*>(pixels), 4 * width * height, std::uint8_t{7});
    };
    const Drawn drawn = Kiosk(blind, surface()).draw(richShot());
    EXPECT_TRUE(drawn.result);
    EXPECT_TRUE(drawn.steps.empty());
    ASSERT_EQ(drawn.log.size(), 1u) << "said once";
    EXPECT_NE(drawn.log[0].find("on trust"), std::string::npos);
}

TEST_P(RefusalTest, ASkyThatIsRefusedLeavesTheBackground) {
    Shot shot = richShot();
    SkyboxMap cube{.size = 1, .range = 64, .images = {}};
    cube.images.fill({"", 1, 1, {255, 255, 255, 64}});
    const std::vector<Permutation> skies = {*skyPermutation(shot.look)};
    Renderer renderer(refusingDriver(gl(), Refusal::Draw, skies));
    ASSERT_TRUE(renderer.load(shot.scene));
    ASSERT_TRUE(renderer.setSkybox(&cube));
    renderer.setLook(shot.look);
    ASSERT_TRUE(renderer.draw(viewpointOf(shot.camera, 1), {surface().framebuffer(), 64, 64}));
    ASSERT_EQ(renderer.fallbacks().size(), 1u);
    EXPECT_EQ(toName(*renderer.fallbacks()[0].next), "sky+aces") << "a rung, with a sky";
    EXPECT_GT(readBack().pixel(0, 0)[0], 0);
}

} // namespace
} // namespace franken::test
