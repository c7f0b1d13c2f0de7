// SPDX-License-Identifier: MIT
#include "kiosk/screen.h"

#include <filesystem>

namespace kiosk {

namespace platform = franken::platform;

namespace {

platform::PixelFormat formatOf(const std::string& word) {
    if (word == "565")
        return platform::PixelFormat::Rgb565;
    return word == "10bit" ? platform::PixelFormat::Rgb10 : platform::PixelFormat::Rgb8;
}

platform::RgbRange rangeOf(const std::string& word) {
    if (word == "limited")
        return platform::RgbRange::Limited;
    return word == "automatic" ? platform::RgbRange::Automatic : platform::RgbRange::Full;
}

} // namespace

platform::SurfaceOptions surfaceOptionsOf(const Config& config, franken::Log log) {
    const auto& screen = config.screen;
    platform::SurfaceOptions options{.log = std::move(log), .title = "FrankenShader kiosk"};
    options.screen = {.output = screen.output,
                      .mirror = screen.mirror,
                      .driver = screen.driver,
                      .maxPixels = screen.maxPixels,
                      .format = formatOf(screen.format),
                      .range = rangeOf(screen.range),
                      .assumeConnected = screen.assumeConnected,
                      .allowSoftware = screen.allowSoftware};
    if (!screen.mode.empty())
        options.screen.mode = *platform::parseModeRequest(screen.mode);
    if (!screen.modeline.empty())
        options.screen.modeline = *platform::parseModeline(screen.modeline);
    if (screen.rotation != "panel")
        options.screen.rotation = franken::rotationOf(std::stoi(screen.rotation));
    if (!config.files.state.empty())
        options.shaderCache = (std::filesystem::path(config.files.state) / "mesa").string();
    options.size = {1280, 720}; // Of a window.
    return options;
}

franken::DrawTarget targetOf(const platform::Surface& surface) {
    franken::DrawTarget target{.framebuffer = surface.framebuffer(),
                               .width = surface.size().width,
                               .height = surface.size().height,
                               .rotation = surface.rotation()};
    if (surface.format() == platform::PixelFormat::Rgb565)
        target.bits = {5, 6, 5};
    if (surface.format() == platform::PixelFormat::Rgb10)
        target.bits = {10, 10, 10};
    return target;
}

} // namespace kiosk
