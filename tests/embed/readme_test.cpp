// SPDX-License-Identifier: MIT
// The C++ of the handbook and of the pages of generator and lib/renderer, compiled and run as it is printed.
// What a block takes for granted is declared above it.
#include "franken/baked_sky.h"
#include "franken/complete.h"
#include "franken/file_writer.h"
#include "franken/generator/compose.h" // The block's own include then does nothing inside a function.
#include "franken/gltf.h"
#include "franken/manifest.h"
#include "franken/orbit_camera.h"
#include "franken/overlay_text.h"
#include "franken/ray_through.h"
#include "support/draw_scene.h"
#include "support/font_builder.h"
#include "support/shapes.h"
#include "support/shell.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <numbers>

namespace franken::test {
namespace {

/// The process works there for a while: blocks name files as a reader would.
class WorkingFolder {
public:
    explicit WorkingFolder(const std::filesystem::path& folder) { std::filesystem::current_path(folder); }
    ~WorkingFolder() { std::filesystem::current_path(m_before); }
    WorkingFolder(const WorkingFolder&) = delete;
    WorkingFolder& operator=(const WorkingFolder&) = delete;

private:
    std::filesystem::path m_before = std::filesystem::current_path();
};

void report(const Error& error) { FAIL() << toString(error); }

template<typename Value>
void report(const Result<Value>& result) {
    if (!result)
        report(result.error());
}

class Readme : public PictureTest {
protected:
    Readme() : PictureTest({32, 32}) {
        m_builder.add(square(), m_builder.addMaterial({}));
        m_builder.addSun({0, 0, -1}, {1, 1, 1}, 1);
    }

