// SPDX-License-Identifier: MIT
// What is on the GPU: several models, a budget, and what happens when all of it is lost.
#include "model_fixture.h"
#include "support/gl_recorder.h"
#include "support/shapes.h"

#include <algorithm>

namespace franken::test {
namespace {

class ResidencyTest : public ModelFixture {};

INSTANTIATE_TEST_SUITE_P(Backends, ResidencyTest, allBackends(), backendName);

/// A ball with a texture of its own: 64 x 64 texels with mipmaps, 21,844 bytes.
Scene ball(const glm::vec4& color) {
    SceneBuilder builder;
    Material material;
    material.textures[TextureRole::BaseColor].texture =
        builder.addTexture(checkers(64, 8, color, glm::vec4(1)));
    builder.add(sphere(12), builder.addMaterial(material));
    return builder.scene;
}

constexpr std::size_t kTextureBytes = 4 * (64 * 64 + 32 * 32 + 16 * 16 + 8 * 8 + 4 * 4 + 2 * 2 + 1);
constexpr std::size_t kMeshBytes = 13 * 25 * (12 + 12 + 16 + 8) + 12 * 24 * 6 * 2;
constexpr std::size_t kBallBytes = kTextureBytes + kMeshBytes;

const Scene& red() {
    static const Scene scene = ball({1, 0, 0, 1});
    return scene;
}
const Scene& green() {
    static const Scene scene = ball({0, 1, 0, 1});
    return scene;
}

int reads = 0;
const SceneSource kRedSource = [] { return ++reads, Result<Scene>(red()); };
const SceneSource kGreenSource = [] { return ++reads, Result<Scene>(green()); };

Lighting sunny() {
    Lighting lighting;
    lighting.suns = {{.direction = {-1, -1, -1}, .illuminance = 3}};
    lighting.ambient = {.kind = Ambient::Color, .color = {0.2f, 0.2f, 0.2f}};
    return lighting;
}

TEST_P(ResidencyTest, BytesAreCountedAndGivenBack) {
    Renderer renderer(gl());
    ASSERT_TRUE(renderer.load(red()));
    EXPECT_EQ(renderer.memory().used(MemoryUse::Textures), kTextureBytes);
    EXPECT_EQ(renderer.memory().used(MemoryUse::Meshes), kMeshBytes);
    {
        const Result<MemoryLease> lease = renderer.memory().reserve(MemoryUse::Targets, 640 * 480 * 4);
        ASSERT_TRUE(lease);
        EXPECT_EQ(renderer.memory().used(), kBallBytes + 640 * 480 * 4);
    }
    const Result<ModelId> second = renderer.add(green());
    ASSERT_TRUE(second);
    EXPECT_EQ(renderer.memory().used(), 2 * kBallBytes);
    renderer.remove(*second);
    EXPECT_EQ(renderer.memory().used(), kBallBytes);
    ASSERT_TRUE(renderer.load(Scene{}));
    EXPECT_EQ(renderer.memory().used(), 0u);
}

TEST_P(ResidencyTest, DrawPicksAmongModels) {
    Renderer renderer(gl());
    renderer.setLighting(sunny());
    ASSERT_TRUE(renderer.load(red()));
    const Picture redAlone = drawn(renderer);
    ASSERT_TRUE(renderer.load(green()));
    const Picture greenAlone = drawn(renderer);
    EXPECT_GT(compareLit(redAlone, greenAlone).max(), 100);

    const Result<ModelId> first = renderer.add(red()), second = renderer.add(green());
    ASSERT_TRUE(first && second);
    ASSERT_TRUE(renderer.show({{*first}}, Wait::Yes));
    EXPECT_EQ(compareLit(drawn(renderer), redAlone).max(), 0);
    ASSERT_TRUE(renderer.show({{*second}}, Wait::Yes));
    EXPECT_EQ(compareLit(drawn(renderer), greenAlone).max(), 0);
    ASSERT_TRUE(renderer.show({{*first, *second, *first}}, Wait::Yes));
    EXPECT_EQ(compareLit(drawn(renderer), greenAlone).max(), 0) << "equal depth: the later one is seen";
    EXPECT_EQ(renderer.frameCounters().drawn, 2u);
    renderer.remove(*second);
    EXPECT_EQ(compareLit(drawn(renderer), redAlone).max(), 0);
    const Result<void> unknown = renderer.show({{*second}}, Wait::Yes);
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().code, "renderer.model");
    EXPECT_EQ(compareLit(drawn(renderer), redAlone).max(), 0) << "what was shown stays";
}

TEST_P(ResidencyTest, WhatIsNotShownMakesRoomAndComesBack) {
    Renderer renderer(gl());
    renderer.setLighting(sunny());
    renderer.memory().setBudget(2 * kBallBytes + 100);
    const Result<ModelId> first = renderer.add(red(), kRedSource);
    const Result<ModelId> second = renderer.add(green(), kGreenSource);
    ASSERT_TRUE(first && second);
    ASSERT_TRUE(renderer.show({{*second}}, Wait::Yes));
    const Picture greenAlone = drawn(renderer);
    ASSERT_TRUE(renderer.show({{*first}}, Wait::Yes));
    const Picture redAlone = drawn(renderer);
    EXPECT_EQ(renderer.memory().evictions(), 0u);

    reads = 0;
    ASSERT_TRUE(renderer.add(red(), kRedSource)) << "the green one makes room";
    EXPECT_EQ(renderer.memory().evictions(), 1u);
    EXPECT_EQ(renderer.memory().used(), 2 * kBallBytes);
    EXPECT_EQ(compareLit(drawn(renderer), redAlone).max(), 0);
    ASSERT_TRUE(renderer.show({{*second}}, Wait::Yes));
    EXPECT_EQ(compareLit(drawn(renderer), greenAlone).max(), 0);
    EXPECT_EQ(reads, 1);
    EXPECT_LE(renderer.memory().used(), renderer.memory().budget());
}

// Of those that are not shown, the one goes that was shown longest ago.
TEST_P(ResidencyTest, TheModelShownLongestAgoMakesRoom) {
    Renderer renderer(gl());
    renderer.memory().setBudget(3 * kBallBytes + 100);
    std::vector<int> readsOf(4);
    std::vector<ModelId> ids;
    const auto source = [&](std::size_t i) { return [&, i] { return ++readsOf[i], Result<Scene>(red()); }; };
    for (std::size_t i = 0; i < 3; ++i)
        ids.push_back(*renderer.add(red(), source(i)));
    for (const std::size_t shown : {0u, 1u, 2u, 0u}) // The second one is the oldest then.
        ASSERT_TRUE(renderer.show({{ids[shown]}}, Wait::Yes));
    ids.push_back(*renderer.add(red(), source(3)));
    EXPECT_EQ(renderer.memory().evictions(), 1u);
    for (const std::size_t shown : {0u, 2u, 3u})
        ASSERT_TRUE(renderer.show({{ids[shown]}}, Wait::Yes));
    EXPECT_EQ(readsOf, (std::vector<int>{0, 0, 0, 0})) << "these are there";
    ASSERT_TRUE(renderer.show({{ids[1]}}, Wait::Yes));
    EXPECT_EQ(readsOf[1], 1);
}

TEST_P(ResidencyTest, OverTheBudgetIsAnErrorBeforeTheDriversOwn) {
    Renderer renderer(recordingGl(gl()));
    renderer.setLighting(sunny());
    renderer.memory().setBudget(kBallBytes + 100);
    ASSERT_TRUE(renderer.load(red()));
    const Picture redAlone = drawn(renderer);
    recordedCalls().clear();
    const Result<ModelId> second = renderer.add(green());
    ASSERT_FALSE(second) << "the red one has no source, and is shown";
    EXPECT_EQ(second.error().code, "memory.budget");
    EXPECT_NE(second.error().what.find("KiB"), std::string::npos);
    EXPECT_EQ(countCalls("BufferData") + countCalls("TexImage2D"), 0u);
    EXPECT_EQ(compareLit(drawn(renderer), redAlone).max(), 0);
    EXPECT_EQ(renderer.memory().used(), kBallBytes);
    ASSERT_TRUE(renderer.load(green())) << "load() replaces the model, and so has room";
    EXPECT_EQ(renderer.memory().used(), kBallBytes);
    const SkyboxMap cube = encodeSkybox({Environment::Layout::Equirect, 2, 1, {{1, 1, 1}, {0, 1, 1}}}, 64);
    EXPECT_EQ(renderer.setSkybox(&cube).error().code, "memory.budget");
}

TEST_P(ResidencyTest, TheDriversOwnErrorIsOneToo) {
    static GLenum error = GL_NO_ERROR;
    Gl failing = gl();
    failing.GetError = [] { return std::exchange(error, static_cast<GLenum>(GL_NO_ERROR)); };
    Renderer renderer(failing);
    error = GL_OUT_OF_MEMORY;
    const Result<void> loaded = renderer.load(red());
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, "renderer.memory");
    EXPECT_EQ(renderer.memory().used(), 0u);
}

