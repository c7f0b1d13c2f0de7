// SPDX-License-Identifier: MIT
// Small models whose pixels can be worked out by hand, as the viewer draws them on both back ends.
#include "franken/png.h"
#include "support/gltf_builder.h"
#include "viewer_run.h"

#include <cmath>
#include <cstdint>
#include <fstream>
#include <numbers>

namespace franken::test {
namespace {

using Json = GltfBuilder::Json;
using Pixel = std::array<int, 3>;

constexpr Pixel kBlack{0, 0, 0}, kGreen{0, 255, 0};
constexpr double kPi = std::numbers::pi;

int code(double linear) {
    return static_cast<int>(std::lround(
        255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055)));
}

/// A scene in front of an orthographic camera that sees -1 to 1, in the making.
class Model : public GltfBuilder {
public:
    Model() {
        json["extensionsUsed"] = {"KHR_materials_unlit", "KHR_lights_punctual"};
        json["cameras"] = Json::array({camera()});
        addNode({{"camera", 0}, {"translation", {0, 0, 2}}});
    }

    static Json camera() {
        return {{"type", "orthographic"},
                {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0.1}, {"zfar", 10}}}};
    }
    int addNode(const Json& node) {
        const int index = append("nodes", node);
        json["scenes"][0]["nodes"].push_back(index);
        return index;
    }
    int unlit(const std::vector<double>& color) {
        return append("materials", {{"pbrMetallicRoughness", {{"baseColorFactor", color}}},
                                    {"extensions", {{"KHR_materials_unlit", Json::object()}}}});
    }
    int lit(double metallic, double roughness, double base = 1) {
        return append("materials", {{"pbrMetallicRoughness",
                                     {{"baseColorFactor", {base, base, base, 1}},
                                      {"metallicFactor", metallic},
                                      {"roughnessFactor", roughness}}}});
    }
    /// A square towards the camera; its mesh.
    int quad(int material, float half = 1) {
        const float h = half;
        return append(
            "meshes",
            {{"primitives",
              {{{"attributes",
                 {{"POSITION", floats("VEC3", {-h, -h, 0, h, -h, 0, h, h, 0, -h, h, 0})},
                  {"NORMAL", floats("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1})}}},
                {"indices", accessor("SCALAR", kUShort, std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3})},
                {"material", material}}}}});
    }
    void addSun(double lux) {
        Json& lights = json["extensions"]["KHR_lights_punctual"]["lights"];
        lights.push_back({{"type", "directional"}, {"intensity", lux}});
        addNode({{"extensions", {{"KHR_lights_punctual", {{"light", lights.size() - 1}}}}}});
    }
};

class ViewerModels : public Viewer {
protected:
    Outcome draw(const std::string& bytes, const std::string& options = "", const char* name = "model.gltf") {
        std::ofstream(m_folder / name, std::ios::binary) << bytes;
        return run(std::string(name) + " --size 64x64 " + options);
    }

    Pixel pixel(int x, int y) const {
        const Picture picture = readPicture(m_folder / "out.png");
        const std::uint8_t* const at = picture.rgba.data() + 4 * (64 * y + x);
        return {at[0], at[1], at[2]};
    }

    /// Draws on both back ends, and looks at each pixel of the list.
    void expect(const Model& model, const std::vector<std::tuple<int, int, Pixel>>& pixels,
                const std::string& options = "", int tolerance = 1) {
        for (const char* backend : {"osmesa", "egl"}) {
            const Outcome outcome = draw(model.bytes(false), options + " --backend " + backend);
            ASSERT_EQ(outcome.code, 0) << outcome.err;
            for (const auto& [x, y, wanted] : pixels)
                for (std::size_t channel = 0; channel < 3; ++channel)
                    EXPECT_NEAR(pixel(x, y)[channel], wanted[channel], tolerance)
                        << backend << " (" << x << ", " << y << ") " << outcome.err;
        }
    }
};

TEST_F(ViewerModels, AMirroredCameraSeesFrontsAndIsNotMirrored) {
    for (const std::vector<int>& scale : {std::vector{-1, 1, 1}, {1, -1, -1}, {-2, 3, 1}}) {
        Model model;
        model.json["nodes"][0] = Json::object(); // It is below another node instead.
        const int quad = model.quad(model.unlit({0, 1, 0, 1}), 0.5f);
        model.addNode({{"mesh", quad}, {"translation", {0.25, 0, 0}}});
        const int camera = model.append("nodes", {{"camera", 0}, {"translation", {0, 0, 2.0 / scale[2]}}});
        model.addNode({{"children", {camera}}, {"scale", scale}});
        if (scale[2] < 0)
            continue; // looks the other way
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

TEST_F(ViewerModels, AVariantIsDrawnByItsNameAndListed) {
    Model model;
    const int green = model.unlit({0, 1, 0, 1}), black = model.unlit({0, 0, 0, 1});
    model.json["materials"][green]["name"] = "grass";
    const int quad = model.quad(black);
    model.json["meshes"][quad]["primitives"][0]["extensions"]["KHR_materials_variants"]["mappings"] = {
        {{"material", green}, {"variants", {1}}}};
    model.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "winter"}},
                                                                      {{"name", "spring"}}};
    const int node = model.addNode({{"mesh", quad}});
    model.json["nodes"][node]["name"] = "meadow";
    expect(model, {{32, 32, kGreen}}, "--variant spring");
    expect(model, {{32, 32, kBlack}}, "--variant winter");
    const Outcome unknown = draw(model.bytes(false), "--variant autumn");
    EXPECT_EQ(unknown.code, 2);
    EXPECT_NE(unknown.err.find("winter, spring"), std::string::npos) << unknown.err;
    const Outcome list = draw(model.bytes(false), "--list");
    EXPECT_EQ(list.code, 0) << list.err;
    for (const char* line :
         {"camera 0: ", "variant 1: spring\n", "material 0: grass\n", "node 0: meadow, 2 triangles\n"})
        EXPECT_NE(list.out.find(line), std::string::npos) << line << list.out;
}

TEST_F(ViewerModels, TransparentBacksComeBeforeFronts) {
    Model model;
    const int material = model.unlit({1, 1, 1, 0.5});
    model.json["materials"][0]["alphaMode"] = "BLEND";
    model.json["materials"][0]["doubleSided"] = true;
    std::vector<float> colors;
    for (int i = 0; i < 8; ++i)
        colors.insert(colors.end(), {i < 4 ? 1.0f : 0.0f, 0, i < 4 ? 0.0f : 1.0f, 1});
    const Json front{
        {"attributes",
         {{"POSITION", model.floats("VEC3", {-1, -1, 0.5f,  1, -1, 0.5f,  1, 1, 0.5f,  -1, 1, 0.5f,
                                             -1, -1, -0.5f, 1, -1, -0.5f, 1, 1, -0.5f, -1, 1, -0.5f})},
          {"COLOR_0", model.floats("VEC4", colors)}}},
        {"indices", model.accessor("SCALAR", GltfBuilder::kUShort,
                                   std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3, 5, 4, 7, 5, 7, 6})},
        {"material", material}};
    model.addNode({{"mesh", model.append("meshes", {{"primitives", {front}}})}});
    expect(model, {{32, 32, {128, 0, 64}}});
    model.json["nodes"].back()["scale"] = {-1, 1, 1}; // which turns the windings, and what is the front
    expect(model, {{32, 32, {128, 0, 64}}});
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
    const auto isGreen = [&](int x) {
        for (int y = 0; y < 64; ++y)
            if (pixel(x, y) == kGreen)
                return true;
        return false;
    };
    const auto greenColumns = [&] {
        std::vector<int> columns;
        for (int x = 0; x < 64; ++x)
            if (isGreen(x))
                columns.push_back(x);
        return columns;
    };
    ASSERT_EQ(draw(model.bytes(false)).code, 0);
    EXPECT_TRUE(greenColumns().empty()) << "the file's camera looks between the two";
    ASSERT_EQ(draw(model.bytes(false), "--frame").code, 0);
    const std::vector<int> columns = greenColumns();
    ASSERT_FALSE(columns.empty());
    EXPECT_LT(columns.front(), 20);
    EXPECT_GT(columns.back(), 43);
    EXPECT_EQ(draw(model.bytes(false), "--frame --camera 0").code, 2);
}

