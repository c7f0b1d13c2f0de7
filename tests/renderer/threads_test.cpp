// SPDX-License-Identifier: MIT
// Reading scenes on several threads at once, cancelling them, and a renderer that takes what its thread
// reads: tests/tsan.sh runs this under ThreadSanitizer.
#include "franken/gltf.h"
#include "franken/png.h"
#include "misuse_stage.h"
#include "support/gltf_builder.h"

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

namespace franken::test {
namespace {

constexpr int kTextures = 5;

/// A file with a triangle for each of its textures.
std::vector<std::uint8_t> fileOfTriangles() {
    std::vector<std::vector<std::uint8_t>> images;
    for (int i = 0; i < kTextures; ++i) {
        const Image image = checkers(64, 8, glm::vec4(1), {0.1f * static_cast<float>(i), 0, 0, 1});
        images.push_back(encodePng(image.width, image.height, 4, image.rgba));
    }
    GltfBuilder file;
    file.setTriangles(images, "image/png");
    const std::string bytes = file.bytes(true);
    return {bytes.begin(), bytes.end()};
}

const std::vector<std::uint8_t> kFile = fileOfTriangles();

Result<Scene> read(ImageForm form, std::stop_token cancel = {}) {
    LoadOptions options;
    options.images = form;
    options.cancel = std::move(cancel);
    return loadGltf(kFile, "triangles.glb", options);
}

TEST(Threads, ReadTheSameFileAtOnce) {
    std::vector<Result<Scene>> scenes(6, Error{});
    {
        std::vector<std::jthread> readers;
        for (std::size_t i = 0; i < scenes.size(); ++i)
            readers.emplace_back(
                [&, i] { scenes[i] = read(i % 2 == 0 ? ImageForm::Pixels : ImageForm::Encoded); });
    }
    for (const Result<Scene>& scene : scenes) {
        ASSERT_TRUE(scene) << toString(scene.error());
        ASSERT_EQ(scene->images.size(), std::size_t{kTextures});
        for (std::size_t i = 0; i < scene->images.size(); ++i)
            EXPECT_EQ(withPixels(scene->images[i])->rgba, scenes[0]->images[i].rgba);
    }
}

TEST(Threads, CancelAReadAtAnyMoment) {
    for (int round = 0; round < 30; ++round) {
        std::stop_source cancel;
        std::jthread other([&] {
            for (int i = 0; i < round; ++i)
                std::this_thread::yield();
            cancel.request_stop();
        });
        const Result<Scene> scene =
            read(round % 2 == 0 ? ImageForm::Pixels : ImageForm::Encoded, cancel.get_token());
        EXPECT_TRUE(scene || scene.error().code == "gltf.cancelled");
    }
}

/// One unit; false where nothing more comes.
bool stepOn(Renderer& renderer) {
    const Result<StepReport> report = renderer.step();
    EXPECT_TRUE(report || report.error().code == "gltf.cancelled") << toString(report.error());
    return !report || report->more;
}

TEST(Threads, ARendererTakesWhatItsThreadReads) {
    Stage stage;
    const SceneSource source = [] { return read(ImageForm::Encoded); };
    const Result<ModelId> model = stage.renderer.add(*source(), source);
    ASSERT_TRUE(model);
    for (int round = 0; round < 20; ++round) {
        ASSERT_TRUE(stage.renderer.show({}) && stage.renderer.memory().evictAll());
        ASSERT_TRUE(stage.renderer.show({{*model}}));
        const Result<Scene> meanwhile = read(ImageForm::Pixels);
        EXPECT_TRUE(meanwhile);
        while (stepOn(stage.renderer))
            EXPECT_TRUE(stage.draw());
        EXPECT_TRUE(*stage.renderer.isResident(*model));
    }
}

// A source that an application cancels, and a model that is removed while its source runs.
TEST(Threads, ASourceIsCancelledAtAnyMoment) {
    for (int round = 0; round < 30; ++round) {
        Stage stage;
        std::stop_source cancel;
        const SceneSource source = [token = cancel.get_token()] { return read(ImageForm::Encoded, token); };
        const Result<ModelId> model = stage.renderer.add(*read(ImageForm::Encoded), source);
        ASSERT_TRUE(model && stage.renderer.memory().evictAll() && stage.renderer.show({{*model}}));
        for (int i = 0; i < round; ++i)
            stepOn(stage.renderer);
        cancel.request_stop();
        if (round % 3 == 0)
            stage.renderer.remove(*model);
        while (stepOn(stage.renderer)) {
        }
        if (round % 3 != 0) {
            const Result<bool> resident = stage.renderer.isResident(*model);
            EXPECT_TRUE(resident ? *resident : resident.error().code == "gltf.cancelled");
        }
        EXPECT_TRUE(stage.draw());
    }
}

} // namespace
} // namespace franken::test