TEST_P(ResidencyTest, ALostContextIsRebuiltFromItsSources) {
    const SkyboxMap cube = encodeSkybox({Environment::Layout::Equirect, 2, 1, {{1, 1, 1}, {0, 1, 1}}}, 16);
    const auto grey = [](glm::vec2 uv) { return glm::vec4(uv, 0.5f, 1); };
    const ReflectionMaps reflection = {{paint(32, grey), 1}, paint(16, grey)};
    Renderer renderer(recordingGl(gl()));
    Lighting lighting = sunny();
    lighting.ambient.kind = Ambient::Sky;
    lighting.reflection = Reflection::Lookup;
    renderer.setLighting(lighting);
    ASSERT_TRUE(renderer.load(red(), kRedSource));
    const Result<ModelId> second = renderer.add(green(), kGreenSource);
    ASSERT_TRUE(second);
    ASSERT_TRUE(renderer.setSkybox(&cube, [&] { return Result<SkyboxMap>(cube); }));
    ASSERT_TRUE(renderer.setReflection(&reflection, [&] { return Result<ReflectionMaps>(reflection); }));
    const Picture before = drawn(renderer);
    const std::size_t bytes = renderer.memory().used();

    recordedCalls().clear();
    replaceContext({48, 32});
    replaceContext({64, 64});
    renderer.contextLost();
    const Result<void> dark = renderer.draw({}, target());
    ASSERT_FALSE(dark);
    EXPECT_EQ(dark.error().code, "renderer.context-lost");
    EXPECT_EQ(renderer.add(red()).error().code, "renderer.context-lost");
    EXPECT_EQ(recordedCalls().size(), 0u) << "no call on the dead context";
    EXPECT_EQ(renderer.memory().used(), 0u);

    reads = 0;
    ASSERT_TRUE(renderer.restore(gl()));
    EXPECT_EQ(reads, 1) << "what is not shown is read when it is";
    EXPECT_EQ(compareLit(drawn(renderer), before).max(), 0);
    EXPECT_EQ(renderer.memory().used(), bytes - kBallBytes);
    ASSERT_TRUE(renderer.show({{*second}}, Wait::Yes));
    const Picture other = drawn(renderer);
    EXPECT_GT(compareLit(other, before).max(), 0);

    Renderer neverLost(gl());
    neverLost.setLighting(lighting);
    ASSERT_TRUE(neverLost.load(green()));
    ASSERT_TRUE(neverLost.setSkybox(&cube));
    ASSERT_TRUE(neverLost.setReflection(&reflection));
    EXPECT_EQ(compareLit(other, drawn(neverLost)).max(), 0);
}

