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
    drawShot(gl, surface, shot, Capabilities::query(gl));
}

void drawShot(const Gl& gl, const platform::Surface& surface, const Shot& shot,
              const Capabilities& capabilities) {
    const auto [width, height] = surface.size();
    drawShot(gl, DrawTarget{surface.framebuffer(), width, height}, shot, capabilities);
}

void drawShot(const Gl& gl, DrawTarget target, const Shot& shot, const Capabilities& capabilities) {
    Renderer renderer(gl, capabilities,
                      [](LogLevel, std::string_view message) { std::cout << message << "\n"; });
    EXPECT_TRUE(renderer.load(shot.scene));
    EXPECT_TRUE(renderer.setSkybox(shot.skybox ? &*shot.skybox : nullptr));
    EXPECT_TRUE(renderer.setReflection(shot.reflection ? &*shot.reflection : nullptr));
    renderer.setLighting(shot.lighting);
    renderer.setLook(shot.look);
    target.background = shot.background;
    const Result<void> drawn = renderer.draw(viewpointOf(shot.camera, aspectOf(target)), target);
    EXPECT_TRUE(drawn) << toString(drawn.error());
    for (const Fallback& fallback : renderer.fallbacks())
        ADD_FAILURE() << toString(fallback.error);
    EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

Shot withForms(Shot shot, Target target) {
    shot.look.target = target;
    return shot;
}

void disturbState(const Gl& gl) {
    for (const GLenum capability : {GL_SCISSOR_TEST, GL_BLEND, GL_STENCIL_TEST, GL_POLYGON_OFFSET_FILL})
        gl.Enable(capability);
    gl.Disable(GL_DEPTH_TEST);
    gl.Scissor(0, 0, 3, 3);
    gl.ColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
    gl.DepthMask(GL_FALSE);
    gl.DepthFunc(GL_NEVER);
    gl.CullFace(GL_FRONT);
    gl.FrontFace(GL_CW);
    gl.BlendEquation(GL_FUNC_REVERSE_SUBTRACT);
    gl.BlendFunc(GL_ONE, GL_ONE);
    gl.ClearColor(1, 1, 1, 1);
    gl.ClearDepthf(0);
    gl.UseProgram(0);
    for (const GLenum target : {GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER})
        gl.BindBuffer(target, 0);
    for (GLuint location = 0; location < 8; ++location)
        location < 4 ? gl.DisableVertexAttribArray(location) : gl.EnableVertexAttribArray(location);
    for (GLenum unit = 0; unit < 8; ++unit) {
        gl.ActiveTexture(GL_TEXTURE0 + unit);
        gl.BindTexture(GL_TEXTURE_2D, 0);
    }
    gl.Viewport(1, 2, 3, 4);
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
