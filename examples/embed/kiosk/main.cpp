// SPDX-License-Identifier: MIT
// kiosk MODEL...: shows a model on the screen; a press on the button at GPIO17 shows the next one.
#include <cstdlib>
#include <franken/gltf.h>
#include <franken/platform/gpio.h>
#include <franken/platform/surface.h>
#include <franken/renderer.h>
#include <iostream>
#include <poll.h>

using namespace franken;
void print(LogLevel, std::string_view text) { std::cerr << text << std::endl; }

Result<void> draw(Renderer& renderer, const char* file, platform::Surface& screen) {
    const Result<Scene> scene = loadGltf(file, {}, print);
    if (!scene)
        return scene.error();
    const DrawTarget target{.framebuffer = screen.framebuffer(),
                            .width = screen.size().width,
                            .height = screen.size().height,
                            .rotation = screen.rotation()};
    const double aspect = aspectOf(target);
    renderer.setLighting({.suns = {{.direction = {-1, -2, -3}, .illuminance = 3}}});
    Result<void> ok = renderer.load(*scene);
    ok = ok ? renderer.draw(viewpointOf(framingCamera(scene->bounds(), aspect), aspect), target) : ok;
    return ok ? screen.submit() : ok;
}

Result<void> run(platform::Surface& screen, const std::vector<const char*>& models) {
    if (models.empty())
        return Error{"kiosk.usage", "kiosk", "no model is named", "kiosk MODEL..."};
    platform::GpioInputs button({{.name = "next", .pin = {.number = 17}}}, {}, print);
    std::unique_ptr<Renderer> renderer;
    std::size_t shown = 0;
    for (bool stale = true; screen.state() != platform::SurfaceState::Failed;) {
        if (stale && screen.begin().value()) {
            if (!renderer)
                renderer = std::make_unique<Renderer>(Gl::load(screen.getProcAddress()).value(), print);
            if (Result<void> drawn = draw(*renderer, models[shown % models.size()], screen); !drawn)
                return drawn;
        }
        pollfd ready[] = {{screen.descriptor(), POLLIN, 0}, {button.descriptor(), POLLIN, 0}};
        poll(ready, std::size(ready), -1);
        const platform::SurfaceEvents events = screen.dispatch();
        if (events.contextReplaced && renderer)
            renderer->contextLost(), renderer.reset();
        const std::vector<platform::ButtonEvent> presses = button.dispatch().buttons;
        for (const platform::ButtonEvent& event : presses)
            shown += event.press == platform::Press::Down ? 1 : 0;
        stale = !events.completed || events.layoutChanged || !presses.empty();
    }
    return screen.failure();
}

int main(int count, char** files) {
    const platform::ScreenOptions options = {.allowSoftware = std::getenv("KIOSK_SOFTWARE") != nullptr};
    const auto screen = platform::create(platform::Backend::Kms, {.log = print, .screen = options});
    const Result<void> ended = screen ? run(**screen, {files + 1, files + count}) : screen.error();
    return print(LogLevel::Error, toString(ended.error())), EXIT_FAILURE;
}
