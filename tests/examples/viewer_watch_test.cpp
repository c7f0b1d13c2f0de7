// SPDX-License-Identifier: MIT
// The viewer in the background, which watches what its picture is made of.
#include "franken/baked_sky.h"
#include "franken/png.h"
#include "support/gltf_builder.h"
#include "viewer_run.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cmath>
#include <fstream>
#include <thread>

namespace franken::test {
namespace {

namespace fs = std::filesystem;

class Watching : public Viewer {
protected:
    void SetUp() override {
        Viewer::SetUp();
        fs::create_directory(m_folder / "model");
        fs::copy(kUrn, m_model);
    }

    /// A viewer of a copy of the urn.
    void start(const std::string& arguments) {
        m_viewer = fork();
        if (m_viewer == 0) {
            const std::string command = "cd " + m_folder.string() + " && exec " VIEWER " model/urn.glb " +
                                        "--size 40x30 --watch " + arguments + " >out.txt 2>err.txt";
            execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
            _exit(127);
        }
    }

    void stop() {
        kill(m_viewer, SIGTERM);
        int status = 0;
        waitpid(m_viewer, &status, 0);
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status << "\n" << err();
        m_viewer = 0;
    }

    void TearDown() override {
        if (m_viewer != 0)
            stop();
    }

    std::string err() const { return readText(m_folder / "err.txt"); }

    /// Waits until the viewer has said so that often.
    void await(const std::string& message, int times) const {
        using namespace std::chrono_literals;
        for (int i = 0; i < 1200; ++i, std::this_thread::sleep_for(50ms)) {
            int count = 0;
            const std::string said = err();
            for (std::size_t at = 0; (at = said.find(message, at)) != std::string::npos; ++at)
                ++count;
            if (count >= times)
                return;
        }
        FAIL() << message << " was not said " << times << " times in a minute:\n" << err();
    }

    const fs::path m_model = m_folder / "model/urn.glb";
    const fs::path m_picture = m_folder / "out.png";
    pid_t m_viewer = 0;
};

TEST_F(Watching, TakesASnippetAndKeepsTheLastGoodPicture) {
    copySnippets();
    const fs::path snippet = m_folder / "glsl/fragment/ambient/none.glsl";
    const std::string text = readText(snippet);
    const auto write = [&](const std::string& more) { std::ofstream(snippet) << text << more; };
    start("--snippets glsl");
    ASSERT_NO_FATAL_FAILURE(await("viewer: wrote out.png", 1));
    const Picture first = readPicture(m_picture);

    write("  sum.specular += vec3(0.2, 0.0, 0.0);\n");
    ASSERT_NO_FATAL_FAILURE(await("viewer: wrote out.png", 2));
    const Picture redder = readPicture(m_picture);
    const Difference difference = compareLit(redder, first);
    EXPECT_GT(difference.pixels, 100u);
    EXPECT_GT(difference.bias, 5) << difference;

    write("  sum.specular += nonsense;\n"); // Refused by the driver.
    ASSERT_NO_FATAL_FAILURE(await("viewer: kept the last good picture", 1));
    EXPECT_NE(err().find("[glsl/fragment/ambient/none.glsl:7]"), std::string::npos) << err();
    EXPECT_NE(err().find("nonsense"), std::string::npos) << err();
    EXPECT_EQ(readPicture(m_picture).rgba, redder.rgba);

    write("//! nonsense\n"); // Refused by the composer.
    ASSERT_NO_FATAL_FAILURE(await("viewer: kept the last good picture", 2));
    EXPECT_NE(err().find("[snippet.syntax]"), std::string::npos) << err();
    EXPECT_EQ(readPicture(m_picture).rgba, redder.rgba);

    write("");
    ASSERT_NO_FATAL_FAILURE(await("viewer: wrote out.png", 3));
    EXPECT_EQ(readPicture(m_picture).rgba, first.rgba);
}

TEST_F(Watching, TakesAModel) {
    start("");
    ASSERT_NO_FATAL_FAILURE(await("viewer: wrote out.png", 1));
    const Picture urn = readPicture(m_picture);

    std::ofstream(m_model) << "{}";
    ASSERT_NO_FATAL_FAILURE(await("viewer: kept the last good picture", 1));
    EXPECT_EQ(readPicture(m_picture).rgba, urn.rgba);

    std::ofstream(m_model) << R"({"asset": {"version": "2.0"}})"; // Nothing at all.
    ASSERT_NO_FATAL_FAILURE(await("viewer: kept the last good picture", 2));
    EXPECT_EQ(readPicture(m_picture).rgba, urn.rgba);

    GltfBuilder triangle;
    triangle.setTriangle();
    std::ofstream(m_model) << triangle.bytes(false);
    ASSERT_NO_FATAL_FAILURE(await("viewer: wrote out.png", 2));
    EXPECT_GT(compareLit(readPicture(m_picture), urn).mean, 5);
}

TEST_F(Watching, KeepsItsProgramsFromPictureToPicture) {
    start("--stats --manifest needed.txt");
    ASSERT_NO_FATAL_FAILURE(await("viewer: wrote out.png", 1));
    const ViewerStats first = lastStats(readText(m_folder / "out.txt"));
    EXPECT_GT(first.compiled, 0u);

    fs::last_write_time(m_model, fs::last_write_time(m_model) + std::chrono::seconds(1));
    ASSERT_NO_FATAL_FAILURE(await("viewer: wrote out.png", 2));
    const ViewerStats second = lastStats(readText(m_folder / "out.txt"));
    EXPECT_EQ(second.compiled, 0u);
    EXPECT_EQ(second.linked, 0u);
    EXPECT_EQ(second.draws, first.draws);
    EXPECT_EQ(second.frameCompiled, 0u);
    EXPECT_EQ(second.mebibytes, first.mebibytes) << "the model before is gone";

    EXPECT_FALSE(fs::exists(m_folder / "needed.txt"));
    stop();
    EXPECT_EQ(readText(m_folder / "needed.txt"), run(std::string(kUrn) + " --permutations").out);
}

/// A square of 2 x 2 that faces +Z, with its corners at the texels' centres of a picture of 2 x 2.
void writeSquare(const fs::path& file) {
    constexpr float kCorners[6][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};
    std::ofstream data(file.parent_path() / "square.bin", std::ios::binary);
    for (const auto& [x, y] : kCorners) {
        const float vertex[] = {x, y, 0, 0.5f + 0.25f * x, 0.5f - 0.25f * y};
        data.write(reinterpret_cast<const char*>(vertex), sizeof(vertex));
    }
    std::ofstream(file)
        << R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 6, "type": "VEC3",
                       "min": [-1, -1, 0], "max": [1, 1, 0]},
                      {"bufferView": 0, "byteOffset": 12, "componentType": 5126, "count": 6, "type": "VEC2"}],
        "bufferViews": [{"buffer": 0, "byteLength": 120, "byteStride": 20}],
        "buffers": [{"uri": "square.bin", "byteLength": 120}]})";
}

