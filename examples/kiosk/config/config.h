// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace kiosk {

/// What buttons, keys and fingers can do.
inline constexpr std::array<std::string_view, 11> kActions = {
    "next",        "previous", "pause",      "lights",     "brighter", "darker",
    "next-camera", "caption",  "statistics", "screenshot", "wake"};

using Texts = std::vector<std::string>;
using Bindings = std::map<std::string, Texts>; ///< By action: names of keys, buttons or gestures.

/// What the configuration says. The members' initial values are the defaults; settings.h has the table that
/// names, documents and checks them.
struct Config {
    struct {
        std::string folder;
        Texts playlist;
        int seconds = 30;
        double fadeSeconds = 0.5;
        int memoryMebibytes = 0;
    } content;
    struct {
        double turnSeconds = 20;
        std::string camera = "orbit";
        bool animations = true;
        std::string background = "0.02,0.02,0.03";
        double exposure = 1;
        std::string toneMap = "neutral";
        bool energy = true;
        std::string sky;
        Texts suns;
        std::string ambient = "0.2,0.21,0.23";
        bool caption = true;
        bool statistics = false;
        std::string font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
        int pixelShift = 4;
    } show;
    struct {
        std::string output, mirror, driver, mode, modeline;
        std::string rotation = "panel";
        std::string format = "8888";
        std::string range = "full";
        bool assumeConnected = false;
        int maxPixels = 2560 * 1440;
        double maxFrameRate = 60;
        bool allowSoftware = false;
        std::string blanking = "off";
    } screen;
    struct {
        std::string touchRotation = "screen";
        bool grab = true;
    } input;
    Bindings keys, buttons, touch;
    std::array<Texts, 7> hours; ///< Opening hours, Monday first.
    struct {
        Texts closed;
        std::string restart;
    } timetable;
    struct {
        int pin = -1;
        std::string chip;
        bool activeLow = false;
        double idleMinutes = 0;
    } presence;
    struct {
        double hotCelsius = 80;
        int lowMebibytes = 16;
    } relief;
    struct {
        std::string state = "/var/lib/frankenshader-kiosk";
        std::string metrics;
        std::string heartbeat;
    } files;

    Config();
};

} // namespace kiosk
