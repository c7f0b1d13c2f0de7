// SPDX-License-Identifier: MIT
// GPUs whose fragments are 16-bit floats, on Mesa's llvmpipe: its EGL contexts compute mediump in real 16
// bits where the processor converts them (F16C), and the programs for such GPUs ask for mediump.
#include "picture_scenes.h"
#include "precision_probe.h"
#include "support/draw_scene.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

namespace franken::test {
namespace {

/// Before EGL starts: a process has one driver.
[[maybe_unused]] const int kDriver = setenv("GALLIUM_DRIVER", "llvmpipe", 1);

/// Whose highp is mediump, as lima's is.
Gl limaLike(const Gl& gl) {
    static Gl real;
    real = gl;
    Gl table = gl;
    table.ShaderSource = [](GLuint shader, GLsizei, const GLchar* const* texts, const GLint*) {
        std::string text = *texts;
        for (std::size_t at = 0; (at = text.find("highp", at)) != std::string::npos;)
            text.replace(at, 5, "mediump");
        const char* const source = text.c_str();
        real.ShaderSource(shader, 1, &source, nullptr);
    };
    return table;
}

/// In 16 bits roughness starts at 0.3, by factor and by texture.
Scene roughened(Scene scene) {
    for (Material& material : scene.materials) {
        material.factors.roughness = std::max(material.factors.roughness, kMinRoughnessFp16);
        if (const int texture = material.textures[TextureRole::MetallicRoughness].texture; texture >= 0) {
            const int image = scene.textures[static_cast<std::size_t>(texture)].image;
            std::vector<std::uint8_t>& texels = scene.images[static_cast<std::size_t>(image)].rgba;
            constexpr std::uint8_t kFloor = 77; // 0.3, up to the next code
            for (std::size_t green = 1; green < texels.size(); green += 4)
                texels[green] = std::max(texels[green], kFloor);
        }
    }
    return scene;
}

class Fp16 : public OffscreenTest {
protected:
    Fp16() : OffscreenTest({160, 120}) {}

    void SetUp() override {
        OffscreenTest::SetUp();
        if (IsSkipped() || HasFatalFailure())
            return;
        if (measuredPrecision(gl(), "mediump") != Precision::Fp16)
            GTEST_SKIP()
                << "needs a driver that computes mediump in 16 bits: Mesa's llvmpipe, on a processor with "
                   "F16C";
    }

    Picture draw(const Shot& shot, Precision precision) {
        Capabilities capabilities = Capabilities::query(gl());
        capabilities.precision = precision;
        drawShot(gl(), surface(), shot, capabilities);
        return readBack();
    }

