// SPDX-License-Identifier: MIT
// Changes of a model that is loaded: what is uploaded for them, and that they last. And what is uploaded
// once.
#include "franken/png.h"
#include "model_fixture.h"
#include "support/gl_recorder.h"
#include "support/shapes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>

namespace franken::test {
namespace {

class ChangesTest : public ModelFixture {
protected:
    ModelId shown(Renderer& renderer, const Scene& scene, SceneSource source = {}) {
        Lighting lighting;
        lighting.suns = {{.direction = {-1, -1, -1}, .illuminance = 3}};
        renderer.setLighting(lighting);
        const Result<ModelId> model = renderer.add(scene, std::move(source));
        EXPECT_TRUE(model && renderer.show({{*model}}, Wait::Yes));
        return *model;
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, ChangesTest, allBackends(), backendName);

constexpr glm::vec4 kRed{1, 0.1f, 0.1f, 1}, kGreen{0.1f, 1, 0.1f, 1}, kBlue{0.1f, 0.1f, 1, 1};

/// Two balls, each textured by a texture of its own; both of equal pixels.
Scene pair() {
    SceneBuilder builder;
    for (const float x : {-0.6f, 0.6f}) {
        Material material;
        material.factors.roughness = 0.6f;
        material.name = x < 0 ? "left" : "right";
        material.textures[TextureRole::BaseColor].texture =
            builder.addTexture(checkers(32, 4, kRed, glm::vec4(1)));
        glm::mat4 world(0.5f);
        world[3] = glm::vec4(x, 0, 0, 1);
        builder.add(sphere(8), builder.addMaterial(material), world);
    }
    return builder.scene;
}

std::size_t uploadedBytes() {
    std::size_t bytes = 0;
    for (const GlCall& call : recordedCalls())
        if (call.name == "BufferData")
            bytes += call.arguments[1];
        else if (call.name == "TexImage2D")
            bytes += call.arguments[3] * call.arguments[4] * 4;
        else if (call.name == "TexSubImage2D")
            bytes += call.arguments[4] * call.arguments[5] * 4;
    return bytes;
}

TEST_P(ChangesTest, EqualGeometryAndImagesAreUploadedOnce) {
    Renderer renderer(recordingGl(gl()));
    SceneBuilder builder;
    const Primitive ball = sphere(20);
    for (int i = 0; i < 500; ++i) {
        Material material;
        material.factors.roughness = 0.5f;
        if (i < 50)
            material.textures[TextureRole::BaseColor].texture =
                builder.addTexture(checkers(16, 4, kRed, kGreen));
        builder.add(ball, i < 50 ? builder.addMaterial(material) : 0,
                    glm::translate(glm::mat4(1), {i, 0, 0}));
    }
    const std::size_t mesh = 21 * 41 * (12 + 12 + 16 + 8) + 20 * 40 * 6 * 2;
    const std::size_t texture = 4 * (16 * 16 + 8 * 8 + 4 * 4 + 2 * 2 + 1);
    recordedCalls().clear();
    ASSERT_TRUE(renderer.add(builder.scene));
    EXPECT_EQ(uploadedBytes(), mesh + texture) << "and not 500 times " << mesh;
    EXPECT_EQ(renderer.memory().used(), mesh + texture);
    // One vertex or one pixel more or less is another thing.
    builder.scene.meshes[1].primitives[0].positions[3].x += 1e-6f;
    builder.scene.images[1].rgba[5] ^= 1;
    builder.scene.textures[2].magFilter = Filter::Nearest;
    recordedCalls().clear();
    ASSERT_TRUE(renderer.add(builder.scene));
    EXPECT_EQ(uploadedBytes(), 2 * mesh + 3 * texture);
}

Image encoded(const Image& image) {
    return {image.name, image.width, image.height, {}, encodePng(image.width, image.height, 4, image.rgba)};
}

TEST_P(ChangesTest, EncodedImagesAreDrawnAndSharedAsTheirPixelsAre) {
    const Image other = checkers(32, 2, kBlue, kGreen);
    Renderer plain(gl());
    const ModelId ofPixels = shown(plain, pair());
    const Picture before = drawn(plain);
    ASSERT_TRUE(plain.setTexture(ofPixels, 0, other));
    const Picture after = drawn(plain);

    Scene scene = pair();
    for (Image& image : scene.images)
        image = encoded(image);
    Renderer renderer(gl());
    const ModelId model = shown(renderer, scene);
    const std::size_t bytes = renderer.memory().used();
    EXPECT_EQ(compareLit(drawn(renderer), before).max(), 0);
    ASSERT_TRUE(renderer.setTexture(model, 0, encoded(other)));
    EXPECT_EQ(compareLit(drawn(renderer), after).max(), 0);
    EXPECT_EQ(renderer.memory().used(), plain.memory().used());
    EXPECT_LT(bytes, renderer.memory().used()) << "equal images were one texture";

    Image smaller = encoded(checkers(16, 2, kBlue, kGreen)), broken = encoded(other);
    smaller.width = smaller.height = 32;
    broken.encoded.resize(50);
    EXPECT_EQ(renderer.setTexture(model, 0, smaller).error().code, "renderer.image");
    EXPECT_EQ(renderer.setTexture(model, 0, broken).error().code, "image.format");
    EXPECT_EQ(compareLit(drawn(renderer), after).max(), 0) << "what is refused changes nothing";

    Scene different = pair();
    different.images[1] = other;
    ASSERT_TRUE(plain.add(different));
    for (Image& image : different.images)
        image = encoded(image);
    ASSERT_TRUE(renderer.add(different));
    EXPECT_EQ(renderer.memory().used(), plain.memory().used()) << "two textures";
}

TEST_P(ChangesTest, FactorsUploadUniformsAlone) {
    Renderer renderer(recordingGl(gl()));
    const ModelId model = shown(renderer, pair());
    const Picture before = drawn(renderer);
    EXPECT_EQ(renderer.namesOf(model)->materials, (std::vector<std::string>{"left", "right"}));
    Result<Material> material = renderer.materialOf(model, 1);
    ASSERT_TRUE(material);
    const unsigned compiles = renderer.programCounters().compiles;
    material->factors.baseColor = toFloat4(kBlue);
    material->factors.roughness = 0.2f;
    recordedCalls().clear();
    ASSERT_TRUE(renderer.setMaterial(model, 1, *material));
    const Picture after = drawn(renderer);
    EXPECT_EQ(uploadedBytes(), 0u);
    EXPECT_EQ(renderer.programCounters().compiles, compiles);
    EXPECT_EQ(callsThatAsk(), std::vector<std::string>());
    const auto left = [](int x, int) { return x < 30; };
    const auto right = [](int x, int) { return x > 34; };
    EXPECT_EQ(compare(after, before, left).max(), 0);
    EXPECT_GT(compare(after, before, right).max(), 50);
    Scene expected = pair();
    expected.materials[1] = *material;
    Renderer fresh(gl());
    shown(fresh, expected);
    EXPECT_EQ(compareLit(after, drawn(fresh)).max(), 0);
}

TEST_P(ChangesTest, AnotherProgramIsAMissAsAnyOther) {
    Renderer renderer(gl());
    const ModelId model = shown(renderer, pair());
    drawn(renderer);
    renderer.takeMisses();
    Material material = *renderer.materialOf(model, 0);
    material.factors.emissive = {0.1f, 0.2f, 0.5f};
    material.alphaMode = AlphaMode::Blend;
    material.doubleSided = true;
    material.factors.baseColor[3] = 0.5f;
    Scene expected = pair();
    expected.materials[0] = material;
    ASSERT_TRUE(renderer.setMaterial(model, 0, material));
    const Picture after = drawn(renderer);
    const std::vector<ProgramUse> misses = renderer.takeMisses();
    ASSERT_EQ(misses.size(), 1u);
    Lighting oneSun;
    oneSun.suns = {{.illuminance = 3}};
    const auto uses = usesOf(expected, oneSun, {});
    ASSERT_TRUE(uses);
    EXPECT_NE(std::find(uses->begin(), uses->end(), misses[0]), uses->end()) << "it could be foreseen";
    Renderer fresh(gl());
    shown(fresh, expected);
    EXPECT_EQ(compareLit(after, drawn(fresh)).max(), 0);
}

TEST_P(ChangesTest, ATextureIsReplacedForItsMaterialAlone) {
    Renderer renderer(recordingGl(gl()));
    const ModelId model = shown(renderer, pair());
    drawn(renderer);
    const std::size_t bytes = renderer.memory().used();
    recordedCalls().clear();
    ASSERT_TRUE(renderer.setTexture(model, 1, checkers(32, 2, kBlue, kGreen)));
    const std::size_t texture = 4 * (32 * 32 + 16 * 16 + 8 * 8 + 4 * 4 + 2 * 2 + 1);
    EXPECT_EQ(uploadedBytes(), texture);
    EXPECT_EQ(renderer.memory().used(), bytes + texture) << "the two were one";
    Scene expected = pair();
    expected.images[1] = checkers(32, 2, kBlue, kGreen);
    Renderer fresh(gl());
    shown(fresh, expected);
    EXPECT_EQ(compareLit(drawn(renderer), drawn(fresh)).max(), 0);

    recordedCalls().clear();
    ASSERT_TRUE(renderer.setTexture(model, 1, checkers(32, 8, kRed, kGreen)));
    EXPECT_EQ(countCalls("TexImage2D"), 0u) << "into the same memory";
    EXPECT_EQ(uploadedBytes(), texture);
    ASSERT_TRUE(renderer.setTexture(model, 1, checkers(64, 8, kRed, kGreen)));
    EXPECT_GT(renderer.memory().used(), bytes + texture);
    expected.images[1] = checkers(64, 8, kRed, kGreen);
    shown(fresh, expected);
    EXPECT_EQ(compareLit(drawn(renderer), drawn(fresh)).max(), 0);
}

TEST_P(ChangesTest, ChangesOutlastALostContext) {
    Renderer renderer(gl());
    const ModelId model = shown(renderer, pair(), [] { return Result<Scene>(pair()); });
    Material material = *renderer.materialOf(model, 0);
    material.factors.baseColor = toFloat4(kGreen);
    ASSERT_TRUE(renderer.setMaterial(model, 0, material));
    ASSERT_TRUE(renderer.setTexture(model, 1, checkers(32, 2, kBlue, kGreen)));
    int reads = 0;
    const PictureSource source = [&] { return ++reads, Result<Image>(checkers(32, 4, kRed, kBlue)); };
    ASSERT_TRUE(renderer.setTexture(model, 0, checkers(32, 4, kRed, kBlue), source));
    const Result<PlaceId> second = renderer.addPlace(model, glm::translate(glm::dmat4(1), {0, 1, 0}));
    ASSERT_TRUE(second);
    const Picture before = drawn(renderer);

    replaceContext({48, 32});
    replaceContext({64, 64});
    renderer.contextLost();
    material.factors.roughness = 0.9f;
    ASSERT_TRUE(renderer.setMaterial(model, 0, material)) << "without a context";
    ASSERT_TRUE(renderer.setVisible(*second, false));
    ASSERT_TRUE(renderer.setVisible(*second, true));
    material.factors.roughness = 0.6f;
    ASSERT_TRUE(renderer.setMaterial(model, 0, material));
    ASSERT_TRUE(renderer.restore(gl()));
    EXPECT_EQ(reads, 1);
    EXPECT_EQ(compareLit(drawn(renderer), before).max(), 0);
}

} // namespace
} // namespace franken::test
