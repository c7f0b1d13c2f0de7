// SPDX-License-Identifier: MIT
// Drivers that fail or die at any call, or have no memory: each ends in an error with a code.
#include "misuse_stage.h"
#include "support/fault_driver.h"

#include <iostream>
#include <utility>

namespace franken::test {
namespace {

/// All that a kiosk does, on a driver with a fault. Each error must have a code, and say something; the codes
/// are returned.
std::vector<std::string> runOn(const Gl& gl) {
    std::vector<std::string> codes;
    const auto note = [&](const auto& result) {
        if (result)
            return;
        codes.push_back(result.error().code);
        EXPECT_FALSE(result.error().code.empty());
        EXPECT_FALSE(result.error().what.empty()) << result.error().code;
    };
    Renderer renderer(gl);
    renderer.setLighting(sunny(1, 2));
    note(renderer.load(ball(), [] { return Result<Scene>(ball()); }));
    const SkyboxMap cube = whiteCube(4);
    note(renderer.setSkybox(&cube, [] { return Result<SkyboxMap>(whiteCube(4)); }));
    const ReflectionMaps maps{.atlas = {.image = white(8, 8), .range = 1}, .lookup = white(4, 4)};
    note(renderer.setReflection(&maps));
    if (const Result<std::vector<ProgramUse>> uses = usesOf(ball(), sunny(1, 2), {}))
        note(renderer.warmUp(kTarget, *uses));
    for (int frame = 0; frame < 2; ++frame)
        note(renderer.draw({}, kTarget));
    const Result<PictureId> picture =
        renderer.addPicture(white(2, 2), [] { return Result<Image>(white(2, 2)); });
    note(picture);
    if (picture) {
        const OverlayQuad quad{.picture = *picture, .place = {0, 0, 9, 9}};
        note(renderer.drawOverlay({&quad, 1}, kTarget));
    }
    const Result<ModelId> second = renderer.add(ball());
    note(second);
    if (second)
        note(renderer.show({{*second}}, Wait::Yes));
    note(renderer.draw({}, kTarget));
    // The next context is sound.
    const Gl sound = nullGl();
    renderer.contextLost();
    EXPECT_EQ(renderer.draw({}, kTarget).error().code, "renderer.context-lost");
    static_cast<void>(renderer.restore(sound));  // What has no source is named.
    renderer.setSnippets(SnippetSet::builtIn()); // Programs that the faulty driver refused are tried again.
    EXPECT_TRUE(renderer.load(ball()));
    EXPECT_TRUE(renderer.draw({}, kTarget));
    EXPECT_EQ(renderer.frameCounters().drawn + renderer.frameCounters().culled, 1u);
    return codes;
}

std::size_t callsOfARun() {
    EXPECT_TRUE(runOn(faultyDriver(nullGl(), Fault::None, 0)).empty());
    return callsOfFaultyDriver();
}

TEST(FaultyDriver, ThatFailsAtEachCallInTurn) {
    const std::size_t calls = callsOfARun();
    EXPECT_GT(calls, 200u);
    std::size_t failed = 0;
    for (std::size_t at = 0; at < calls; ++at)
        failed += runOn(faultyDriver(nullGl(), Fault::OneCall, at)).empty() ? 0 : 1;
    std::cout << "of " << calls << " calls, " << failed << " end in an error of the library\n";
}

TEST(FaultyDriver, ThatDiesAtEachCallInTurn) {
    const std::size_t calls = callsOfARun();
    for (const Fault fault : {Fault::Dies, Fault::DiesLoudly, Fault::EndlessErrors})
        for (std::size_t at = 0; at < calls; ++at) {
            const std::vector<std::string> codes = runOn(faultyDriver(nullGl(), fault, at));
            for (const std::string& code : codes)
                EXPECT_EQ(code, "renderer.context-lost") << "fault " << int(fault) << " at call " << at;
            // Frames ask GL for nothing: a death in the last of them is for the next call to find.
            if (at < calls / 2) {
                EXPECT_FALSE(codes.empty()) << "fault " << int(fault) << " at call " << at;
            }
        }
}

TEST(FaultyDriver, ThatMakesNoObjects) {
    const std::vector<std::string> codes = runOn(faultyDriver(nullGl(), Fault::NoNames, 0));
    ASSERT_FALSE(codes.empty());
    EXPECT_EQ(codes.front(), "gl.object");
}

TEST(MemoryOfTheGpu, IsFreedAndAskedForOnceMore) {
    static int refusals;
    refusals = 0;
    static bool owesError = false;
    Gl gl = nullGl();
    gl.TexImage2D = [](GLenum, GLint, GLint, GLsizei, GLsizei, GLint, GLenum, GLenum, const void*) {
        owesError = refusals > 0;
        refusals -= owesError ? 1 : 0;
    };
    gl.GetError = []() -> GLenum { return std::exchange(owesError, false) ? GL_OUT_OF_MEMORY : GL_NO_ERROR; };
    Renderer renderer(gl);
    const SceneSource source = [] { return Result<Scene>(ball()); };
    const Result<ModelId> hidden = renderer.add(ball(), source);
    ASSERT_TRUE(hidden);
    refusals = 100;
    EXPECT_EQ(renderer.add(ball(), source).error().code, "renderer.memory");
    EXPECT_EQ(renderer.memory().evictions(), 1u) << "the hidden model";
    refusals = 0;
    ASSERT_TRUE(renderer.show({{*hidden}}, Wait::Yes));
    EXPECT_TRUE(renderer.draw({}, kTarget));
}

} // namespace
} // namespace franken::test