TEST_F(ViewerModels, NothingToDrawIsTheFilesFault) {
    for (const char* json :
         {R"({"asset": {"version": "2.0"}})", R"({"asset": {"version": "2.0"}, "scenes": [{}]})",
          R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{}]})"}) {
        const Outcome outcome = draw(json);
        EXPECT_EQ(outcome.code, 3) << json;
        EXPECT_NE(outcome.err.find("[viewer.nothing]"), std::string::npos) << outcome.err;
        EXPECT_FALSE(std::filesystem::exists(m_folder / "out.png"));
    }
}

TEST_F(ViewerModels, APictureOfNothingSaysSo) {
    Model model;
    model.addNode({{"mesh", model.quad(model.unlit({0, 1, 0, 1}))}, {"translation", {5, 0, 0}}});
    const Outcome outside = draw(model.bytes(false));
    EXPECT_EQ(outside.code, 0);
    EXPECT_NE(outside.err.find("outside the camera's view"), std::string::npos) << outside.err;
    model.json["nodes"].back() = {{"mesh", 0}, {"rotation", {0, 1, 0, 0}}};
    const Outcome turned = draw(model.bytes(false));
    EXPECT_EQ(turned.code, 0);
    EXPECT_NE(turned.err.find("faces away"), std::string::npos) << turned.err;
    const Outcome coloured = draw(model.bytes(false), "--background 0.2,0.4,0.6");
    EXPECT_NE(coloured.err.find("faces away"), std::string::npos) << coloured.err;
    model.json["nodes"].back() = {{"mesh", 0}};
    EXPECT_EQ(draw(model.bytes(false)).err, "");
}

