// SPDX-License-Identifier: MIT
// How much of the heap it takes to load large images: five JPEGs of 4096 x 4096, which are 427 MiB with their
// mip levels, come to the GPU with at most 160 MiB beyond the file.
#include "franken/gltf.h"
#include "franken/renderer.h"
#include "support/gltf_builder.h"
#include "support/heap_count.h"
#include "support/null_gl.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <initializer_list>
#include <iostream>
#include <thread>
#include <vector>

namespace franken::test {
namespace {

constexpr int kSize = 4096, kImages = 5;
constexpr std::size_t kMostBytes = std::size_t{160} << 20;

using Bytes = std::vector<std::uint8_t>;

void append(Bytes& file, std::initializer_list<int> bytes) {
    for (const int byte : bytes)
        file.push_back(static_cast<std::uint8_t>(byte));
}

/// A Huffman table (ITU T.81, B.2.4.2) of one symbol, 0, whose code is the bit 0.
void appendTable(Bytes& file, int table) {
    append(file, {0xFF, 0xC4, 0, 20, table, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
}

/// A baseline JPEG of kSize x kSize in three full components, all of one grey: each block is a difference of
/// 0 and an end of block, which are two bits. The comment makes it another file than the others.
Bytes jpeg(int comment) {
    Bytes file;
    append(file, {0xFF, 0xD8, 0xFF, 0xFE, 0, 3, comment});
    append(file, {0xFF, 0xDB, 0, 67, 0});
    file.insert(file.end(), 64, 1);
    append(file, {0xFF, 0xC0, 0, 17, 8, kSize >> 8, kSize & 255, kSize >> 8, kSize & 255, 3});
    for (int component = 1; component <= 3; ++component)
        append(file, {component, 0x11, 0});
    appendTable(file, 0x00);
    appendTable(file, 0x10);
    append(file, {0xFF, 0xDA, 0, 12, 3, 1, 0, 2, 0, 3, 0, 0, 63, 0});
    file.insert(file.end(), std::size_t{kSize / 8} * (kSize / 8) * 3 * 2 / 8, 0);
    append(file, {0xFF, 0xD9});
    return file;
}

/// A triangle for each image.
Bytes fileOfImages() {
    std::vector<Bytes> images;
    for (int i = 0; i < kImages; ++i)
        images.push_back(jpeg(i));
    GltfBuilder file;
    file.setTriangles(images, "image/jpeg");
    const std::string bytes = file.bytes(true);
    return {bytes.begin(), bytes.end()};
}

TEST(Heap, FiveLargeImagesComeWithLittleMoreThanOneOfThem) {
    const Bytes file = fileOfImages();
    Renderer renderer(nullGl(), {.maxTextureSize = kSize, .maxCubeSize = kSize});
    const std::size_t before = heapCount().bytes;
    restartMostBytes();
    LoadOptions options;
    EXPECT_EQ(loadGltf(file, "large.glb", options).error().code, "gltf.limit") << "as pixels, all at once";
    options.images = ImageForm::Encoded;
    Result<Scene> scene = loadGltf(file, "large.glb", options);
    ASSERT_TRUE(scene) << toString(scene.error());
    const Result<ModelId> model = renderer.addInSteps(*std::move(scene));
    ASSERT_TRUE(model);
    std::size_t bytes = 0;
    for (bool more = true; more;) {
        const Result<StepReport> report = renderer.step();
        ASSERT_TRUE(report) << toString(report.error());
        more = report->more;
        bytes += report->bytes;
        if (report->bytes == 0)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_TRUE(*renderer.isResident(*model));
    EXPECT_GT(bytes, std::size_t{kImages} * kSize * kSize * 4);
    const std::size_t most = heapCount().most - before;
    std::cout << (most >> 20) << " MiB at most, of a file of " << file.size() / 1024 << " KiB\n";
    EXPECT_LE(most, kMostBytes + file.size());
    EXPECT_GT(most, std::size_t{kSize} * kSize * 4) << "one of them is decoded";
}

} // namespace
} // namespace franken::test
