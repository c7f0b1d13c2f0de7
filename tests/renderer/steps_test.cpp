// SPDX-License-Identifier: MIT
// Models that come to the GPU step by step: how large a step is, what is drawn meanwhile, and what may happen
// in the middle.
#include "model_fixture.h"
#include "support/gl_recorder.h"
#include "support/shapes.h"

#include <algorithm>
#include <thread>

namespace franken::test {
namespace {

class StepsTest : public ModelFixture {};

INSTANTIATE_TEST_SUITE_P(Backends, StepsTest, allBackends(), backendName);

constexpr std::size_t kUnit = 256 * 1024;

/// A ball of 33,000 vertices and two textures, one of them larger than a unit.
Scene large() {
    SceneBuilder builder;
    Material material;
    material.textures[TextureRole::BaseColor].texture =
        builder.addTexture(checkers(512, 8, {1, 0, 0, 1}, glm::vec4(1)));
    material.textures[TextureRole::Normal].texture = builder.addTexture(bumps(256, 5));
    builder.add(sphere(128), builder.addMaterial(material));
    return builder.scene;
}

Lighting sunny() {
    Lighting lighting;
    lighting.suns = {{.direction = {-1, -1, -1}, .illuminance = 3}};
    lighting.ambient = {.kind = Ambient::Color, .color = {0.2f, 0.2f, 0.2f}};
    return lighting;
}

/// Bytes that a call hands to the driver.
std::size_t bytesOf(const GlCall& call) {
    if (call.name == "BufferData")
        return call.arguments[2] == 0 ? 0 : call.arguments[1];
    if (call.name == "BufferSubData")
        return call.arguments[2];
    if (call.name == "TexImage2D")
        return call.arguments[8] == 0 ? 0 : 4 * call.arguments[3] * call.arguments[4];
    if (call.name == "TexSubImage2D")
        return 4 * call.arguments[4] * call.arguments[5];
    return 0;
}

struct Largest {
    std::size_t bytes = 0, programs = 0, steps = 0;
};

/// Steps of one unit each until nothing is left; the largest of them as the driver saw it. Stops after
/// `most`.
Largest stepped(Renderer& renderer, std::size_t most = 100'000) {
    Largest largest;
    for (bool more = true; more && largest.steps < most;) {
        recordedCalls().clear();
        const Result<StepReport> report = renderer.step();
        EXPECT_TRUE(report) << toString(report.error());
        if (!report)
            break;
        more = report->more;
        std::size_t bytes = 0;
        for (const GlCall& call : recordedCalls())
            bytes += bytesOf(call);
        if (report->bytes == 0 && report->programs == 0)
            std::this_thread::yield();
        else
            ++largest.steps;
        if (report->programs == 0) {
            EXPECT_EQ(bytes, report->bytes) << "the report says what the driver saw";
        }
        largest.bytes = std::max(largest.bytes, report->bytes);
        largest.programs = std::max<std::size_t>(largest.programs, report->programs);
    }
    return largest;
}

TEST_P(StepsTest, NoStepIsLargerThanAUnitAndThePictureIsTheSame) {
    Renderer whole(gl());
    whole.setLighting(sunny());
    ASSERT_TRUE(whole.load(large()));
    const Picture expected = drawn(whole);

    Renderer renderer(recordingGl(gl()));
    renderer.setLighting(sunny());
    const Result<ModelId> model = renderer.addInSteps(large());
    ASSERT_TRUE(model && renderer.show({{*model}}));
    EXPECT_FALSE(*renderer.isResident(*model));
    drawn(renderer);
    EXPECT_EQ(renderer.frameCounters().drawn, 0u) << "not there yet";
    const Largest largest = stepped(renderer);
    EXPECT_LE(largest.bytes, kUnit);
    EXPECT_GT(largest.bytes, kUnit / 2);
    EXPECT_EQ(largest.programs, 1u);
    EXPECT_GT(largest.steps, 10u);
    EXPECT_TRUE(*renderer.isResident(*model));
    const unsigned compiles = renderer.programCounters().compiles;
    EXPECT_EQ(compareLit(drawn(renderer), expected).max(), 0);
    EXPECT_EQ(renderer.programCounters().compiles, compiles) << "its program was there";
    EXPECT_EQ(renderer.memory().used(), whole.memory().used());
}

TEST_P(StepsTest, ALostContextInTheMiddleStartsAgainWithoutASource) {
    Renderer renderer(recordingGl(gl()));
    renderer.setLighting(sunny());
    const Result<ModelId> model = renderer.addInSteps(large());
    ASSERT_TRUE(model && renderer.show({{*model}}));
    stepped(renderer, 8);
    EXPECT_GT(renderer.memory().used(), 0u);
    renderer.contextLost();
    EXPECT_EQ(renderer.step().error().code, "renderer.context-lost");
    EXPECT_EQ(renderer.memory().used(), 0u);
    replaceContext({64, 64});
    ASSERT_TRUE(renderer.restore(recordingGl(gl())));
    stepped(renderer);
    EXPECT_TRUE(*renderer.isResident(*model));
    const Picture picture = drawn(renderer);
    Renderer whole(gl());
    whole.setLighting(sunny());
    ASSERT_TRUE(whole.load(large()));
    EXPECT_EQ(compareLit(picture, drawn(whole)).max(), 0);
}

TEST_P(StepsTest, RemovingAndReplacingInTheMiddleLeavesNothing) {
    Renderer renderer(recordingGl(gl()));
    for (std::size_t steps = 0; steps < 20; ++steps) {
        const Result<ModelId> model = renderer.addInSteps(large());
        ASSERT_TRUE(model);
        stepped(renderer, steps);
        renderer.remove(*model);
        EXPECT_EQ(renderer.memory().used(), 0u) << steps;
        EXPECT_EQ(renderer.isResident(*model).error().code, "renderer.model");
    }
    ASSERT_TRUE(renderer.addInSteps(large()));
    stepped(renderer, 4);
    ASSERT_TRUE(renderer.load(large()));
    EXPECT_FALSE(renderer.step()->more);
}

TEST_P(StepsTest, AnEvictedModelIsReadOnAThreadOfItsOwn) {
    Renderer renderer(recordingGl(gl()));
    std::thread::id reader;
    const SceneSource source = [&] { return reader = std::this_thread::get_id(), Result<Scene>(large()); };
    renderer.setLighting(sunny());
    const Result<ModelId> model = renderer.add(large(), source);
    ASSERT_TRUE(model && renderer.show({{*model}}));
    const Picture before = drawn(renderer);
    ASSERT_TRUE(renderer.show({}) && renderer.memory().evictAll());
    ASSERT_TRUE(renderer.show({{*model}}));
    std::this_thread::sleep_for(
        std::chrono::milliseconds(300)); // The thread is at its end, or not: either is fine.
    stepped(renderer);
    EXPECT_EQ(compareLit(drawn(renderer), before).max(), 0);
    EXPECT_TRUE(*renderer.isResident(*model));
    EXPECT_NE(reader, std::thread::id());
    EXPECT_NE(reader, std::this_thread::get_id());
}

TEST_P(StepsTest, ErrorsInTheMiddleAreToldOnce) {
    Renderer renderer(recordingGl(gl()));
    renderer.memory().setBudget(200'000);
    const Result<ModelId> model = renderer.addInSteps(large());
    ASSERT_TRUE(model);
    Result<StepReport> report = renderer.step();
    while (report && report->more)
        report = renderer.step();
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().code, "memory.budget");
    EXPECT_EQ(renderer.isResident(*model).error().code, "memory.budget");
    EXPECT_EQ(renderer.memory().used(), 0u);
    EXPECT_FALSE(renderer.step()->more);
    renderer.memory().setBudget(GpuMemory::kUnlimited);
    ASSERT_TRUE(renderer.show({{*model}})) << "the scene is still there";
    stepped(renderer);
    EXPECT_TRUE(*renderer.isResident(*model));
}

} // namespace
} // namespace franken::test
