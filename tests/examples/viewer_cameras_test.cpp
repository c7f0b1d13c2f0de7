// SPDX-License-Identifier: MIT
// What a file's cameras see, and that --frame needs none of them.
#include "franken/viewpoint.h"
#include "viewer_models.h"

#include <cmath>

namespace franken::test {
namespace {

using Json = GltfBuilder::Json;

/// Where a picture of 64 x 64 pixels shows a point; x to the right and y down.
glm::dvec2 inPicture(const Viewpoint& viewpoint, const glm::dvec3& point) {
    const glm::dvec4 clip = viewpoint.viewProjection * glm::dvec4(point, 1);
    return {32 * (1 + clip.x / clip.w), 32 * (1 - clip.y / clip.w)};
}

TEST_F(ViewerModels, AMirroredCameraSeesFrontsAndIsNotMirrored) {
    for (const std::vector<int>& scale : {std::vector{-1, 1, 1}, {-2, 3, 1}}) {
        Model model;
        model.json["nodes"][0] = Json::object(); // It is below another node instead.
        const int quad = model.quad(model.unlit({0, 1, 0, 1}), 0.5f);
        model.addNode({{"mesh", quad}, {"translation", {0.25, 0, 0}}});
        const int camera = model.append("nodes", {{"camera", 0}, {"translation", {0, 0, 2.0 / scale[2]}}});
        model.addNode({{"children", {camera}}, {"scale", scale}});
        expect(model, {{50, 32, kGreen}, {20, 32, kBlack}});
    }
}

TEST_F(ViewerModels, AnOrthographicCamerasLinesOfSightAreParallel) {
    Model model;
    model.addSun(kPi);
    model.addNode({{"mesh", model.quad(model.lit(1, 0.5))}});
    const double alpha2 = 0.0625; // D = 1 / (pi alpha^2) and V = 1/4 where N, V and L are one
    const int wanted = code(0.2 * kPi / (kPi * alpha2) * 0.25);
    const Pixel grey{wanted, wanted, wanted};
    expect(model, {{32, 32, grey}, {2, 32, grey}, {61, 61, grey}, {2, 2, grey}}, "--exposure 0.2");
}

TEST_F(ViewerModels, FarFromTheOriginThingsStandWhereTheyAre) {
    for (const double place : {0.0, 6378137.25, -4131346.164399078}) {
        Model model;
        model.json["nodes"][0]["translation"] = {place, -place, place + 2};
        model.addNode({{"mesh", model.quad(model.unlit({0, 1, 0, 1}), 0.25f)},
                       {"translation", {place + 0.3, 0.2 - place, place}}});
        // 0.05 to 0.55 and -0.05 to 0.45: columns 33.6 to 49.6, rows 17.6 to 33.6
        expect(model, {{35, 26, kGreen},
                       {48, 26, kGreen},
                       {32, 26, kBlack},
                       {51, 26, kBlack},
                       {40, 19, kGreen},
                       {40, 32, kGreen},
                       {40, 16, kBlack},
                       {40, 35, kBlack}});
    }
}

// The camera's own planes leave 32 bits of depth steps of 6 mm at 5 m; the two squares are 2 mm apart, and
// either is drawn first.
TEST_F(ViewerModels, ClippingPlanesThatAreFarApartLeaveNoFlicker) {
    for (const bool nearerFirst : {false, true}) {
        Model model;
        model.json["cameras"] = {
            {{"type", "perspective"},
             {"perspective", {{"yfov", 0.5}, {"aspectRatio", 1}, {"znear", 1e-6}, {"zfar", 1e5}}}}};
        for (const bool nearer : {nearerFirst, !nearerFirst}) {
            const int material =
                model.unlit(nearer ? std::vector<double>{0, 1, 0, 1} : std::vector<double>{1, 0, 0, 1});
            model.addNode({{"mesh", model.quad(material)}, {"translation", {0, 0, nearer ? -3 : -3.002}}});
        }
        expect(model, {{32, 32, kGreen}, {20, 40, kGreen}, {44, 24, kGreen}});
    }
}

TEST_F(ViewerModels, CamerasGoByTheFilesNumbersAndByTheirNodes) {
    Model model;
    model.json["cameras"] = {Model::camera(), Model::camera()};
    model.json["cameras"][0]["name"] = "A";
    model.json["nodes"][0] = {{"camera", 1}, {"name", "far"}, {"translation", {10, 0, 2}}};
    model.addNode({{"camera", 0}, {"name", "near"}, {"translation", {0, 0, 2}}});
    model.addNode({{"mesh", model.quad(model.unlit({0, 1, 0, 1}))}});
    model.addNode({{"mesh", model.quad(model.unlit({1, 0, 0, 1}))}, {"translation", {10, 0, 0}}});
    const Pixel red{255, 0, 0};
    for (const char* first : {"", "--camera 0", "--camera A", "--camera near"})
        expect(model, {{32, 32, kGreen}}, first);
    for (const char* second : {"--camera 1", "--camera far"})
        expect(model, {{32, 32, red}}, second);
    const Outcome outcome = draw(model.bytes(false), "--camera 2");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("0 A (node near)"), std::string::npos) << outcome.err;
}

// A file's camera may cut off a part of the model, as here all of it: --frame shows the model all the same.
TEST_F(ViewerModels, FramingShowsAllOfTheModelAndNotWhatTheFilesCameraSees) {
    Model model;
    const int green = model.unlit({0, 1, 0, 1});
    for (const double x : {-8, 8})
        model.addNode({{"mesh", model.quad(green)}, {"translation", {x, 0, 0}}});
    ASSERT_EQ(draw(model.bytes(false)).code, 0);
    const Picture between = readPicture(m_folder / "out.png");
    int shown = 0;
    for (std::size_t i = 0; i < between.rgba.size(); i += 4)
        shown += between.rgba[i + 1] > 0;
    EXPECT_EQ(shown, 0) << "the file's camera looks between the two";

    const Viewpoint framing = viewpointOf(framingCamera({{-9, -1, 0}, {9, 1, 0}}, 1), 1);
    std::vector<std::tuple<int, int, Pixel>> corners;
    for (const double x : {-9, -7, 7, 9})
        for (const double y : {-1, 1}) {
            const glm::dvec2 corner = inPicture(framing, {x, y, 0});
            EXPECT_TRUE(corner.x >= 0 && corner.x <= 64 && corner.y >= 0 && corner.y <= 64) << x << ", " << y;
            const double middle = x < 0 ? -8 : 8;
            const glm::dvec2 inside = inPicture(framing, {middle + 0.7 * (x - middle), 0.7 * y, 0});
            corners.emplace_back(static_cast<int>(inside.x), static_cast<int>(inside.y), kGreen);
        }
    expect(model, corners, "--frame");
    EXPECT_EQ(draw(model.bytes(false), "--frame --camera 0").code, 2);
}

} // namespace
} // namespace franken::test
