// SPDX-License-Identifier: MIT
// Loading on any thread: how far it is, how it is cancelled, and images that stay encoded.
#include <algorithm>
#include <thread>

#include "gltf_file.h"

namespace {

using franken::ImageForm;
using franken::LoadOptions;
using franken::Result;
using franken::Scene;

/// Three nodes with a mesh each, and a material with a texture.
GltfFile threeTriangles() {
    GltfFile file;
    file.setTriangle();
    const int texture = file.appendTexture();
    file.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}}};
    file.json["meshes"][0]["primitives"][0]["material"] = 0;
    file.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}}, {{"mesh", 0}}};
    file.json["scenes"][0]["nodes"] = {0, 1, 2};
    return file;
}

struct Step {
    float done;
    std::string what;
};

TEST(GltfProgress, GoesFromNothingToOneAndSaysWhatIsDone) {
    std::vector<Step> steps;
    LoadOptions options;
    options.progress = [&](float done, std::string_view what) { steps.push_back({done, std::string(what)}); };
    ASSERT_TRUE(threeTriangles().load(options));
    EXPECT_TRUE(std::is_sorted(steps.begin(), steps.end(),
                               [](const Step& a, const Step& b) { return a.done < b.done; }));
    EXPECT_LT(steps.front().done, 0.1f);
    EXPECT_EQ(steps.back().done, 1);
    for (const std::string part : {"JSON", "files", "images", "meshes"})
        EXPECT_TRUE(std::any_of(steps.begin(), steps.end(), [&](const Step& step) {
            return step.what == part;
        })) << part;
}

TEST(GltfProgress, NeverPassesOneWhereANodeHasManyInstances) {
    GltfFile file = threeTriangles();
    const int places = file.floats("VEC3", std::vector<float>(30, 1));
    file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", places}};
    float last = 0;
    LoadOptions options;
    options.progress = [&](float done, std::string_view) {
        EXPECT_GE(done, last);
        EXPECT_LE(done, 1);
        last = done;
    };
    ASSERT_TRUE(file.load(options));
}

TEST(GltfProgress, AnExceptionOfTheCallbackIsDropped) {
    LoadOptions options;
    options.progress = [](float, std::string_view) { throw 1; };
    EXPECT_TRUE(threeTriangles().load(options));
}

// Whenever it is cancelled: at the first call of progress, at the second, and so on.
TEST(GltfCancel, EndsWithItsOwnErrorWhereverItIsRequested) {
    GltfFile file = threeTriangles();
    for (const ImageForm form : {ImageForm::Pixels, ImageForm::Encoded}) {
        for (int at = 0;; ++at) {
            std::stop_source source;
            int calls = 0;
            LoadOptions options;
            options.images = form;
            options.cancel = source.get_token();
            options.progress = [&](float, std::string_view) {
                if (calls++ == at)
                    source.request_stop();
            };
            const Result<Scene> scene = file.load(options);
            EXPECT_EQ(calls, at + 1) << "nothing goes on after it";
            if (scene) {
                EXPECT_GE(at, 5) << "all was done when it was requested";
                break;
            }
            EXPECT_EQ(scene.error().code, "gltf.cancelled");
        }
        EXPECT_TRUE(file.load()) << "the file loads as before";
    }
    EXPECT_TRUE(file.warnings.empty());
}

TEST(GltfCancel, CanBeRequestedFromAnotherThread) {
    GltfFile file = threeTriangles();
    for (int round = 0; round < 20; ++round) {
        std::stop_source source;
        LoadOptions options;
        options.cancel = source.get_token();
        std::jthread other([&] { source.request_stop(); });
        const Result<Scene> scene = file.load(options);
        EXPECT_TRUE(scene || scene.error().code == "gltf.cancelled");
    }
}

TEST(GltfEncoded, ImagesStayInTheirFilesFormatUntilSomebodyAsks) {
    GltfFile file = threeTriangles();
    LoadOptions options;
    options.images = ImageForm::Encoded;
    const Result<Scene> encoded = file.load(options), decoded = file.load();
    ASSERT_TRUE(encoded && decoded);
    ASSERT_EQ(encoded->images.size(), 1u);
    const franken::Image& image = encoded->images[0];
    EXPECT_TRUE(image.rgba.empty());
    EXPECT_FALSE(image.encoded.empty());
    EXPECT_EQ(image.width, 1);
    EXPECT_EQ(image.height, 1);
    const Result<franken::Image> pixels = withPixels(image);
    ASSERT_TRUE(pixels);
    EXPECT_EQ(pixels->rgba, decoded->images[0].rgba);
    EXPECT_EQ(pixels->name, decoded->images[0].name);
}

/// A PNG's header alone, which no decoder gets pixels from.
std::vector<unsigned char> headerOfPng(std::uint32_t size) {
    const auto byte = [&](int shift) { return static_cast<unsigned char>(size >> shift); };
    std::vector<unsigned char> png = {
        0x89,    'P',     'N', 'G', '\r', '\n',     0x1A,     '\n',    0,       0,        0,
        13,      'I',     'H', 'D', 'R',  byte(24), byte(16), byte(8), byte(0), byte(24), byte(16),
        byte(8), byte(0), 8,   6,   0,    0,        0,        0,       0,       0,        0};
    png.resize(std::size_t{size} * size / 250, 1); // As many bytes as the pixels need at least.
    return png;
}

// Five images of 2048 x 2048 fill 80 MiB as pixels; what is charged is one of them, and the files.
TEST(GltfEncoded, TheLimitIsThatOfOneImageAtATime) {
    GltfFile file;
    file.setTriangle();
    file.json["materials"] = nlohmann::json::array();
    for (int i = 0; i < 5; ++i) {
        const int texture = file.appendTexture();
        file.json["images"][static_cast<std::size_t>(i)] = {{"bufferView", file.view(headerOfPng(2048))},
                                                            {"mimeType", "image/png"}};
        file.json["materials"].push_back(
            {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}});
        file.json["meshes"][0]["primitives"][static_cast<std::size_t>(i)] =
            file.json["meshes"][0]["primitives"][0];
        file.json["meshes"][0]["primitives"][static_cast<std::size_t>(i)]["material"] = i;
    }
    LoadOptions options;
    options.maxMemoryBytes = std::size_t{48} << 20;
    const Result<Scene> refused = file.load(options);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, "gltf.limit");
    options.images = ImageForm::Encoded;
    const Result<Scene> scene = file.load(options);
    ASSERT_TRUE(scene) << toString(scene.error());
    EXPECT_EQ(scene->images.size(), 5u);
    EXPECT_EQ(scene->images[4].width, 2048);
}

} // namespace
