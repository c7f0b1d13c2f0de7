// SPDX-License-Identifier: MIT
#include "kiosk/frame_command.h"

#include "franken/png.h"
#include "kiosk/content/sky.h"
#include "kiosk/machine/monitor.h"
#include "kiosk/screen.h"
#include "kiosk/show/stage.h"

#include <poll.h>

namespace kiosk {

namespace platform = franken::platform;
using franken::Error;
using franken::Result;

namespace {

/// The first model that is whole.
Result<LoadedModel> firstModel(const Config& config, const franken::Log& log) {
    const Result<std::unique_ptr<EventLoop>> loop = EventLoop::make();
    if (!loop)
        return loop.error();
    Content content(**loop, log, [] {});
    content.configure(config);
    content.want({});
    while (content.isReading()) {
        if (Result<void> turned = (*loop)->turn(); !turned)
            return turned.error();
        if (std::optional<LoadedModel> model = content.take())
            return *std::move(model);
    }
    return Error{"kiosk.nothing", "content", "there is no model to draw",
                 "name one, or a folder that has one"};
}

Result<void> upload(Stage& stage, LoadedModel model) {
    if (Result<void> prepared = stage.prepare(std::move(model)); !prepared)
        return prepared;
    for (;;) {
        const Result<bool> ready = stage.nextIsReady();
        if (!ready)
            return ready.error();
        if (*ready)
            return stage.change();
        if (Result<void> worked = stage.work(); !worked)
            return worked;
        poll(nullptr, 0, 1); // The renderer's thread decodes.
    }
}

Result<void> showModel(Stage& stage, const DrawFrame& command, const Config& config,
                       const franken::Log& log) {
    Result<LoadedModel> model = firstModel(config, log);
    if (!model)
        return model.error();
    if (Result<void> uploaded = upload(stage, *std::move(model)); !uploaded)
        return uploaded;
    stage.shown()->view.advance(command.seconds);
    if (config.show.caption)
        stage.labels().setCaption(stage.shown()->caption);
    if (config.show.statistics) {
        Statistics statistics = statisticsOf(Machine(command.options.root));
        statistics.models = 1;
        stage.report(statistics);
        stage.labels().setStatistics(toLines(statistics));
    }
    return {};
}

} // namespace

Result<void> drawFrame(const DrawFrame& command, const Config& config, const franken::Log& log) {
    platform::SurfaceOptions options = surfaceOptionsOf(config, log);
    options.size = command.size;
    options.shaderCache.clear();
    const Result<std::unique_ptr<platform::Surface>> surface =
        platform::create(command.options.backend, options);
    if (!surface)
        return surface.error();
    const Result<franken::Gl> gl = franken::Gl::load((*surface)->getProcAddress());
    if (!gl)
        return gl.error();
    Stage stage(*gl, (*surface)->driver(), {}, config, log);
    stage.renderer().memory().setBudget(
        memoryBudget(config.content.memoryMebibytes, Machine(command.options.root)));
    franken::DrawTarget target = targetOf(**surface);
    if (options.screen.rotation)
        target.rotation = *options.screen.rotation;
    stage.setTarget(target, (*surface)->srgbTarget());
    stage.configure(config);
    if (!config.show.sky.empty()) {
        const Result<Sky> sky = readSky(config.show.sky);
        if (!sky)
            return sky.error();
        stage.setSky(*sky);
    }
    if (command.loaded)
        stage.labels().setNotice(kLoadingNotice);
    else if (Result<void> shown = showModel(stage, command, config, log); !shown)
        return shown;
    if (Result<void> drawn = stage.draw(command.loaded ? 1 : 0, command.loaded); !drawn)
        return drawn;
    const Result<franken::Image> picture = stage.renderer().readPixels(stage.target());
    return picture ? franken::writePng(command.output, *picture) : picture.error();
}

} // namespace kiosk
