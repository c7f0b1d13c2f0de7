// SPDX-License-Identifier: MIT
// The table of settings.
#include "franken/nearest.h"
#include "franken/platform/screen.h"
#include "kiosk/config/checks.h"
#include "kiosk/config/setting.h"

#include <algorithm>
#include <array>

namespace kiosk {

namespace {

using List = std::vector<Setting>;
using Fault = std::optional<std::string>;

constexpr std::array<const char*, 7> kDays = {"monday", "tuesday",  "wednesday", "thursday",
                                              "friday", "saturday", "sunday"};
constexpr std::array<std::string_view, 5> kGestures = {"tap", "double-tap", "swipe-left", "swipe-right",
                                                       "swipe-up"};

template<auto Parse>
Fault checkBy(const std::string& text) {
    return faultOf(Parse(text));
}

Fault checkKey(const std::string& name) {
    if (keyCode(name))
        return {};
    const std::vector<std::string> names = keyNames();
    const std::vector<std::string_view> views(names.begin(), names.end());
    const std::string_view nearest = franken::nearestWord(name, views);
    return "is no key" + (nearest.empty() ? std::string(": left, space, n, f1, page-down, ...")
                                          : "; \"" + std::string(nearest) + "\" was probably meant");
}

Fault checkGesture(const std::string& name) {
    if (std::find(kGestures.begin(), kGestures.end(), name) != kGestures.end())
        return {};
    return "is no gesture: tap, double-tap, swipe-left, swipe-right or swipe-up";
}

void addContent(List& list) {
    list.push_back({"content.folder",
                    Text{.of = [](Config& c) -> std::string& { return c.content.folder; }, .isPath = true},
                    "A folder that is watched: a .glb or .gltf that is copied in is shown from then on, one "
                    "that is removed is not. In the order of names."});
    list.push_back({"content.playlist",
                    TextList{.of = [](Config& c) -> Texts& { return c.content.playlist; }, .isPath = true},
                    "Models to show in this order, before those of the folder."});
    list.push_back({"content.seconds", Whole{[](Config& c) -> int& { return c.content.seconds; }, 0, 86400},
                    "How long each model is shown; 0: until somebody asks for the next one."});
    list.push_back(
        {"content.fade-seconds", Number{[](Config& c) -> double& { return c.content.fadeSeconds; }, 0, 10},
         "How long the picture takes to fade to the background, and again from it to the next model."});
    list.push_back(
        {"content.memory-mebibytes",
         Whole{[](Config& c) -> int& { return c.content.memoryMebibytes; }, 0, 4096},
         "GPU memory for models, MiB; 0: half of the kernel's contiguous memory (CmaTotal), or 512 "
         "where there is none.",
         Takes::Restart});
}

void addShow(List& list) {
    list.push_back({"show.turn-seconds",
                    Number{[](Config& c) -> double& { return c.show.turnSeconds; }, 0, 3600},
                    "How long one turn of the turntable takes; 0: the model stands still."});
    list.push_back(
        {"show.camera",
         Text{.of = [](Config& c) -> std::string& { return c.show.camera; }, .words = {"orbit", "file"}},
         "orbit: round the model, all of it in the picture; file: through the cameras of the file, "
         "where it has any."});
    list.push_back({"show.animations", Switch{[](Config& c) -> bool& { return c.show.animations; }},
                    "Play the animations of each file, one after the other."});
    list.push_back({"show.background",
                    Text{.of = [](Config& c) -> std::string& { return c.show.background; },
                         .check = checkBy<parseColor>,
                         .form = "R,G,B, each 0 to 1"},
                    "The colour behind the model, and between two models; as it is on the screen (sRGB)."});
    list.push_back({"show.exposure",
                    Number{[](Config& c) -> double& { return c.show.exposure; }, 0.001, 1000},
                    "Multiplies all light."});
    list.push_back({"show.tone-map",
                    Text{.of = [](Config& c) -> std::string& { return c.show.toneMap; },
                         .words = {"clip", "reinhard", "aces", "neutral"}},
                    "How light above white is brought into the screen's range."});
    list.push_back({"show.energy", Switch{[](Config& c) -> bool& { return c.show.energy; }},
                    "Rough surfaces keep the light that is scattered between their facets, which costs a few "
                    "instructions a pixel; false: they are darker."});
    list.push_back({"show.sky",
                    Text{.of = [](Config& c) -> std::string& { return c.show.sky; }, .isPath = true},
                    "A sky that lights the models and is seen behind them; best one that `bake` has made: a "
                    "picture takes a minute to filter."});
    list.push_back({"show.suns",
                    TextList{.of = [](Config& c) -> Texts& { return c.show.suns; },
                             .check = checkBy<parseSun>,
                             .form = "X,Y,Z or X,Y,Z:R,G,B"},
                    "Suns: where their light travels, and their colour. Without any, the lights of the file "
                    "are used, or one sun where it has none."});
    list.push_back({"show.ambient",
                    Text{.of = [](Config& c) -> std::string& { return c.show.ambient; },
                         .check = checkBy<parseColor>,
                         .form = "R,G,B, linear"},
                    "Light from everywhere, where there is no sky."});
    list.push_back({"show.caption", Switch{[](Config& c) -> bool& { return c.show.caption; }},
                    "Show the name of the model: the first line of a .txt beside it of the same name, or the "
                    "file's name."});
    list.push_back({"show.statistics", Switch{[](Config& c) -> bool& { return c.show.statistics; }},
                    "Show frame times, memory, temperature."});
    list.push_back({"show.font",
                    Text{.of = [](Config& c) -> std::string& { return c.show.font; }, .isPath = true},
                    "The TrueType font of texts (Debian: fonts-dejavu-core).", Takes::Restart});
    list.push_back(
        {"show.pixel-shift", Whole{[](Config& c) -> int& { return c.show.pixelShift; }, 0, 64},
         "How far texts wander, in pixels, so that they do not burn into the screen; 0: not at all."});
}

void addScreen(List& list) {
    const auto add = [&list](const char* key, auto kind, const char* help, Takes takes = Takes::Restart) {
        list.push_back({key, std::move(kind), help, takes});
    };
    add("screen.output", Text{.of = [](Config& c) -> std::string& { return c.screen.output; }},
        "The kernel's name of the output, as HDMI-A-1 or DSI-1 (`kiosk doctor` lists them); empty: the first "
        "with a screen, built-in panels before plugs.");
    add("screen.mirror", Text{.of = [](Config& c) -> std::string& { return c.screen.mirror; }},
        "A second output that shows the same.");
    add("screen.driver", Text{.of = [](Config& c) -> std::string& { return c.screen.driver; }},
        "The kernel's driver, as vc4, where two have an output of that name.");
    add("screen.mode",
        Text{.of = [](Config& c) -> std::string& { return c.screen.mode; },
             .check = checkBy<franken::platform::parseModeRequest>,
             .form = "WIDTHxHEIGHT or WIDTHxHEIGHT@HERTZ"},
        "Empty: the screen's preferred mode.");
    add("screen.modeline",
        Text{.of = [](Config& c) -> std::string& { return c.screen.modeline; },
             .check = checkBy<franken::platform::parseModeline>,
             .form = "as `cvt` prints it"},
        "The timing of a screen that does not tell its modes.");
    add("screen.assume-connected", Switch{[](Config& c) -> bool& { return c.screen.assumeConnected; }},
        "Use the output even if no screen is seen on it.");
    add("screen.rotation",
        Text{.of = [](Config& c) -> std::string& { return c.screen.rotation; },
             .words = {"panel", "0", "90", "180", "270"}},
        "How far the screen is turned clockwise, as one sees it; panel: as the kernel knows it.");
    add("screen.format",
        Text{.of = [](Config& c) -> std::string& { return c.screen.format; },
             .words = {"8888", "10bit", "565"}},
        "Bits of a pixel; 565 halves the memory traffic.");
    add("screen.range",
        Text{.of = [](Config& c) -> std::string& { return c.screen.range; },
             .words = {"full", "limited", "automatic"}},
        "Codes on HDMI: full for monitors, limited for television sets that show grey for black.");
    add("screen.max-pixels", Whole{[](Config& c) -> int& { return c.screen.maxPixels; }, 10000, 33177600},
        "Most pixels of the picture; a mode with more is not chosen.");
    add("screen.max-frame-rate", Number{[](Config& c) -> double& { return c.screen.maxFrameRate; }, 1, 240},
        "Most frames a second.", Takes::Effect);
    add("screen.allow-software", Switch{[](Config& c) -> bool& { return c.screen.allowSoftware; }},
        "Draw with the processor where the GPU cannot be used.");
    add("screen.blanking",
        Text{.of = [](Config& c) -> std::string& { return c.screen.blanking; }, .words = {"off", "black"}},
        "How the screen is made dark when the shop is closed or nobody is there: its signal is switched off, "
        "or the picture is black.",
        Takes::Effect);
}

void addBindings(List& list, const std::string& section, Bindings Config::*bindings, const Check& check,
                 const std::string& form, Takes takes) {
    for (const std::string_view action : kActions)
        list.push_back({section + "." + std::string(action),
                        TextList{.of = [bindings, name = std::string(action)](Config& c) -> Texts& {
                                     return (c.*bindings)[name];
                                 },
                                 .check = check,
                                 .form = form},
                        "", takes});
}

void addControls(List& list) {
    list.push_back({"input.touch-rotation",
                    Text{.of = [](Config& c) -> std::string& { return c.input.touchRotation; },
                         .words = {"screen", "0", "90", "180", "270"}},
                    "How far the touch sensor is turned clockwise; screen: as the screen.", Takes::Restart});
    list.push_back({"input.grab", Switch{[](Config& c) -> bool& { return c.input.grab; }},
                    "Keep keys and touches from all other programs.", Takes::Restart});
    addBindings(list, "keys", &Config::keys, checkKey, "names of keys", Takes::Effect);
    addBindings(list, "buttons", &Config::buttons, checkBy<parseButton>,
                "GPIO17, GPIO17:long or GPIO17:double", Takes::Restart);
    addBindings(list, "touch", &Config::touch, checkGesture, "names of gestures", Takes::Effect);
}

void addTimes(List& list) {
    for (std::size_t day = 0; day < kDays.size(); ++day)
        list.push_back({std::string("timetable.") + kDays[day],
                        TextList{.of = [day](Config& c) -> Texts& { return c.hours[day]; },
                                 .check = checkBy<parseHours>,
                                 .form = "HH:MM-HH:MM"},
                        day == 0
                            ? "Opening hours of each day; the screen is dark otherwise. Without any hours "
                              "at all, it is always open."
                            : ""});
    list.push_back({"timetable.closed",
                    TextList{.of = [](Config& c) -> Texts& { return c.timetable.closed; },
                             .check = checkBy<parseDate>,
                             .form = "YYYY-MM-DD or MM-DD"},
                    "Days on which it stays closed."});
    list.push_back(
        {"timetable.restart",
         Text{.of = [](Config& c) -> std::string& { return c.timetable.restart; },
              .check = checkBy<parseClock>,
              .form = "HH:MM"},
         "When the program ends every day, to be started again by the service manager; empty: never."});
    list.push_back({"presence.pin", Whole{[](Config& c) -> int& { return c.presence.pin; }, -1, 1023},
                    "The GPIO of a motion sensor; -1: none.", Takes::Restart});
    list.push_back({"presence.chip", Text{.of = [](Config& c) -> std::string& { return c.presence.chip; }},
                    "Its chip, by label or name; empty: that of the Raspberry Pi's header.", Takes::Restart});
    list.push_back({"presence.active-low", Switch{[](Config& c) -> bool& { return c.presence.activeLow; }},
                    "The sensor pulls its line down where it sees somebody.", Takes::Restart});
    list.push_back({"presence.idle-minutes",
                    Number{[](Config& c) -> double& { return c.presence.idleMinutes; }, 0, 1440},
                    "Without motion, keys and touches for so long, the screen becomes dark; 0: never."});
}

void addMachine(List& list) {
    list.push_back(
        {"relief.hot-celsius", Number{[](Config& c) -> double& { return c.relief.hotCelsius; }, 40, 110},
         "From this temperature of the processor on, resolution and frame rate are lowered step by "
         "step; so they are where the firmware throttles it."});
    list.push_back({"relief.low-mebibytes",
                    Whole{[](Config& c) -> int& { return c.relief.lowMebibytes; }, 0, 1024},
                    "With less contiguous memory free (CmaFree, MiB), no model is loaded ahead."});
    list.push_back(
        {"files.state", Text{.of = [](Config& c) -> std::string& { return c.files.state; }, .isPath = true},
         "The folder for what is kept from start to start: the list of shader programs, Mesa's cache, "
         "screenshots. Empty: nothing is kept.",
         Takes::Restart});
    list.push_back({"files.metrics",
                    Text{.of = [](Config& c) -> std::string& { return c.files.metrics; }, .isPath = true},
                    "A file for node_exporter's textfile collector, written every 15 seconds; empty: none. "
                    "Its name ends in .prom."});
    list.push_back(
        {"files.heartbeat",
         Text{.of = [](Config& c) -> std::string& { return c.files.heartbeat; }, .isPath = true},
         "A file with the number of frames and the checksum of the picture, written every 10 seconds; "
         "empty: none."});
}

List makeSettings() {
    List list;
    addContent(list);
    addShow(list);
    addScreen(list);
    addControls(list);
    addTimes(list);
    addMachine(list);
    return list;
}

} // namespace

Config::Config() {
    for (const std::string_view action : kActions)
        for (Bindings* bindings : {&keys, &buttons, &touch})
            (*bindings)[std::string(action)];
    keys["next"] = {"right", "space", "page-down"};
    keys["previous"] = {"left", "page-up"};
    keys["pause"] = {"p", "play-pause"};
    keys["lights"] = {"l"};
    keys["brighter"] = {"plus", "up"};
    keys["darker"] = {"minus", "down"};
    keys["next-camera"] = {"c"};
    keys["caption"] = {"n"};
    keys["statistics"] = {"s", "f1"};
    keys["screenshot"] = {"print"};
    touch["next"] = {"swipe-left"};
    touch["previous"] = {"swipe-right"};
    touch["pause"] = {"double-tap"};
}

std::span<const Setting> settings() {
    static const List list = makeSettings();
    return list;
}

std::string sectionHelp(std::string_view section) {
    if (section == "keys")
        return "What keys do, by action: each has any number of keys. Any key wakes a screen that is "
               "dark\n"
               "because nobody is there.";
    if (section == "buttons")
        return "What buttons on GPIO lines do, each against ground: GPIO17, GPIO17:long (held for 0.8 s) "
               "or\n"
               "GPIO17:double, with the numbers of the Raspberry Pi's header.";
    if (section == "touch")
        return "What gestures do: tap, double-tap, and with two fingers swipe-left, swipe-right and "
               "swipe-up.\n"
               "One finger turns the model; two that part or close bring it nearer or take it away.";
    if (section == "timetable")
        return "Opening hours, by the local time; heeded only while the clock is synchronised.";
    return {};
}

} // namespace kiosk
