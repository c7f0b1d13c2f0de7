// SPDX-License-Identifier: MIT
// Skins as exporters write them, whose vertices tests/assets compares with numbers: programs and the CPU draw
// one picture of each, at rest and in a pose.
#include "franken/gltf.h"
#include "support/draw_scene.h"
#include "support/odd_skins.h"
#include "support/shell.h"

#include <gtest/gtest.h>

#include <cmath>

namespace franken::test {
namespace {

constexpr int kSize = 96;

class OddSkinsTest : public PictureTest {
protected:
    OddSkinsTest() : PictureTest({kSize, kSize}) {}

    Picture drawn(const Scene& scene, const Pose& pose, std::optional<Joints> joints) {
        Renderer renderer(gl(), Capabilities{.maxTextureSize = 2048, .maxCubeSize = 2048, .joints = joints});
        renderer.setLighting({.suns = {{.direction = {-0.3f, -0.4f, -1}, .illuminance = 3}},
                              .ambient = {.kind = Ambient::Color, .color = {0.2f, 0.2f, 0.2f}}});
        const Result<ModelId> model = renderer.add(scene);
        EXPECT_TRUE(model && renderer.show({{*model}}, Wait::Yes));
        EXPECT_TRUE(renderer.setPose(*renderer.firstPlace(*model), pose));
        Camera camera;
        camera.world[3] = {0, 1, 7, 1};
        const Result<void> result =
            renderer.draw(viewpointOf(camera, 1),
                          {.framebuffer = surface().framebuffer(), .width = kSize, .height = kSize});
        EXPECT_TRUE(result) << toString(result.error());
        return readBack();
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, OddSkinsTest, allBackends(), backendName);

TEST_P(OddSkinsTest, ProgramsDrawWhatTheCpuDraws) {
    const std::filesystem::path file = emptyTestFolder() / "odd.glb";
    for (const OddSkin& odd : oddSkins()) {
        SCOPED_TRACE(odd.name);
        std::ofstream(file, std::ios::binary) << odd.file.bytes(true);
        const Result<Scene> scene = loadGltf(file);
        ASSERT_TRUE(scene) << toString(scene.error());
        Pose pose = restPose(*scene);
        for (const double turn : {0.0, kTurn}) {
            for (std::size_t node = 0; turn != 0 && node < pose.nodes.size(); ++node)
                if (scene->nodes[node].index == odd.turned)
                    pose.nodes[node].local.rotation =
                        glm::dquat(std::cos(turn / 2), 0, 0, std::sin(turn / 2));
            const Picture cpu = drawn(*scene, pose, std::nullopt);
            for (const Joints joints : {Joints::UpTo32, Joints::UpTo256}) {
                const Picture picture = drawn(*scene, pose, joints);
                const Difference difference = compareLit(picture, cpu);
                EXPECT_GT(difference.pixels, 100u);
                EXPECT_LE(difference.shareAbove(1), 0.001) << writeDifference("odd_skin", picture, cpu);
            }
        }
    }
}

} // namespace
} // namespace franken::test
