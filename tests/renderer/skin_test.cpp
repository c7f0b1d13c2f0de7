// SPDX-License-Identifier: MIT
// Skins that programs move, whole or in parts, and skins that the CPU moves: one picture.
#include "franken/generator/pack.h"
#include "support/draw_scene.h"
#include "support/gl_recorder.h"
#include "support/snake.h"

#include <gtest/gtest.h>

#include <string_view>

namespace franken::test {
namespace {

constexpr int kSize = 128;

Capabilities capabilitiesWith(std::optional<Joints> joints) {
    return {.maxTextureSize = 2048, .maxCubeSize = 2048, .wideIndices = true, .joints = joints};
}

/// A driver that compiles no palette.
Gl withoutPalettes(const Gl& real) {
    static Gl driver;
    driver = real;
    Gl gl = real;
    gl.ShaderSource = [](GLuint shader, GLsizei count, const GLchar* const* texts, const GLint* lengths) {
        const GLchar* const broken = "void main() { broken }";
        const std::string_view text =
            lengths == nullptr ? texts[0] : std::string_view(texts[0], static_cast<std::size_t>(lengths[0]));
        if (text.find("uJoints") != text.npos)
            return driver.ShaderSource(shader, 1, &broken, nullptr);
        driver.ShaderSource(shader, count, texts, lengths);
    };
    return gl;
}

class SkinTest : public PictureTest {
protected:
    SkinTest() : PictureTest({kSize, kSize}) {}

    Picture frame(Renderer& renderer) {
        Camera camera;
        camera.world[3] = {0, 0, 7, 1};
        const Result<void> result =
            renderer.draw(viewpointOf(camera, 1),
                          {.framebuffer = surface().framebuffer(), .width = kSize, .height = kSize});
        EXPECT_TRUE(result) << toString(result.error());
        return readBack();
    }

    /// At rest, or in a pose where `amount` is not 0.
    Picture drawn(const Gl& gl, const Snake& snake, std::optional<Joints> joints, double amount) {
        const Scene scene = sceneOf(snake);
        Renderer renderer(gl, capabilitiesWith(joints));
        renderer.setLighting(lightingOf(scene));
        const ModelId model = *renderer.add(scene);
        EXPECT_TRUE(renderer.show({{model}}, Wait::Yes));
        if (amount != 0) {
            EXPECT_TRUE(renderer.setPose(*renderer.firstPlace(model), bent(scene, snake, amount)));
        }
        frame(renderer);
        m_uploads = countCalls("BufferSubData");
        recordedCalls().clear();
        const Picture again = frame(renderer);
        m_draws = countCalls("DrawElements");
        return again;
    }

    std::size_t m_uploads = 0; ///< Of the last drawn(): pieces of buffers in the first frame.
    std::size_t m_draws = 0;   ///< And draws in the second.
};

INSTANTIATE_TEST_SUITE_P(Backends, SkinTest, allBackends(), backendName);

void expectSame(const std::string& name, const Picture& actual, const Picture& expected) {
    const Difference difference = compareLit(actual, expected);
    EXPECT_GT(difference.pixels, 500u);
    EXPECT_LE(difference.shareAbove(1), 0.001) << writeDifference(name, actual, expected);
}

TEST_P(SkinTest, ProgramsPartsAndTheCpuDrawOnePicture) {
    for (const Snake& snake : {Snake{1, 5}, Snake{2, 40}, Snake{3, 40, true}, Snake{4, 70},
                               Snake{4, 300, false, false, 90}, Snake{2, 9, true, true}})
        for (const double amount : {0.0, 1.0}) {
            SCOPED_TRACE(testing::Message() << snake << ", bent by " << amount);
            const Picture cpu = drawn(gl(), snake, std::nullopt, amount);
            const Gl recorded = recordingGl(gl());
            for (const Joints joints : {Joints::UpTo32, Joints::UpTo64, Joints::UpTo256}) {
                recordedCalls().clear();
                const Picture picture = drawn(recorded, snake, joints, amount);
                expectSame("skin", picture, cpu);
                const auto room = static_cast<int>(roomFor(joints));
                EXPECT_EQ(m_draws > 1, snake.joints > room) << "in parts";
                EXPECT_EQ(m_uploads, snake.target ? m_draws : 0) << "morphed on the CPU alone";
            }
        }
}

// With the picture of the program that it stands for.
TEST_P(SkinTest, AProgramThatIsRefusedIsStillPosed) {
    const Snake snake{4, 20};
    const Picture expected = drawn(gl(), snake, Joints::UpTo256, 0.7);
    expectSame("skin_refused", drawn(withoutPalettes(gl()), snake, Joints::UpTo256, 0.7), expected);
    expectSame("skin_refused_at_rest", drawn(withoutPalettes(gl()), snake, Joints::UpTo256, 0),
               drawn(gl(), snake, Joints::UpTo256, 0));
}

TEST_P(SkinTest, PlacesHavePosesOfTheirOwnThatOutlastTheContext) {
    const Snake snake{3, 40};
    const Scene scene = sceneOf(snake);
    const glm::dmat4 right = glm::dmat4(glm::dvec4(-0.5, 0, 0, 0), glm::dvec4(0, 0.5, 0, 0),
                                        glm::dvec4(0, 0, 0.5, 0), glm::dvec4(1.2, 0, 0, 1));
    std::vector<Picture> pictures;
    const Gl recorded = recordingGl(gl());
    for (const std::optional<Joints> joints : {std::optional<Joints>(), std::optional(Joints::UpTo32)}) {
        Renderer renderer(recorded, capabilitiesWith(joints));
        renderer.setLighting(lightingOf(scene));
        const ModelId model = *renderer.add(scene, [&] { return Result<Scene>(scene); });
        ASSERT_TRUE(renderer.show({{model}}, Wait::Yes));
        const PlaceId first = *renderer.firstPlace(model), second = *renderer.addPlace(model, right);
        ASSERT_TRUE(renderer.setPose(first, bent(scene, snake, 0.4)));
        ASSERT_TRUE(renderer.setPose(second, bent(scene, snake, -0.8)));
        pictures.push_back(frame(renderer));
        renderer.contextLost();
        ASSERT_TRUE(renderer.restore(recorded, capabilitiesWith(joints)));
        expectSame("skin_restored", frame(renderer), pictures.back());
    }
    expectSame("skin_places", pictures[1], pictures[0]);
}

TEST_P(SkinTest, AnUnchangedPoseIsNotUploadedAgain) {
    const Snake snake{4, 20};
    const Scene scene = sceneOf(snake);
    const Gl recorded = recordingGl(gl());
    Renderer renderer(recorded, capabilitiesWith(Joints::UpTo256));
    renderer.setLighting(lightingOf(scene));
    const ModelId model = *renderer.add(scene);
    ASSERT_TRUE(renderer.show({{model}}, Wait::Yes));
    const PlaceId place = *renderer.firstPlace(model);
    ASSERT_TRUE(renderer.setPose(place, bent(scene, snake, 0.5)));
    frame(renderer);
    recordedCalls().clear();
    frame(renderer);
    EXPECT_EQ(countCalls("Uniform4fv"), 0u);
    ASSERT_TRUE(renderer.setPose(place, bent(scene, snake, 0.6)));
    frame(renderer);
    EXPECT_EQ(countCalls("Uniform4fv"), 1u) << "the palette";
}

} // namespace
} // namespace franken::test