TEST_P(ResidencyTest, WhatCannotBeRebuiltIsAnErrorAndTheRestIs) {
    Renderer renderer(gl());
    renderer.setLighting(sunny());
    const Result<ModelId> kept = renderer.add(red(), kRedSource);
    const Result<ModelId> gone = renderer.add(green());
    ASSERT_TRUE(kept && gone);
    ASSERT_TRUE(renderer.show({{*kept}}, Wait::Yes));
    const Picture before = drawn(renderer);
    ASSERT_TRUE(renderer.show({{*kept, *gone}}, Wait::Yes));
    renderer.contextLost();
    replaceContext({64, 64});
    EXPECT_EQ(renderer.restore(gl()).error().code, "renderer.no-source");
    EXPECT_EQ(compareLit(drawn(renderer), before).max(), 0);
}

/// What a renderer does otherwise on another context.
struct Upload {
    std::uint64_t width = 0, indexType = 0;
    std::size_t statusQueries = 0;
    friend bool operator==(const Upload&, const Upload&) = default;
};

/// Of the calls since the list was cleared: the widest level of a texture, and the last draw's indices.
Upload uploadOf(const std::vector<GlCall>& calls) {
    constexpr std::uint64_t kCompletionStatus = 0x91B1;
    Upload upload;
    for (const GlCall& call : calls) {
        if (call.name == "TexImage2D")
            upload.width = std::max(upload.width, call.arguments[3]);
        if (call.name == "DrawElements")
            upload.indexType = call.arguments[2];
        if (call.name == "GetProgramiv" && call.arguments[1] == kCompletionStatus)
            ++upload.statusQueries;
    }
    return upload;
}

