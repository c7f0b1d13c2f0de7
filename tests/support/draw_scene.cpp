// SPDX-License-Identifier: MIT
#include "support/draw_scene.h"

#include "franken/gltf.h"

#include <fstream>
#include <iostream>
#include <iterator>

namespace franken::test {

Shot shotOf(const std::filesystem::path& file) {
    Result<Scene> scene = loadGltf(file);
    if (!scene) {
        ADD_FAILURE() << toString(scene.error());
        return {};
    }
    Shot shot{.scene = *std::move(scene), .camera = {}, .lighting = {}};
    shot.camera = shot.scene.cameras.empty() ? framingCamera(shot.scene.bounds(), 1) : shot.scene.cameras[0];
    shot.lighting = lightingOf(shot.scene);
    return shot;
}

void drawShot(const Gl& gl, const platform::Surface& surface, const Shot& shot) {
    const auto [width, height] = surface.size();
    Renderer renderer(gl, [](LogLevel, std::string_view message) { std::cout << message << "\n"; });
    EXPECT_TRUE(renderer.load(shot.scene));
    EXPECT_TRUE(renderer.setBackdrop(shot.backdrop ? &*shot.backdrop : nullptr));
    EXPECT_TRUE(renderer.setMirror(shot.mirror ? &*shot.mirror : nullptr));
    renderer.setLighting(shot.lighting);
    renderer.setLook(shot.look);
    const Result<void> drawn = renderer.draw(viewpointOf(shot.camera, static_cast<double>(width) / height),
                                             {surface.framebuffer(), width, height, shot.background});
    EXPECT_TRUE(drawn) << toString(drawn.error());
    EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

Picture toPicture(const test::Image& image) { return {"", image.width, image.height, image.rgba}; }

Shot withForms(Shot shot, Target target) {
    shot.look.target = target;
    return shot;
}

Picture readPicture(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(in), {}};
    Result<Picture> picture = decodeImage(bytes);
    if (picture)
        return *std::move(picture);
    ADD_FAILURE() << file << ": " << toString(picture.error());
    return {};
}

std::filesystem::path findShared(const std::string& path) {
    const std::filesystem::path shared = std::filesystem::path(FRANKEN_SOURCE_DIR) / ".." / "shared" / path;
    return std::filesystem::exists(shared) ? shared : std::filesystem::path();
}

} // namespace franken::test
