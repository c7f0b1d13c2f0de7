// SPDX-License-Identifier: MIT
// first MODEL [kms]: a model that turns, in a window; with kms on a screen without a desktop.
#include <franken/gltf.h>
#include <franken/orbit_camera.h>
#include <franken/platform/surface.h>
#include <franken/renderer.h>
#include <iostream>
#include <poll.h>

using namespace franken;

Result<void> show(const Scene& scene, platform::Surface& surface) {
    if (!surface.hasContext())
        return Error{"first.screen", "kms", surface.status(), "connect a screen, or leave kms out"};
    const Result<Gl> gl = Gl::load(surface.getProcAddress());
    if (!gl)
        return gl.error();
    Renderer renderer(*gl);
    renderer.setLighting({.suns = {{.direction = {-1, -2, -3}, .illuminance = 3}},
                          .ambient = {.kind = Ambient::Color, .color = {0.3f, 0.3f, 0.3f}}});
    OrbitCamera camera(framingCamera(scene.bounds(), 1), scene.bounds());
    Result<void> done = renderer.load(scene);
    while (done && !surface.dispatch().closeRequested) {
        if (surface.begin().value()) {
            const platform::Size size = surface.size();
            const DrawTarget target{surface.framebuffer(), size.width, size.height};
            static_cast<void>(camera.drag(0.002, 0)); // A turn takes 1000 frames.
            static_cast<void>(camera.advance(0));
            done = renderer.draw(viewpointOf(camera.camera(), aspectOf(target)), target);
            done = done ? surface.submit() : done;
        }
        pollfd ready = {surface.descriptor(), POLLIN, 0};
        poll(&ready, 1, -1); // Until the frame was shown.
    }
    return done;
}

int main(int count, char** words) {
    const auto backend = count > 2 ? platform::Backend::Kms : platform::Backend::Window;
    const auto surface = platform::create(backend, {.size = {640, 480}});
    const auto scene = surface ? loadGltf(count > 1 ? words[1] : "model.glb") : surface.error();
    const auto done = scene ? show(*scene, **surface) : scene.error();
    if (!done)
        std::cerr << toString(done.error()) << "\n";
    return done ? 0 : 1;
}
