// SPDX-License-Identifier: MIT
// Which draws a frame makes, in which order, and what it asks of GL for them.
#include "support/draw_scene.h"
#include "support/gl_recorder.h"
#include "support/shapes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <set>

namespace franken::test {
namespace {

using Names = std::vector<std::string>;

class DrawingTest : public PictureTest {
protected:
    DrawTarget target() { return {.framebuffer = surface().framebuffer(), .width = 64, .height = 64}; }

    /// A renderer over a recording table, which has drawn one frame.
    std::unique_ptr<Renderer> warm(const Shot& shot) {
        auto renderer = std::make_unique<Renderer>(recordingGl(gl()));
        EXPECT_TRUE(renderer->load(shot.scene));
        renderer->setLighting(shot.lighting);
        EXPECT_TRUE(renderer->draw(viewpointOf(shot.camera, 1), target()));
        return renderer;
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, DrawingTest, allBackends(), backendName);

glm::mat4 at(float x, float y, float z) { return glm::translate(glm::mat4(1), glm::vec3(x, y, z)); }

Camera lookingAhead() {
    Camera camera;
    camera.yfov = 1;
    camera.znear = 0.5f;
    camera.zfar = 100;
    return camera;
}

/// Balls in many materials and meshes, in an order that suits nobody; textured, mirrored and blended ones.
Shot manyBalls() {
    SceneBuilder builder;
    std::vector<int> materials;
    for (int i = 0; i < 6; ++i) {
        Material material;
        material.factors.baseColor = {0.2f + 0.1f * static_cast<float>(i), 0.5f, 0.4f, i == 5 ? 0.5f : 1.0f};
        material.alphaMode = i == 5 ? AlphaMode::Blend : AlphaMode::Opaque;
        material.doubleSided = i == 4;
        if (i % 2 == 0)
            material.textures[TextureRole::BaseColor].texture =
                builder.addTexture(checkers(8, 4, glm::vec4(1), glm::vec4(0.5f)));
        materials.push_back(builder.addMaterial(material));
    }
    for (int i = 0; i < 24; ++i) {
        const glm::mat4 place = at(static_cast<float>(i % 6) - 2.5f, static_cast<float>(i / 6) - 1.5f, -5);
        builder.add(sphere(5), materials[static_cast<std::size_t>(i * 5 % 6)],
                    glm::scale(place, glm::vec3(i % 7 == 0 ? -0.4f : 0.4f, 0.4f, 0.4f)));
    }
    builder.addSun({-1, -1, -1}, {1, 1, 1}, 3);
    return {.scene = builder.scene, .camera = lookingAhead(), .lighting = lightingOf(builder.scene)};
}

TEST_P(DrawingTest, WhatLiesOutsideTheViewIsNotDrawn) {
    SceneBuilder builder;
    const int material = builder.addMaterial({});
    for (const glm::mat4& place : {at(0, 0, -5), at(0, 0, 5), at(9, 0, -5), at(-9, 0, -5), at(0, 9, -5),
                                   at(0, -9, -5), at(0, 0, -200), at(3.4f, 0, -5)})
        builder.add(sphere(6), material, place);
    builder.addSun({-1, -1, -1}, {1, 1, 1}, 3);
    const Shot shot = {
        .scene = builder.scene, .camera = lookingAhead(), .lighting = lightingOf(builder.scene)};
    const std::unique_ptr<Renderer> renderer = warm(shot);
    const Picture picture = readBack();
    EXPECT_EQ(countCalls("DrawElements"), 1u + 2u)
        << "one that proves the program, the one in the middle, and one that is cut by the edge";
    EXPECT_EQ(renderer->frameCounters().drawn, 2u);
    EXPECT_EQ(renderer->frameCounters().culled, 6u);

    Camera turned = shot.camera;
    turned.world = glm::rotate(glm::mat4(1), glm::pi<float>(), glm::vec3(0, 1, 0));
    recordedCalls().clear();
    ASSERT_TRUE(renderer->draw(viewpointOf(turned, 1), target()));
    EXPECT_EQ(countCalls("DrawElements"), 1u) << "the one behind";
    ASSERT_TRUE(renderer->draw(viewpointOf(shot.camera, 1), target()));
    EXPECT_EQ(compareLit(readBack(), picture).max(), 0);
}

TEST_P(DrawingTest, OrderIsByProgramMaterialAndMesh) {
    const std::unique_ptr<Renderer> renderer = warm(manyBalls());
    recordedCalls().clear();
    ASSERT_TRUE(renderer->draw(viewpointOf(lookingAhead(), 1), target()));
    EXPECT_EQ(countCalls("DrawElements"), 24u);
    // Textured or not, double-sided or not, and blended: four programs.
    EXPECT_LE(countCalls("UseProgram"), 4u);
    EXPECT_LE(countCalls("BindTexture"), 3u) << "as many as there are textures";
    EXPECT_EQ(countCalls("DepthMask"), 2u) << "blended ones last, in one go";
}

TEST_P(DrawingTest, NoStateIsSetTwiceAndNothingIsAskedFor) {
    const Shot shot = manyBalls();
    const std::unique_ptr<Renderer> renderer = warm(shot);
    const SkyboxMap cube = encodeSkybox({Environment::Layout::Equirect, 2, 1, {{1, 1, 1}, {0, 1, 1}}}, 4);
    ASSERT_TRUE(renderer->setSkybox(&cube));
    ASSERT_TRUE(renderer->prepare());
    StateFollower follower;
    for (int frame = 0; frame < 3; ++frame) {
        Camera camera = shot.camera;
        camera.world = at(0.1f * static_cast<float>(frame), 0, 0);
        recordedCalls().clear();
        ASSERT_TRUE(renderer->draw(viewpointOf(camera, 1), target()));
        EXPECT_EQ(follower.redundant(recordedCalls()), Names()) << "frame " << frame;
        EXPECT_EQ(callsThatAsk(), Names()) << "frame " << frame;
        EXPECT_EQ(countCalls("DrawElements") + countCalls("DrawArrays"), 25u);
    }
}

TEST_P(DrawingTest, TheFollowerSeesWhatIsSetTwice) {
    const Gl table = recordingGl(gl());
    table.Enable(GL_BLEND);
    table.ActiveTexture(GL_TEXTURE1);
    table.BindTexture(GL_TEXTURE_2D, 0);
    table.ActiveTexture(GL_TEXTURE0);
    table.BindTexture(GL_TEXTURE_2D, 0);
    table.Enable(GL_BLEND);
    table.Disable(GL_BLEND);
    table.BindTexture(GL_TEXTURE_2D, 0);
    table.GetError();
    EXPECT_EQ(StateFollower().redundant(recordedCalls()).size(), 2u);
    EXPECT_EQ(callsThatAsk(), Names{"GetError"});
}

TEST_P(DrawingTest, AStillPictureOfOneObjectUploadsNothing) {
    SceneBuilder builder;
    builder.add(sphere(6), builder.addMaterial({}), at(0, 0, -4));
    builder.addSun({-1, -1, -1}, {1, 1, 1}, 3);
    const Shot shot = {
        .scene = builder.scene, .camera = lookingAhead(), .lighting = lightingOf(builder.scene)};
    const std::unique_ptr<Renderer> renderer = warm(shot);
    recordedCalls().clear();
    ASSERT_TRUE(renderer->draw(viewpointOf(shot.camera, 1), target()));
    Names names;
    for (const GlCall& call : recordedCalls())
        names.emplace_back(call.name);
    EXPECT_EQ(names, (Names{"BindFramebuffer", "Viewport", "Clear", "DrawElements"}));
}

// Serials and places are kept from frame to frame: what they say must be of this frame's camera.
TEST_P(DrawingTest, ALoneObjectFollowsTheCamera) {
    for (const AlphaMode alpha : {AlphaMode::Opaque, AlphaMode::Blend}) {
        SceneBuilder builder;
        Material material;
        material.factors.baseColor[3] = 0.5f;
        material.alphaMode = alpha;
        builder.add(sphere(6), builder.addMaterial(material), at(0, 0, -4));
        builder.addSun({-1, -1, -1}, {1, 1, 1}, 3);
        Shot shot = {.scene = builder.scene, .camera = lookingAhead(), .lighting = lightingOf(builder.scene)};
        const std::unique_ptr<Renderer> renderer = warm(shot);
        const std::vector<glm::mat4> places = {at(0.5f, 0, 0), at(0.5f, 0.4f, 0), at(0, 0, 1)};
        std::vector<Picture> pictures = {readBack()};
        for (const glm::mat4& place : places) {
            shot.camera.world = place;
            ASSERT_TRUE(renderer->draw(viewpointOf(shot.camera, 1), target()));
            pictures.push_back(readBack());
        }
        for (std::size_t i = 0; i < places.size(); ++i) {
            shot.camera.world = places[i];
            EXPECT_GT(compareLit(pictures[i + 1], pictures[i]).max(), 40) << "it moved";
            EXPECT_EQ(compareLit(draw(shot), pictures[i + 1]).max(), 0) << "as from there in the first place";
        }
    }
}

TEST_P(DrawingTest, TheSkyboxIsThereWhateverWasDrawnBefore) {
    const SkyboxMap cube =
        encodeSkybox({.width = 8, .height = 4, .texels = std::vector<glm::vec3>(32, {0, 1, 0})}, 4);
    for (const bool mirrored : {false, true})
        for (const bool doubleSided : {false, true}) {
            SceneBuilder builder;
            Material material;
            material.doubleSided = doubleSided;
            builder.add(sphere(6), builder.addMaterial(material),
                        glm::scale(at(0, 0, -6), glm::vec3(mirrored ? -1 : 1, 1, 1)));
            Shot shot = {.scene = builder.scene, .camera = lookingAhead(), .lighting = {}};
            shot.skybox = cube;
            const Picture picture = draw(shot);
            for (const std::size_t pixel : {0, 63, 64 * 63, 64 * 64 - 1})
                EXPECT_GT(picture.rgba[4 * pixel + 1], 250) << pixel << mirrored << doubleSided;
        }
}

// Of what no rasteriser of ours shows: dithering and multisampling that an engine left on.
TEST_P(DrawingTest, NothingIsLeftOnThatChangesPixels) {
    const std::unique_ptr<Renderer> renderer = warm(manyBalls());
    renderer->invalidateState();
    recordedCalls().clear();
    ASSERT_TRUE(renderer->draw(viewpointOf(lookingAhead(), 1), target()));
    std::set<GLenum> off;
    for (const GlCall& call : recordedCalls())
        if (call.name == "Disable")
            off.insert(static_cast<GLenum>(call.arguments[0]));
    for (const GLenum capability : {GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_DITHER, GL_POLYGON_OFFSET_FILL,
                                    GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_COVERAGE})
        EXPECT_TRUE(off.contains(capability)) << std::hex << capability;
}

// Mesa's drivers of the Pi compile for what a texture unit holds: units that others bound are emptied again,
// before a program without textures draws (texture_reset.h).
TEST_P(DrawingTest, TexturesOfOthersAreResetOnAPi) {
    SceneBuilder builder;
    builder.add(sphere(6), builder.addMaterial({}), at(0, 0, -4));
    Renderer renderer(recordingGl(gl()),
                      {.maxTextureSize = 2048, .maxCubeSize = 2048, .compilesForStaleTextures = true});
    ASSERT_TRUE(renderer.load(builder.scene));
    const Viewpoint viewpoint = viewpointOf(lookingAhead(), 1);
    ASSERT_TRUE(renderer.draw(viewpoint, target()));
    const auto draws = [&] {
        recordedCalls().clear();
        EXPECT_TRUE(renderer.draw(viewpoint, target()));
        return countCalls("DrawElements") + countCalls("DrawArrays");
    };
    EXPECT_EQ(draws(), 1u) << "nobody else drew";
    renderer.invalidateState();
    EXPECT_EQ(draws(), 2u) << "one that resets, and the object";
    EXPECT_EQ(draws(), 1u);
}

TEST_P(DrawingTest, InvalidateStateBringsBackWhatAnEngineChanged) {
    const Shot shot = manyBalls();
    Renderer renderer(gl());
    ASSERT_TRUE(renderer.load(shot.scene));
    renderer.setLighting(shot.lighting);
    ASSERT_TRUE(renderer.draw(viewpointOf(shot.camera, 1), target()));
    const Picture clean = readBack();
    disturbState(gl());
    renderer.invalidateState();
    ASSERT_TRUE(renderer.draw(viewpointOf(shot.camera, 1), target()));
    EXPECT_EQ(compareLit(readBack(), clean).max(), 0);
}

} // namespace
} // namespace franken::test
