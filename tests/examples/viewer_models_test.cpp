// SPDX-License-Identifier: MIT
// What the viewer makes of a file's meshes and materials, and which files it refuses.
#include "franken/png.h"
#include "viewer_models.h"

#include <cmath>
#include <cstdint>

namespace franken::test {
namespace {

using Json = GltfBuilder::Json;

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
    model.json["nodes"].back() = {{"mesh", model.quad(model.lit(0, 1))}};
    model.addSun(0.0002);
    const Outcome dark = draw(model.bytes(false), "--background 0,0,0");
    EXPECT_NE(dark.err.find("too little light, which --exposure auto makes up for"), std::string::npos)
        << dark.err;
    EXPECT_EQ(draw(model.bytes(false), "--background 0,0,0 --exposure auto").err, "");
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

} // namespace
} // namespace franken::test