    const Scene& scene() const { return m_builder.scene; }
    DrawTarget target() { return {surface().framebuffer(), 32, 32}; }

private:
    SceneBuilder m_builder;
};

INSTANTIATE_TEST_SUITE_P(Backends, Readme, allBackends(), backendName);

TEST(GeneratorReadme, ComposesAProgramFromItsName) {
#include "blocks/generator/the-generator.inc"
    EXPECT_NE(program.vertex.text.find("void main()"), std::string::npos);
    EXPECT_NE(program.fragment.text.find("gl_FragColor"), std::string::npos);
}

TEST_P(Readme, ASkyLightsAndIsSeen) {
    const std::filesystem::path folder = emptyTestFolder();
    ASSERT_EQ(runIn(folder, MAKE_MODEL " lake.hdr && " BAKE " lake.hdr --sun -o lake.sky").code, 0);
    const WorkingFolder there(folder);
    Renderer renderer(gl());
    ASSERT_TRUE(renderer.load(scene()));
    Lighting lighting;
#include "blocks/toolchains/docs/handbook/in-an-application.inc"
    ASSERT_TRUE(sky->sun);
    EXPECT_EQ(lighting.suns.size(), 1u);
    renderer.setLighting(lighting);
    const Camera camera = framingCamera(scene().bounds(), 1);
    ASSERT_TRUE(renderer.draw(viewpointOf(camera, 1), target()));
    const ReadBack picture = readBack();
    EXPECT_GT(picture.pixel(16, 16)[1], 0) << "the sky lights the square";
    EXPECT_GT(picture.pixel(0, 0)[2], 0) << "the sky is behind it";
}

TEST_P(Readme, AnEngineFeedsAProgramOfTheCache) {
    const GetProcAddress getProcAddress = surface().getProcAddress();
    const Float16 modelViewProjection = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
#include "blocks/toolchains/docs/handbook/programs-at-run-time.inc"
    constexpr float kCorners[] = {-1, -1, 1, -1, -1, 1, 1, 1};
    const auto position = static_cast<GLuint>(attributeLocation("aPosition"));
    gl->EnableVertexAttribArray(position);
    gl->VertexAttribPointer(position, 2, GL_FLOAT, GL_FALSE, 0, kCorners);
    gl->VertexAttrib3f(static_cast<GLuint>(attributeLocation("aNormal")), 0, 0, 1);
    gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    EXPECT_EQ(gl->GetError(), 0u);
    const auto pixel = readBack().pixel(16, 16);
    EXPECT_GT(pixel[0], 240) << "3 lux and the ambient light, on a surface that reflects all red";
    EXPECT_GT(pixel[0], pixel[1]);
    EXPECT_GT(pixel[1], pixel[2]);
    EXPECT_GT(pixel[2], 40);
}

TEST_P(Readme, ThingsChange) {
    Scene scene = this->scene();
    Material red;
    red.factors.baseColor = {1, 0, 0, 1};
    scene.materials.push_back(red);
    scene.images.push_back(checkers(4, 2, glm::vec4(1), glm::vec4(0)));
    scene.textures.push_back({.image = 0});
    scene.materials[0].textures[TextureRole::BaseColor].texture = 0;
    scene.variants = {"red"};
    scene.meshes[0].primitives[0].variantMaterials = {1};
    const SceneSource reload = [&] { return Result<Scene>(scene); };
    Renderer renderer(gl());
    Lighting lighting = lightingOf(scene);
    const Camera camera = framingCamera(scene.bounds(), 1);
    DrawTarget target = this->target();
    const Image dial = checkers(16, 4, glm::vec4(1), glm::vec4(0)),
                needle = checkers(8, 2, glm::vec4(1), glm::vec4(0));
    const std::filesystem::path ttf = emptyTestFolder() / "sound.ttf";
    ASSERT_TRUE(writeFile(ttf, soundFont().bytes()));
    GLuint video = 0;
    gl().GenTextures(1, &video);
    gl().BindTexture(GL_TEXTURE_2D, video);
#include "blocks/lib/renderer/things-that-change.inc"
    EXPECT_TRUE(hit && *hit) << "the square is in the middle";
    EXPECT_NEAR(orbit.orbit().yaw, OrbitCamera(camera, scene.bounds()).orbit().yaw - 0.1 * std::numbers::pi,
                1e-9);
    EXPECT_EQ(table->materials.size(), 1u);
    EXPECT_EQ(renderer.frameCounters().drawn, 2u);
    const ReadBack picture = readBack();
    EXPECT_GT(picture.pixel(8, 16)[0], 40) << "one lux on a rough metal";
    EXPECT_LT(picture.pixel(8, 16)[2], picture.pixel(8, 16)[0]) << "red or orange";
}

// By the code of the page, and as a scene that is posed for good.
TEST_P(Readme, WhatMoves) {
    const std::filesystem::path folder = emptyTestFolder();
    ASSERT_EQ(runIn(folder, MAKE_MODEL " flower.glb flower").code, 0);
    const WorkingFolder there(folder);
    Scene scene = *loadGltf("flower.glb");
    const Lighting lighting = lightingOf(scene);
    const Viewpoint viewpoint = viewpointOf(scene.cameras.at(0), 1);
    const auto drawn = [&](Renderer& renderer) {
        renderer.setLighting(lighting);
        EXPECT_TRUE(renderer.draw(viewpoint, target()));
        return readBack();
    };
    const auto posed = [&](double seconds) {
        Renderer renderer(gl());
        [&] {
#include "blocks/what-moves.inc"
        }();
        return drawn(renderer);
    };
    const Picture noon = posed(4), night = posed(8);
    EXPECT_GT(compareLit(noon, night).mean, 5) << "it has moved";
    Pose midnight;
    ASSERT_TRUE(sample(scene, 0, 0, midnight));
    ASSERT_TRUE(applyPose(scene, midnight));
    Renderer renderer(gl());
    ASSERT_TRUE(renderer.load(scene));
    EXPECT_LE(compareLit(night, drawn(renderer)).shareAbove(1), 0.01) << "8 s later it is as at 0 s";
}

TEST_P(Readme, AKioskWarmsUpFromItsManifestAndKeepsItsMisses) {
    const std::filesystem::path stateFolder = emptyTestFolder();
    const Log log;
    const Look look;
    std::vector<Lighting> lightsOnAndOff(2);
    lightsOnAndOff[1] = lightingOf(scene());
    std::size_t steps = 0;
    const auto showProgress = [&](std::size_t, std::size_t) { ++steps; };
    Renderer renderer(gl());
    ASSERT_TRUE(renderer.load(scene()));
    const Scene& scene = this->scene();
    const DrawTarget target = this->target();
    const auto run = [&] {
#include "blocks/lib/renderer/months-without-a-stutter.inc"
        return uses.size();
    };
    EXPECT_EQ(run(), 2u) << "at the first start there is no manifest: what the scene needs, lit and unlit";
    EXPECT_GT(steps, 0u);

    renderer.setLighting(lightsOnAndOff[1]);
    renderer.setLook({.toneMap = ToneMap::Neutral}); // Nobody warmed this up: a miss.
    ASSERT_TRUE(renderer.draw(viewpointOf(framingCamera(scene.bounds(), 1), 1), target));
    run();
    EXPECT_EQ(run(), 3u) << "the next start knows what was missed";
}

} // namespace
} // namespace franken::test