    void expectAlike(const std::string& name, const Shot& shot);
};

INSTANTIATE_TEST_SUITE_P(Backends, Fp16, testing::Values(platform::Backend::EglSurfaceless), backendName);

std::size_t darkPixels(const Picture& actual, const Picture& expected) {
    const auto brightest = [](const Picture& picture, std::size_t at) {
        return std::max({picture.rgba[at], picture.rgba[at + 1], picture.rgba[at + 2]});
    };
    std::size_t dark = 0;
    for (std::size_t at = 0; at < actual.rgba.size(); at += 4)
        dark += brightest(expected, at) > 24 && brightest(actual, at) < 8 ? 1 : 0;
    return dark;
}

// Ten bits of a float are a quarter of a code near white; sums and roots take some of them.
void Fp16::expectAlike(const std::string& name, const Shot& shot) {
    Shot rough = shot;
    if (shot.look.view == View::Shaded) // Others show the material as it is.
        rough.scene = roughened(shot.scene);
    const Picture expected = draw(rough, Precision::Fp32);
    const Picture actual = draw(shot, Precision::Fp16);
    const Difference difference = compareLit(actual, expected);
    std::cout << name << ": " << difference << "\n";
    // A reflection is looked up by coordinates of 16 bits, a quarter of a texel at worst: the rim of a bright
    // patch is moved by that. 0.30 % of such a picture are more than 6 codes off; the goal for all others is
    // 0.1 % above 8.
    const double most = shot.lighting.reflection == Reflection::Lookup ? 0.003 : 0.001;
    EXPECT_TRUE(difference.mean <= 0.5 && difference.shareAbove(8) <= most)
        << name << ": " << difference << "\n"
        << writeDifference("fp16_" + name, actual, expected);
    EXPECT_EQ(darkPixels(actual, expected), 0u) << name;
}

TEST_P(Fp16, TheBedComputesIn16BitsWhereMediumpIsAsked) {
    EXPECT_EQ(measuredPrecision(gl(), "mediump"), Precision::Fp16);
    EXPECT_EQ(measuredPrecision(gl(), "highp"), Precision::Fp32);
}

TEST_P(Fp16, IsMeasuredWhateverTheDriverSays) {
    EXPECT_EQ(Capabilities::query(gl()).precision, Precision::Fp32);
    const Gl lima = limaLike(gl());
    GLint range[2], bits = 0;
    lima.GetShaderPrecisionFormat(GL_FRAGMENT_SHADER, GL_HIGH_FLOAT, range, &bits);
    EXPECT_EQ(bits, 23);
    EXPECT_EQ(Capabilities::query(lima).precision, Precision::Fp16);
    EXPECT_EQ(gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_P(Fp16, TheProbeLeavesTheTargetAsItWas) {
    gl().BindFramebuffer(GL_FRAMEBUFFER, surface().framebuffer());
    gl().Viewport(1, 2, 3, 4);
    Capabilities::query(gl());
    GLint bound = 0, viewport[4] = {};
    gl().GetIntegerv(GL_FRAMEBUFFER_BINDING, &bound);
    gl().GetIntegerv(GL_VIEWPORT, viewport);
    EXPECT_EQ(bound, static_cast<GLint>(surface().framebuffer()));
    EXPECT_EQ(viewport[3], 4);
}

// What the forms are for: a smooth metal by the programs for 32 bits, whose coefficients are infinite there.
TEST_P(Fp16, ProgramsFor32BitsFailThere) {
    for (const PictureRow& row : pictureRows())
        if (row.name == std::string_view("metal")) {
            Shot shot = row.make();
            shot.scene.materials[0].factors.roughness = 0.25f;
            const Picture expected = draw(shot, Precision::Fp32);
            drawShot(limaLike(gl()), surface(), shot, Capabilities::query(gl()));
            EXPECT_GT(darkPixels(readBack(), expected), 100u);
        }
}

/// As large as towns: beyond 255 units, whose square is no 16-bit float.
Shot enlarged(Shot shot, float times) {
    for (Instance& instance : shot.scene.instances)
        instance.world = glm::scale(glm::dmat4(1), glm::dvec3(times)) * instance.world;
    for (PunctualLight& light : shot.lighting.punctualLights) {
        for (double& axis : light.position)
            axis *= times;
        light.range *= times;
        light.intensity *= times * times;
    }
    shot.camera.world[3] *= glm::dvec4(times, times, times, 1);
    shot.camera.znear *= times;
    shot.camera.zfar = 0;
    return shot;
}

TEST_P(Fp16, PicturesOfFarThingsAreThoseOf32Bits) {
    for (const PictureRow& row : pictureRows())
        for (const std::string_view name : {"metal", "spots", "suns_and_punctual_lights"})
            if (row.name == name)
                for (const float times : {0.01f, 100.0f, 3000.0f})
                    expectAlike(row.name + std::string("_") + std::to_string(times),
                                enlarged(row.make(), times));
}

TEST_P(Fp16, PicturesAreThoseOf32Bits) {
    for (const PictureRow& row : pictureRows())
        expectAlike(row.name, row.make());
}

} // namespace
} // namespace franken::test