TEST_F(ViewerModels, ChunksOutOfPlaceAndCompressedMeshesAreRefused) {
    Model model;
    model.addNode({{"mesh", model.quad(model.unlit({0, 1, 0, 1}))}});
    const std::string whole = model.bytes(true);
    const std::size_t bin = whole.find(std::string("BIN\0", 4)) - 4;
    const std::string foreign("\4\0\0\0XXXXabcd", 12);
    std::string between = whole.substr(0, bin) + foreign + whole.substr(bin);
    between[8] = static_cast<char>(between[8] + 12);
    std::string behind = whole + foreign;
    EXPECT_EQ(draw(behind, "", "model.glb").code, 0);
    const Outcome order = draw(between, "", "model.glb");
    EXPECT_EQ(order.code, 3);
    EXPECT_NE(order.err.find("[gltf.container]"), std::string::npos) << order.err;

    Json json = Json::parse(model.bytes(false));
    json["buffers"].push_back({{"byteLength", json["buffers"][0]["byteLength"]}});
    for (Json& view : json["bufferViews"]) {
        view["buffer"] = 1;
        view["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0}, {"byteLength", 16}, {"count", 4}};
    }
    const Outcome packed = draw(json.dump());
    EXPECT_EQ(packed.code, 3);
    EXPECT_NE(packed.err.find("EXT_meshopt_compression"), std::string::npos) << packed.err;
}

TEST_F(ViewerModels, AColourArrivesInItsChannels) {
    Model model;
    model.addNode({{"mesh", model.quad(model.unlit({1, 0.2, 0, 1}))}});
    expect(model, {{32, 32, {255, code(0.2), 0}}});
}

TEST_F(ViewerModels, ASunOfTheCommandLineHasTheLuxThatItSays) {
    Model model;
    model.addNode({{"mesh", model.quad(model.lit(0, 1, 0.5))}});
    // Lambert's 0.96 base / pi, and F_0 D V of roughness 1 from straight ahead: 0.04 / (4 pi).
    const auto lit = [](double lux) { return code(lux * (0.96 * 0.5 + 0.04 / 4) / kPi); };
    expect(model, {{32, 32, {lit(2), lit(1), lit(0.5)}}}, "--sun 0,0,-1:2,1,0.5");
    expect(model, {{32, 32, {lit(kPi), lit(kPi), lit(kPi)}}}, "--sun 0,0,-3");
}

// Four samples of encoded colour, averaged: the picture of twice the size says what they are.
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

/// How many pixels of the middle row are not black: what stands nearer to the camera is wider.
int widthOf(const Picture& picture) {
    int lit = 0;
    for (int x = 0; x < picture.width; ++x)
        lit += picture.rgba[static_cast<std::size_t>(4 * (picture.height / 2 * picture.width + x)) + 1] > 0;
    return lit;
}

Image plainHeights(std::uint8_t code) { return {"heights", 1, 1, {code, code, code, 255}}; }

TEST_F(ViewerModels, MidGreyHeightsStayWhiteOnesRiseAndBlackOnesSink) {
    Model model;
    model.json["cameras"][0] = {{"type", "perspective"},
                                {"perspective", {{"yfov", 1}, {"aspectRatio", 1}, {"znear", 0.1}}}};
    model.addNode({{"mesh", model.quad(model.unlit({0, 1, 0, 1}), 0.5f)}});
    model.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] =
        model.floats("VEC2", {0, 1, 1, 1, 1, 0, 0, 0});
    const auto width = [&](const std::string& options) {
        EXPECT_EQ(draw(model.bytes(false), options).code, 0);
        return widthOf(readPicture(m_folder / "out.png"));
    };
    // 64 pixels see 2 tan(0.5) times the distance, which is 2.
    const auto expected = [](double distance) { return 64 / (2 * std::tan(0.5) * distance); };
    EXPECT_NEAR(width(""), expected(2), 1);
    for (const auto& [code, distance] : {std::pair(128, 2.0), {255, 1.5}, {0, 2.5}}) {
        ASSERT_TRUE(writePng(m_folder / "heights.png", plainHeights(static_cast<std::uint8_t>(code))));
        EXPECT_NEAR(width("--height-map heights.png --height-scale 1"), expected(distance), 1) << code;
    }
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

} // namespace
} // namespace franken::test
