// SPDX-License-Identifier: MIT
// How bright the viewer draws what a file, the command line or a sky lights, worked out by hand.
#include "viewer_models.h"

#include <cmath>
#include <fstream>

namespace franken::test {
namespace {

using Json = GltfBuilder::Json;

TEST_F(ViewerModels, AColourArrivesInItsChannels) {
    Model model;
    model.addNode({{"mesh", model.quad(model.unlit({1, 0.2, 0, 1}))}});
    expect(model, {{32, 32, {255, code(0.2), 0}}});
}

TEST_F(ViewerModels, AnOrthographicCamerasLampStandsWhereItIs) {
    Model model;
    Json& lights = model.json["extensions"]["KHR_lights_punctual"]["lights"];
    lights.push_back({{"type", "point"}, {"intensity", kPi}});
    model.addNode({{"translation", {0, 0, 1}}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    model.addNode({{"mesh", model.quad(model.lit(0, 1))}});
    const int middle = code(0.96 + 0.04 / 4);
    const double x = 31.5 / 32, d2 = 1 + x * x, cosine = 1 / std::sqrt(d2);
    // At the edge the highlight is 0.01 / d2 at most: the tolerance holds it.
    const int edge = code((0.96 + 0.01) * cosine / d2);
    expect(model, {{32, 32, {middle, middle, middle}}, {63, 32, {edge, edge, edge}}}, "", 3);
}

TEST_F(ViewerModels, FarFromTheOriginLampsShineAlike) {
    const auto brightness = [this](double place) {
        Model model;
        model.json["nodes"][0]["translation"] = {place, 0, 2};
        model.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}, {"intensity", 1.5}}};
        model.addNode({{"translation", {place + 0.5, 0, 1}},
                       {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
        model.addNode({{"mesh", model.quad(model.lit(0, 1))}, {"translation", {place, 0, 0}}});
        EXPECT_EQ(draw(model.bytes(false)).code, 0);
        return pixel(48, 32)[0];
    };
    EXPECT_NEAR(brightness(6378137.3), brightness(0), 1);
}

TEST_F(ViewerModels, ASunOfTheCommandLineHasTheLuxThatItSays) {
    Model model;
    model.addNode({{"mesh", model.quad(model.lit(0, 1, 0.5))}});
    // Lambert's 0.96 base / pi, and F_0 D V of roughness 1 from straight ahead: 0.04 / (4 pi).
    const auto lit = [](double lux) { return code(lux * (0.96 * 0.5 + 0.04 / 4) / kPi); };
    expect(model, {{32, 32, {lit(2), lit(1), lit(0.5)}}}, "--sun 0,0,-1:2,1,0.5");
    expect(model, {{32, 32, {lit(kPi), lit(kPi), lit(kPi)}}}, "--sun 0,0,-3");
}

// A black sky with one bright texel of 64 x 32 behind the camera: taken out, it lights as a sun of radiance
// times solid angle.
TEST_F(ViewerModels, ASkysSunIsTakenOutAndLights) {
    std::ofstream sky(m_folder / "sky.hdr", std::ios::binary);
    sky << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32 +X 64\n";
    for (int i = 0; i < 64 * 32; ++i)
        sky.write(i == 16 * 64 ? "\x40\x40\x40\x8a" : "\0\0\0\0", 4);
    sky.close();
    Model model;
    model.addNode({{"mesh", model.quad(model.lit(0, 1))}});
    constexpr double kRadiance = 256; // 64 * 2^(0x8a - 136)
    const double texel = kPi / 32, illuminance = kRadiance * texel * texel;
    const int grey = code((0.96 + 0.04 / 4) * illuminance / kPi);
    expect(model, {{32, 32, {grey, grey, grey}}}, "--skybox sky.hdr --sky-sun", 3);
}

TEST_F(ViewerModels, ASunOf683LuxIsExposed) {
    Model model;
    model.addSun(683);
    model.addNode({{"mesh", model.quad(model.lit(0, 1, 0.18))}});
    const Outcome asIs = draw(model.bytes(false));
    EXPECT_EQ(asIs.code, 0);
    EXPECT_NE(asIs.err.find("--exposure auto"), std::string::npos) << asIs.err;
    const Pixel exposed = pixel(32, 32);
    EXPECT_NEAR(exposed[0], code(0.18 * 0.96 + 0.01), 2);
    EXPECT_EQ(draw(model.bytes(false), "--exposure auto").err, "");
    EXPECT_EQ(pixel(32, 32), exposed) << "the same lights give the same picture";
    EXPECT_EQ(draw(model.bytes(false), "--exposure 1").err, "");
    EXPECT_EQ(pixel(32, 32), (Pixel{255, 255, 255}));
    EXPECT_EQ(draw(model.bytes(false), "--exposure bright").code, 2);

    Model white; // which no exposure makes darker
    white.addSun(683);
    white.addNode({{"mesh", white.quad(white.unlit({1, 1, 1, 1}))}});
    EXPECT_EQ(draw(white.bytes(false)).err, "");
}

// Four samples of encoded colour, averaged: the picture of twice the size says what they are.
TEST_F(ViewerModels, SupersamplingAveragesFourPixels) {
    Model model;
    model.addNode({{"mesh", model.quad(model.unlit({0, 1, 0, 1}), 0.61f)}, {"rotation", {0, 0, 0.3, 0.954}}});
    ASSERT_EQ(draw(model.bytes(false), "--supersample").code, 0);
    const Picture small = readPicture(m_folder / "out.png");
    ASSERT_EQ(run("model.gltf --size 128x128").code, 0);
    const Picture large = readPicture(m_folder / "out.png");
    const auto green = [](const Picture& picture, int x, int y) {
        return int{picture.rgba[static_cast<std::size_t>(4 * (y * picture.width + x) + 1)]};
    };
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            EXPECT_NEAR(green(small, x, y),
                        (green(large, 2 * x, 2 * y) + green(large, 2 * x + 1, 2 * y) +
                         green(large, 2 * x, 2 * y + 1) + green(large, 2 * x + 1, 2 * y + 1)) /
                            4.0,
                        0.5);
}

// A white that no exposure changes, and a dark stone that a lesser one would make darker.
TEST_F(ViewerModels, AnExposureThatIsNotTakenLeavesNoPictureDarker) {
    Model model;
    model.addSun(683);
    model.addNode({{"mesh", model.quad(model.unlit({1, 1, 1, 1}))}});
    model.addNode({{"mesh", model.quad(model.lit(1, 1, 2e-3), 0.4f)}, {"translation", {0, 0, 0.1}}});
    const auto second = [&](const std::string& options) {
        EXPECT_EQ(draw(model.bytes(false), "--turntable 12 " + options).code, 0);
        return readPicture(m_folder / "out-02.png").rgba;
    };
    EXPECT_EQ(second(""), second("--exposure 1"));
    EXPECT_NE(second(""), second("--exposure auto")) << "which would be seen";
}

} // namespace
} // namespace franken::test
