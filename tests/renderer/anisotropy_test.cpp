// SPDX-License-Identifier: MIT
// Textures that are seen at a slant.
#include "franken/mipmap.h"
#include "model_fixture.h"
#include "support/gl_recorder.h"
#include "support/shapes.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>
#include <limits>

namespace franken::test {
namespace {

/// A floor with stripes away from the eye, which lies down before it.
Scene floorWithStripes() {
    SceneBuilder builder;
    Material material;
    material.unlit = true;
    material.textures[TextureRole::BaseColor].texture = builder.addTexture(paint(
        256, [](glm::vec2 uv) { return glm::vec4(glm::vec3(std::fmod(uv.x * 32, 2.0f) < 1 ? 1 : 0), 1); }));
    const glm::mat4 world = glm::rotate(glm::mat4(1), glm::radians(-86.0f), glm::vec3(1, 0, 0));
    builder.add(square(), builder.addMaterial(material), world);
    return builder.scene;
}

class AnisotropyTest : public ModelFixture {
protected:
    /// How much codes differ from their means in rows that show the floor: 0 where stripes are grey.
    double contrast(Renderer& renderer) {
        const Picture picture = drawn(renderer);
        double sum = 0, squares = 0;
        int count = 0;
        for (int y = 31; y < 34; ++y)
            for (int x = 22; x < 42; ++x, ++count) {
                const double code = picture.rgba[4 * (64 * y + x)];
                sum += code, squares += code * code;
            }
        return std::sqrt(squares / count - sum * sum / count / count);
    }

    static std::size_t settings() { return countCalls("TexParameterf"); }
};

INSTANTIATE_TEST_SUITE_P(Backends, AnisotropyTest, allBackends(), backendName);

TEST_P(AnisotropyTest, StripesStaySharpAtASlant) {
    if (Capabilities::query(gl()).maxAnisotropy < 8)
        GTEST_SKIP() << "this driver has no GL_EXT_texture_filter_anisotropic";
    const Scene scene = floorWithStripes();
    Renderer renderer(recordingGl(gl()));
    ASSERT_TRUE(renderer.load(scene, [&] { return Result<Scene>(scene); }));
    const double plain = contrast(renderer);
    renderer.setLook({.anisotropy = 8});
    recordedCalls().clear();
    const double sharp = contrast(renderer);
    EXPECT_EQ(settings(), 1u);
    EXPECT_GT(sharp, 2 * plain + 10) << plain;
    EXPECT_EQ(contrast(renderer), sharp);
    EXPECT_EQ(settings(), 1u) << "once, not in each frame";

    // It outlasts what is uploaded anew.
    const ModelId model = *renderer.add(scene);
    ASSERT_TRUE(renderer.show({{model}}, Wait::Yes));
    EXPECT_EQ(contrast(renderer), sharp);
    const Image smaller = mipmaps(scene.images[0], TextureContents::Color)[0];
    ASSERT_TRUE(renderer.setTexture(model, 0, smaller));
    EXPECT_GT(contrast(renderer), 2 * plain);
    ASSERT_TRUE(renderer.load(scene, [&] { return Result<Scene>(scene); }));
    EXPECT_EQ(contrast(renderer), sharp);
    replaceContext({64, 64});
    renderer.contextLost();
    ASSERT_TRUE(renderer.restore(gl()));
    EXPECT_EQ(contrast(renderer), sharp);
    renderer.setLook({});
    EXPECT_EQ(contrast(renderer), plain);
}

TEST_P(AnisotropyTest, IsLimitedToWhatTheContextHas) {
    Capabilities without = Capabilities::query(gl());
    without.maxAnisotropy = 1;
    Renderer renderer(recordingGl(gl()), without);
    ASSERT_TRUE(renderer.load(floorWithStripes()));
    recordedCalls().clear();
    const double plain = contrast(renderer);
    for (const float asked : {16.0f, 0.0f, -3.0f, std::numeric_limits<float>::quiet_NaN(),
                              std::numeric_limits<float>::infinity()}) {
        renderer.setLook({.anisotropy = asked});
        EXPECT_EQ(contrast(renderer), plain);
    }
    EXPECT_EQ(settings(), 0u);
    const float most = Capabilities::query(gl()).maxAnisotropy;
    Renderer limited(gl());
    ASSERT_TRUE(limited.load(floorWithStripes()));
    limited.setLook({.anisotropy = std::numeric_limits<float>::infinity()});
    const double sharp = contrast(limited);
    limited.setLook({.anisotropy = most});
    EXPECT_EQ(contrast(limited), sharp);
    EXPECT_EQ(gl().GetError(), GLenum{GL_NO_ERROR});
}

} // namespace
} // namespace franken::test