/// A texture of 96 x 96, and 65,600 vertices of which the last three are drawn.
Scene demanding() {
    SceneBuilder builder;
    Material material;
    material.textures[TextureRole::BaseColor].texture =
        builder.addTexture(checkers(96, 8, {1, 0, 0, 1}, glm::vec4(1)));
    Primitive primitive = square();
    for (int i = 0; i < 65'600; ++i) {
        primitive.positions.push_back(primitive.positions[static_cast<std::size_t>(i % 4)]);
        primitive.normals.emplace_back(0, 0, 1);
        primitive.tangents.emplace_back(1, 0, 0, 1);
        primitive.uv[0].emplace_back(0.5f, 0.5f);
    }
    primitive.indices = {65'600, 65'601, 65'602};
    builder.add(std::move(primitive), builder.addMaterial(material));
    return builder.scene;
}

// Another card, or the same behind another driver: what the old one could do does not matter any more.
TEST_P(ResidencyTest, ARestoredContextHasItsOwnCapabilities) {
    const Capabilities least{.maxTextureSize = 64, .maxCubeSize = 64};
    const Capabilities most{.maxTextureSize = 2048,
                            .maxCubeSize = 2048,
                            .anyTextureSize = true,
                            .wideIndices = true,
                            .parallelCompile = true};
    const Scene scene = demanding();
    const auto source = [&] { return Result<Scene>(scene); };
    for (const bool better : {false, true}) {
        const Capabilities &old = better ? least : most, &now = better ? most : least;
        const auto used = [&](Renderer& renderer) {
            EXPECT_TRUE(renderer.warmUp(target(), *usesOf(scene, Lighting{}, {})));
            drawn(renderer);
            return uploadOf(recordedCalls());
        };
        Renderer fresh(recordingGl(gl()), now);
        recordedCalls().clear();
        ASSERT_TRUE(fresh.load(scene, source));
        const Upload expected = used(fresh);
        EXPECT_EQ(expected.width, better ? 96u : 64u);
        EXPECT_EQ(expected.indexType,
                  static_cast<std::uint64_t>(better ? GL_UNSIGNED_INT : GL_UNSIGNED_SHORT));
        EXPECT_EQ(expected.statusQueries > 0, better) << "asked whether it is still compiling";

        Renderer restored(recordingGl(gl()), old);
        ASSERT_TRUE(restored.load(scene, source));
        drawn(restored);
        restored.contextLost();
        recordedCalls().clear();
        ASSERT_TRUE(restored.restore(recordingGl(gl()), now));
        EXPECT_EQ(used(restored), expected) << (better ? "a better context" : "a lesser context");
    }
}

// Mesa's drivers of the Pi compile for what lies in texture units: a restored renderer knows where it is
// again.
TEST_P(ResidencyTest, ARestoredContextOfAPiIsOneAgain) {
    const auto uses = *usesOf(red(), sunny(), {});
    unsigned links[2] = {};
    for (const bool pi : {false, true}) {
        const Capabilities now{.maxTextureSize = 2048, .maxCubeSize = 2048, .compilesForStaleTextures = pi};
        Renderer renderer(gl(),
                          {.maxTextureSize = 2048, .maxCubeSize = 2048, .compilesForStaleTextures = !pi});
        ASSERT_TRUE(renderer.load(red(), kRedSource));
        renderer.contextLost();
        ASSERT_TRUE(renderer.restore(gl(), now));
        const unsigned before = renderer.programCounters().links;
        ASSERT_TRUE(renderer.warmUp(target(), uses));
        links[pi ? 1 : 0] = renderer.programCounters().links - before;
    }
    EXPECT_EQ(links[1], links[0] + 1) << "the program that resets textures";
}

TEST_P(ResidencyTest, ARendererMayDieAfterItsContext) {
    {
        Renderer renderer(recordingGl(gl()));
        ASSERT_TRUE(renderer.load(red()));
        renderer.contextLost();
        recordedCalls().clear();
    }
    EXPECT_EQ(recordedCalls().size(), 0u);
}

} // namespace
} // namespace franken::test