TEST_F(Watching, TakesAHeightMap) {
    writeSquare(m_model);
    const auto writeHeights = [&](std::uint8_t left, std::uint8_t right) {
        const Image heights{"", 2, 1, {left, left, left, 255, right, right, right, 255}};
        EXPECT_TRUE(writePng(m_folder / "heights.png", heights));
    };
    writeHeights(128, 128);
    start("--height-map heights.png --height-scale 3");
    ASSERT_NO_FATAL_FAILURE(await("viewer: wrote out.png", 1));
    const Picture flat = readPicture(m_picture);
    writeHeights(0, 255);
    ASSERT_NO_FATAL_FAILURE(await("viewer: wrote out.png", 2));
    EXPECT_GT(compareLit(readPicture(m_picture), flat).shareAbove(10), 0.2);
}

/// A sky of one radiance everywhere, as `bake` would write it.
void writeSky(const fs::path& file, const Float3& radiance) {
    const auto filled = [](int width, int height, const std::array<std::uint8_t, 4>& texel) {
        Image image{"", width, height, {}};
        for (int i = 0; i < width * height; ++i)
            image.rgba.insert(image.rgba.end(), texel.begin(), texel.end());
        return image;
    };
    std::array<std::uint8_t, 4> code = {0, 0, 0, 255};
    BakedSky sky;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        code[channel] = static_cast<std::uint8_t>(std::lround(255 * std::sqrt(radiance[channel] / 64)));
        sky.coefficients[0][channel] = 3.5449f * radiance[channel]; // 2 sqrt(pi)
    }
    sky.skybox = {.size = 1, .range = 64, .images = {}};
    sky.skybox.images.fill(filled(1, 1, code));
    sky.reflection.atlas = {filled(2 * kMinReflectionSize, reflectionHeight(kMinReflectionSize), code), 64};
    sky.reflection.lookup = filled(kLookupWidth, kLookupHeight, {255, 0, 0, 0}); // All of it is reflected.
    const std::vector<std::uint8_t> bytes = encodeBakedSky(sky);
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

TEST_F(Watching, TakesASkyAndKeepsTheLastGoodPicture) {
    const fs::path sky = m_folder / "day.sky";
    writeSky(sky, {0.5f, 0, 0});
    start("--skybox day.sky");
    ASSERT_NO_FATAL_FAILURE(await("viewer: wrote out.png", 1));
    const std::size_t corner = 0, middle = std::size_t{4} * (15 * 40 + 20); // Of 40 x 30 pixels.
    const Picture red = readPicture(m_picture);
    EXPECT_GT(red.rgba[corner], red.rgba[corner + 2]) << "behind the model";

    writeSky(sky, {0, 0, 0.5f});
    ASSERT_NO_FATAL_FAILURE(await("viewer: wrote out.png", 2));
    const Picture blue = readPicture(m_picture);
    EXPECT_LT(blue.rgba[corner], blue.rgba[corner + 2]);
    EXPECT_LT(blue.rgba[middle], red.rgba[middle]) << "and in its light";

    std::ofstream(sky) << "#?RADIANCE";
    ASSERT_NO_FATAL_FAILURE(await("viewer: kept the last good picture", 1));
    EXPECT_NE(err().find("[hdr.format]"), std::string::npos) << err();
    fs::remove(sky);
    ASSERT_NO_FATAL_FAILURE(await("viewer: kept the last good picture", 2));
    EXPECT_NE(err().find("[sky.file]"), std::string::npos) << err();
    EXPECT_EQ(readPicture(m_picture).rgba, blue.rgba);

    writeSky(sky, {0.5f, 0, 0});
    ASSERT_NO_FATAL_FAILURE(await("viewer: wrote out.png", 3));
    EXPECT_EQ(readPicture(m_picture).rgba, red.rgba);
}

} // namespace
} // namespace franken::test
