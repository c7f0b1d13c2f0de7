// SPDX-License-Identifier: MIT
// What the CPU does for a draw: the renderer next to a loop that is written by hand for this one scene, over
// a driver that does nothing, over Mesa's software renderer, and over whatever EGL finds. 1,000 objects, the
// camera moves. One run measures both, and holds that both make the same calls of GL but for their order.
#include "franken/overlay_text.h"
#include "franken/platform/surface.h"
#include "franken/renderer.h"
#include "hand_loop.h"
#include "ratio_reporter.h"
#include "support/font_builder.h"
#include "support/gl_recorder.h"
#include "support/null_gl.h"
#include "support/shapes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <map>

namespace {

using namespace franken;

constexpr int kObjects = 1000, kMeshes = 50, kMaterials = 10, kSize = 16;

// What is equal is uploaded once, and the hand-written loop does not know that.
Image differing(Image image, int number) {
    image.rgba[0] = static_cast<std::uint8_t>(number);
    return image;
}

Scene manyObjects() {
    test::SceneBuilder builder;
    for (int i = 0; i < kMaterials; ++i) {
        Material material;
        material.factors.roughness = 0.3f + 0.05f * static_cast<float>(i);
        material.textures[TextureRole::BaseColor].texture =
            builder.addTexture(differing(test::checkers(4, 2, glm::vec4(1), glm::vec4(0.3f)), i));
        material.textures[TextureRole::Normal].texture = builder.addTexture(differing(test::bumps(4, 1), i));
        builder.addMaterial(material);
    }
    for (int mesh = 0; mesh < kMeshes; ++mesh) {
        Primitive primitive = test::sphere(2);
        primitive.material = mesh % kMaterials;
        primitive.positions[0].x += 0.001f * static_cast<float>(mesh);
        builder.scene.meshes.push_back({"", {std::move(primitive)}});
    }
    for (int i = 0; i < kObjects; ++i) { // All as deep: the hand-written loop does not draw front to back.
        const glm::vec3 place(0.25f * static_cast<float>(i % 40) - 5, 0.4f * static_cast<float>(i / 40) - 5,
                              0);
        builder.scene.instances.push_back(
            {"", i % kMeshes, glm::scale(glm::translate(glm::mat4(1), place), glm::vec3(0.3f))});
    }
    builder.addSun({-1, -1, -1}, {1, 1, 1}, 3);
    return builder.scene;
}

Lighting lights(const Scene& scene) {
    Lighting lighting = lightingOf(scene);
    lighting.ambient = {.kind = Ambient::Color, .color = {0.1f, 0.1f, 0.1f}};
    return lighting;
}

Viewpoint viewpointAt(int frame) {
    Camera camera;
    camera.yfov = 1;
    camera.zfar = 100;
    camera.world = glm::translate(glm::mat4(1), glm::vec3(0.001f * static_cast<float>(frame % 100), 0, 15));
    return viewpointOf(camera, 1);
}

struct Ours {
    Ours(const Gl& gl, const Scene& scene) : renderer(gl) {
        if (!renderer.load(scene))
            std::exit(2);
        renderer.setLighting(lights(scene));
    }
    void draw(const Viewpoint& viewpoint, GLuint framebuffer) {
        if (!renderer.draw(viewpoint, {.framebuffer = framebuffer, .width = kSize, .height = kSize}))
            std::exit(2);
    }
    Renderer renderer;
};

struct Hand {
    Hand(const Gl& gl, const Scene& scene) : loop(gl, scene, lights(scene)) {}
    void draw(const Viewpoint& viewpoint, GLuint framebuffer) {
        loop.draw(glm::mat4(viewpoint.viewProjection), glm::vec3(viewpoint.eye), framebuffer, kSize);
    }
    bench::HandLoop loop;
};

/// A driver to measure over.
struct Driver {
    std::string name;
    Gl gl;
    std::unique_ptr<platform::Surface> surface;
    GLuint framebuffer() const { return surface ? surface->framebuffer() : 0; }
};

template<typename Loop>
void measure(benchmark::State& state, const Driver& driver) {
    if (driver.surface && !driver.surface->makeCurrent())
        std::exit(2);
    const Scene scene = manyObjects();
    Loop loop(driver.gl, scene);
    int frame = 0;
    while (frame < 5) // The driver's own first draws are not what is measured.
        loop.draw(viewpointAt(++frame), driver.framebuffer());
    driver.gl.Finish();
    for (auto _ : state)
        loop.draw(viewpointAt(++frame), driver.framebuffer());
    driver.gl.Finish();
    state.SetItemsProcessed(state.iterations() * kObjects);
}

/// The processor's time for a text of 200 glyphs that is another one in each frame, of glyphs that are there.
void measureText(benchmark::State& state, const Driver& driver) {
    constexpr int kGlyphs = 200, kLines = 10;
    if (driver.surface && !driver.surface->makeCurrent())
        std::exit(2);
    std::array<std::string, 2> texts;
    for (int i = 0; i < kGlyphs; ++i)
        for (std::size_t text = 0; text < texts.size(); ++text)
            texts[text] += std::string(1, "AVBo"[(static_cast<std::size_t>(i) + text) % 4]) +
                           (i % (kGlyphs / kLines) == 0 ? "\n" : "");
    Renderer renderer(driver.gl);
    OverlayText overlay(renderer);
    const Result<TextId> id = overlay.add(
        {.font = *parseFont(test::soundFont().bytes()), .utf8 = texts[0], .style = {.pixels = 12}});
    const DrawTarget target{.framebuffer = driver.framebuffer(), .width = kSize, .height = kSize};
    std::size_t frame = 0;
    for (auto _ : state)
        if (!overlay.set(*id, texts[++frame % 2]) || !overlay.draw(target))
            std::exit(2);
    driver.gl.Finish();
    state.SetItemsProcessed(state.iterations() * kGlyphs);
}

template<typename Loop>
std::map<std::string_view, int> callsOfAFrame() {
    const Gl gl = test::recordingGl(test::nullGl());
    Loop loop(gl, manyObjects());
    for (int frame = 0; frame < 2; ++frame) {
        test::recordedCalls().clear();
        loop.draw(viewpointAt(frame), 0);
    }
    std::map<std::string_view, int> calls;
    for (const test::GlCall& call : test::recordedCalls())
        ++calls[call.name];
    return calls;
}

std::vector<Driver> drivers() {
    std::vector<Driver> found;
    found.push_back({"null", test::nullGl(), nullptr});
    for (const platform::Backend backend : {platform::Backend::OsMesa, platform::Backend::EglSurfaceless}) {
        Result<std::unique_ptr<platform::Surface>> surface =
            platform::create(backend, {.size = {kSize, kSize}});
        if (!surface) {
            std::cerr << "not measured: " << toString(surface.error()) << "\n";
            continue;
        }
        std::cerr << platform::toString(backend) << ": " << (*surface)->driver() << "\n";
        found.push_back({std::string(platform::toString(backend)), *Gl::load((*surface)->getProcAddress()),
                         *std::move(surface)});
    }
    return found;
}

} // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (callsOfAFrame<Ours>() != callsOfAFrame<Hand>()) {
        std::cerr << "the two loops make different calls: the comparison means nothing\n";
        return 1;
    }
    const std::vector<Driver> all = drivers();
    for (const Driver& driver : all) {
        benchmark::RegisterBenchmark(("renderer/" + driver.name).c_str(), measure<Ours>, std::cref(driver));
        benchmark::RegisterBenchmark(("hand/" + driver.name).c_str(), measure<Hand>, std::cref(driver));
        benchmark::RegisterBenchmark(("text/" + driver.name).c_str(), measureText, std::cref(driver));
    }
    bench::RatioReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    for (const Driver& driver : all)
        reporter.printRatio("renderer/" + driver.name, "hand/" + driver.name);
    return 0;
}
