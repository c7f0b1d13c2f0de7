// SPDX-License-Identifier: MIT
// Pictures of an animation, or all around, side by side in one.
#include "support/gltf_builder.h"
#include "viewer_run.h"

#include <array>
#include <cstdint>

namespace franken::test {
namespace {

using Json = GltfBuilder::Json;
namespace fs = std::filesystem;

/// The part of a strip that one of its pictures takes, the first being 0.
Picture partOf(const Picture& strip, int number, int width) {
    Picture part{.name = "", .width = width, .height = strip.height, .rgba = {}};
    for (int y = 0; y < strip.height; ++y)
        for (int x = 0; x < 4 * width; ++x)
            part.rgba.push_back(
                strip.rgba[static_cast<std::size_t>(4 * (y * strip.width + number * width) + x)]);
    return part;
}

TEST_F(Viewer, PutsPicturesSideBySide) {
    const std::string model = FLOWER_GLB " --size 30x40 --supersample ";
    for (const std::string many : {"--animation day --frames 3 ", "--turntable 3 "}) {
        ASSERT_EQ(run(model + many + "-o single.png").code, 0);
        const Outcome outcome = run(model + many + "--strip -o strip.png");
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        const Picture strip = readPicture(m_folder / "strip.png");
        ASSERT_EQ(strip.width, 90);
        ASSERT_EQ(strip.height, 40);
        for (const int number : {0, 1, 2}) {
            const Picture single = readPicture(m_folder / ("single-" + std::to_string(number + 1) + ".png"));
            EXPECT_EQ(compareLit(partOf(strip, number, 30), single).max(), 0) << many << number;
            EXPECT_GT(compareLit(single, partOf(strip, (number + 1) % 3, 30)).max(), 8) << many << number;
        }
        EXPECT_FALSE(fs::exists(m_folder / "strip-1.png"));
    }
    EXPECT_EQ(run(model + "--strip").code, 2) << "of what?";
    EXPECT_EQ(run(model + "--turntable 547 --strip").code, 2) << "16410 pixels";
    fs::copy_file(FLOWER_GLB, m_folder / "flower.glb");
    EXPECT_EQ(run("flower.glb --turntable 2 --strip -o flower.glb").code, 2);
}

// A triangle that goes away to the right by twice its size: seen whole at the end, too, which is 7/8 of the
// way.
TEST_F(Viewer, FramesAllPicturesOfAnAnimation) {
    GltfBuilder file;
    file.setTriangle();
    file.json["materials"] = {{{"extensions", {{"KHR_materials_unlit", Json::object()}}}}};
    file.json["extensionsUsed"] = {"KHR_materials_unlit"};
    file.json["meshes"][0]["primitives"][0]["material"] = 0;
    const int times = file.floats("SCALAR", {0, 1}), ways = file.floats("VEC3", {0, 0, 0, 2, 0, 0});
    file.json["animations"] = {
        {{"samplers", {{{"input", times}, {"output", ways}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
    std::ofstream(m_folder / "goes.glb", std::ios::binary) << file.bytes(true);
    const Outcome outcome = run("goes.glb --animation 0 --frames 8 --strip --size 64x64 -o strip.png");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Picture strip = readPicture(m_folder / "strip.png");
    std::array<int, 8> covered{};
    for (int number = 0; number < 8; ++number)
        for (const Picture part = partOf(strip, number, 64); const std::uint8_t code : part.rgba)
            covered[static_cast<std::size_t>(number)] += code == 255 ? 1 : 0;
    EXPECT_GT(covered[0], 0);
    for (const int count : covered)
        EXPECT_NEAR(count, covered[0], 0.15 * covered[0] + 30) << "as large as in the first picture";
}

} // namespace
} // namespace franken::test
