// SPDX-License-Identifier: MIT
// Who encodes, and what is decoded.
#include "support/draw_scene.h"
#include "support/shapes.h"

namespace franken::test {
namespace {

constexpr platform::Size kSize = {64, 64};

/// So that square() fills the view.
void lookAtSquare(Camera& camera) {
    camera.projection = Camera::Projection::Orthographic;
    camera.zfar = 10;
    camera.world[3] = glm::vec4(0, 0, 2, 1);
}

/// A square that fills the view, whose texture is a ramp from black to white.
Shot ramp() {
    SceneBuilder builder;
    Material material;
    material.unlit = true;
    material.textures[TextureRole::BaseColor].texture =
        builder.addTexture(paint(64, [](glm::vec2 uv) { return glm::vec4(glm::vec3(uv.x), 1); }),
                           Filter::Nearest, Wrap::ClampToEdge);
    builder.add(square(), builder.addMaterial(material));
    Shot shot{.scene = builder.scene, .camera = {}, .lighting = {}};
    lookAtSquare(shot.camera);
    return shot;
}

Picture drawOn(const platform::Surface& surface, const Gl& gl, const Shot& shot) {
    drawShot(gl, surface, shot);
    Picture picture{"", kSize.width, kSize.height, std::vector<std::uint8_t>(4 * 64 * 64)};
    gl.ReadPixels(0, 0, kSize.width, kSize.height, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
    return picture;
}

/// A target that encodes, with programs that do not, shows what programs show that do.
TEST(Encoding, FollowsTheSurface) {
    std::array<Picture, 2> pictures;
    for (const bool srgb : {false, true}) {
        const auto surface =
            platform::create(platform::Backend::EglSurfaceless, {.size = kSize, .srgb = srgb});
        if (!surface && surface.error().code == "surface.not-installed")
            GTEST_SKIP() << toString(surface.error());
        ASSERT_TRUE(surface) << toString(surface.error());
        if (srgb && !(*surface)->srgbTarget())
            GTEST_SKIP() << "this driver has no sRGB pbuffer";
        EXPECT_EQ((*surface)->srgbTarget(), srgb);
        const auto gl = Gl::load((*surface)->getProcAddress());
        ASSERT_TRUE(gl);
        Shot shot = ramp();
        shot.look.srgbTarget = (*surface)->srgbTarget();
        pictures[srgb ? 1 : 0] = drawOn(**surface, *gl, shot);
    }
    const Difference difference = compare(pictures[1], pictures[0], [](int, int) { return true; });
    EXPECT_LE(difference.max(), 1) << difference;
    // The ramp comes back as it was painted: decoded once, and encoded once.
    const Picture painted = ramp().scene.images[0];
    EXPECT_LE(compare(pictures[0], painted, [](int, int) { return true; }).max(), 1);
}

class Decoding : public PictureTest {};
INSTANTIATE_TEST_SUITE_P(Backends, Decoding, allBackends(), backendName);

/// The same texels, of code 128, in every role: colours are decoded to 0.216, numbers stay 0.502.
TEST_P(Decoding, GoesByTheRoleOfATexture) {
    SceneBuilder builder;
    const int grey =
        builder.addTexture(paint(4, [](glm::vec2) { return glm::vec4(glm::vec3(128 / 255.0f), 1); }));
    Material material;
    material.textures[TextureRole::BaseColor].texture = grey;
    material.textures[TextureRole::MetallicRoughness].texture = grey;
    material.textures[TextureRole::Occlusion].texture = grey;
    material.textures[TextureRole::Emissive].texture = grey;
    material.factors.emissive = {1, 1, 1};
    builder.add(square(), builder.addMaterial(material));
    Shot shot{.scene = builder.scene, .camera = {}, .lighting = {}};
    lookAtSquare(shot.camera);
    shot.look.output = Output::Linear;
    const auto red = [&] { return static_cast<int>(draw(shot).rgba[4 * (32 * 64 + 32)]); };

    shot.look.view = View::BaseColor;
    EXPECT_EQ(red(), 55);
    shot.look.view = View::Occlusion;
    EXPECT_EQ(red(), 128);
    shot.look.view = View::Shaded;
    EXPECT_EQ(red(), 55) << "emission alone";
    shot.look.view = View::RoughnessMetallic;
    const Picture numbers = draw(shot);
    EXPECT_EQ(numbers.rgba[4 * (32 * 64 + 32) + 1], 128);
    EXPECT_EQ(numbers.rgba[4 * (32 * 64 + 32) + 2], 128);
}

} // namespace
} // namespace franken::test
