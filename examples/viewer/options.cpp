// SPDX-License-Identifier: MIT
#include "options.h"

#include "franken/command_line/manual.h"
#include "franken/command_line/mistake.h"
#include "franken/generator/choices.h"
#include "franken/printable.h"
#include "price/frame_price.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iostream>

using namespace franken;

namespace {

constexpr char kAbout[] =
    "Draws a glTF model to a PNG, with the one program that each of its materials needs.";
constexpr char kFooter[] =
    "The file's own camera and lights are used where it has them. Without a camera, the model is framed, "
    "and\n"
    "without a camera and any light it gets a sun and some ambient light.\n"
    "Colours are linear, unless said otherwise. A sun of 3.14 lux makes a white surface that faces it 1.0.\n"
    "--supersample averages encoded colours, as a display and MSAA on these GPUs do.\n"
    "Exit codes: 0 ok, 2 usage, 3 a file was refused, 4 no context, a program that does not compile, or a\n"
    "file that cannot be written.\n"
    "Example: viewer WaterBottle.gltf -o bottle.png --size 800x600 --sun -1,-1,-0.5:3,3,2.5 --tone-map "
    "neutral";

constexpr int kMaxTurntable = 3600;
constexpr int kMaxStripWidth = 16384;    // Pixels; with a height as the screens of kiosks have, 70 MiB.
constexpr unsigned kMaxMebibytes = 4095; // What 32 bits can count the bytes of.

// The whole text is one number.
float toNumber(const std::string& option, std::string_view text) {
    float value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        throw CLI::ValidationError(option, "'" + std::string(text) + "' is not a number");
    return value;
}

Float3 toFloat3(const std::string& option, const std::string& text) {
    const std::vector<std::string> parts = CLI::detail::split(text, ',');
    if (parts.size() != 3)
        throw CLI::ValidationError(option, "'" + text + "' is not three numbers with commas between");
    return {toNumber(option, parts[0]), toNumber(option, parts[1]), toNumber(option, parts[2])};
}

Float4 toFloat4(const std::string& option, const std::string& text) {
    const std::vector<std::string> parts = CLI::detail::split(text, ',');
    if (parts.size() != 4)
        throw CLI::ValidationError(option, "'" + text + "' is not four numbers with commas between");
    return {toNumber(option, parts[0]), toNumber(option, parts[1]), toNumber(option, parts[2]),
            toNumber(option, parts[3])};
}

Float3 toColor(const std::string& option, const std::string& text) {
    const Float3 color = toFloat3(option, text);
    if (color[0] < 0 || color[1] < 0 || color[2] < 0)
        throw CLI::ValidationError(option, "'" + text + "': a colour has no negative parts");
    return color;
}

Sun toSun(const std::string& text) {
    constexpr Float3 kPi = {3.1415927f, 3.1415927f, 3.1415927f};
    const std::size_t colon = text.find(':');
    Sun sun;
    sun.direction = toFloat3("--sun", text.substr(0, colon));
    if (sun.direction == Float3{0, 0, 0})
        throw CLI::ValidationError("--sun", "'" + text + "' has no direction");
    sun.color = colon == std::string::npos ? kPi : toColor("--sun", text.substr(colon + 1));
    sun.illuminance = 1;
    return sun;
}

platform::Size toSize(const std::string& text) {
    const std::vector<std::string> parts = CLI::detail::split(text, 'x');
    int width = 0, height = 0;
    if (parts.size() != 2 || !CLI::detail::lexical_cast(parts[0], width) ||
        !CLI::detail::lexical_cast(parts[1], height) || width < 1 || height < 1)
        throw CLI::ValidationError("--size", "'" + text + "' is not WIDTHxHEIGHT in pixels");
    return {width, height};
}

std::array<int, 2> toPixel(const std::string& text) {
    const std::vector<std::string> parts = CLI::detail::split(text, ',');
    std::array<int, 2> pixel{};
    if (parts.size() != 2 || !CLI::detail::lexical_cast(parts[0], pixel[0]) ||
        !CLI::detail::lexical_cast(parts[1], pixel[1]))
        throw CLI::ValidationError("--pick", "'" + text + "' is not a pixel, X,Y");
    return pixel;
}

// A permutation's word as an option takes it whose name says the rest: "--decode srgb" for "decode-srgb".
std::string withoutAffix(std::string_view word, std::string_view affix) {
    if (word.starts_with(affix))
        word.remove_prefix(affix.size());
    else if (word.ends_with(affix))
        word.remove_suffix(affix.size());
    return std::string(word);
}

template<typename Value>
void addChoice(CLI::App& app, const char* name, Value& value, const char* text,
               const std::vector<std::pair<std::string, Value>>& words) {
    std::vector<std::string> names;
    names.reserve(words.size());
    for (const auto& [word, meaning] : words)
        names.push_back(word);
    app.add_option_function<std::string>(
           name,
           [&value, words](const std::string& chosen) {
               for (const auto& [word, meaning] : words)
                   if (word == chosen)
                       value = meaning;
           },
           text + (": " + CLI::detail::join(names, ", ")) + " [" + names.front() + "]")
        ->type_name("WORD")
        ->check(cli::oneOf(names));
}

// An option that takes the words of a choice of the permutation, new ones without further ado.
template<typename Value>
void addChoice(CLI::App& app, const char* name, Value& value, const char* text, std::string_view choice,
               std::string_view affix = "") {
    std::vector<std::pair<std::string, Value>> words;
    for (const Choice& each : choices())
        if (each.name == choice)
            for (const auto& option : each.options)
                words.emplace_back(withoutAffix(option.word, affix), static_cast<Value>(words.size()));
    addChoice(app, name, value, text, words);
}

void addTarget(CLI::App& app, Options& options) {
    app.add_option("-o,--output-file", options.output, "The picture [out.png]")
        ->type_name("FILE")
        ->check(cli::notEmpty());
    app.add_option_function<std::string>(
           "--size", [&options](const std::string& text) { options.size = toSize(text); },
           "In pixels [512x512]")
        ->type_name("WxH");
    app.add_option("--turntable", options.turntable,
                   "So many pictures from all around, the camera going to the right round the middle of the "
                   "model: FILE with -1, -2, ... before its extension")
        ->type_name("N")
        ->check(cli::wholeNumber(1, kMaxTurntable));
    app.add_option("--frames", options.frames,
                   "So many pictures of one round of the animation, from --time on, at equal distances: FILE "
                   "with the number of each in place of %d or %04d (frame_%04d.png), or -1, -2, ... before "
                   "its extension")
        ->type_name("N")
        ->check(cli::wholeNumber(1, kMaxTurntable))
        ->excludes("--turntable");
    app.add_flag("--strip", options.strip,
                 "All pictures of --frames or --turntable in one, the first at the left");
    app.add_flag("--supersample", options.supersample, "Four samples a pixel");
    addChoice(app, "--backend", options.backend, "What draws",
              {{"osmesa", platform::Backend::OsMesa}, {"egl", platform::Backend::EglSurfaceless}});
}

void addPrograms(CLI::App& app, Options& options) {
    app.add_flag(
        "--permutations", options.permutations,
        "Prints the manifest of the picture, which is the programs that it needs, a name a line, and "
        "draws nothing");
    app.add_option("--manifest", options.manifest,
                   "Makes the programs that this file lists before it draws, as a kiosk does that shows more "
                   "than one model; adds what it lacks at the end")
        ->type_name("FILE")
        ->check(cli::notEmpty())
        ->excludes("--permutations");
    app.add_flag("--stats", options.stats,
                 "Prints what was compiled before the frame and in it, and the GPU memory that it took")
        ->excludes("--permutations");
    app.add_option("--snippets", options.snippets,
                   "Composes from the files of this folder, a source tree's generator/glsl, instead of those "
                   "that are built in")
        ->type_name("FOLDER")
        ->check(cli::notEmpty());
    auto* const effect =
        app.add_option(
               "--effect", options.effect,
               "Puts an effect into the programs of all surfaces: a file such as examples/effects/fog.glsl")
            ->type_name("FILE")
            ->check(cli::notEmpty());
    app.add_option_function<std::vector<std::string>>(
           "--effect-value",
           [&options](const std::vector<std::string>& texts) {
               for (const std::string& text : texts)
                   options.effectValues.push_back(toFloat4("--effect-value", text));
           },
           "The next of the effect's vec4, in the order of its file; may be repeated [0,0,0,0]")
        ->type_name("X,Y,Z,W")
        ->allow_extra_args(false)
        ->needs(effect);
}

void addLoading(CLI::App& app, Options& options) {
    app.add_option_function<unsigned>(
           "--memory", [&options](unsigned mebibytes) { options.memoryBytes = std::size_t{mebibytes} << 20; },
           "The most that loading the model may take, and loading the sky, in MiB; what needs more is "
           "refused [240]")
        ->type_name("MIB")
        ->check(cli::wholeNumber(1, kMaxMebibytes));
    app.add_flag("--watch", options.watch,
                 "Draws again whenever the model, the height map, the sky, a snippet or the effect changes, "
                 "until it is interrupted; keeps the last good picture on an error")
        ->excludes("--permutations")
        ->excludes("--turntable")
        ->excludes("--frames");
    app.add_flag(
           "--list", options.list,
           "Prints what is in the file (cameras, lights, variants, materials, images, nodes), and draws "
           "nothing")
        ->excludes("--permutations")
        ->excludes("--watch");
    app.add_option_function<std::string>(
           "--pick", [&options](const std::string& text) { options.pick = toPixel(text); },
           "Prints what a pixel of the picture shows (node, material, primitive, triangle, point), and draws "
           "nothing; from the upper left corner, 0,0")
        ->type_name("X,Y")
        ->excludes("--permutations")
        ->excludes("--watch")
        ->excludes("--list")
        ->excludes("--turntable")
        ->excludes("--frames");
}

void addPrice(CLI::App& app, Options& options) {
    auto* const price =
        app.add_option("--price", options.price,
                       "Prints what the picture costs on a Raspberry Pi, in milliseconds, what that time "
                       "goes by, and "
                       "which changes would bring most: counted and computed here, without its GPU: " +
                           CLI::detail::join(price::machineWords(), ", "))
            ->type_name("PI")
            ->check(cli::oneOf(price::machineWords()))
            ->excludes("--permutations")
            ->excludes("--list")
            ->excludes("--pick")
            ->excludes("--watch")
            ->excludes("--turntable")
            ->excludes("--frames");
    app.add_flag("--json", options.json, "The price as JSON")->needs(price)->excludes("--stats");
    app.add_flag("--measure", options.measure,
                 "On a Raspberry Pi, with --backend egl: times the picture as well, and prints measured "
                 "beside predicted")
        ->needs(price)
        ->excludes("--json");
}

void checkStrip(const Options& options) {
    const std::int64_t count = std::max(options.frames, options.turntable);
    if (options.strip && count == 0)
        throw CLI::ValidationError("--strip", "it needs --frames or --turntable");
    if (options.strip && count * options.size.width > kMaxStripWidth)
        throw CLI::ValidationError("--strip", std::to_string(count) + " pictures side by side may be " +
                                                  std::to_string(kMaxStripWidth) +
                                                  " pixels wide in all: make --size smaller");
}

void checkTogether(const Options& options) {
    const std::filesystem::path inputs[] = {options.model,    options.skybox,   options.heightMap,
                                            options.manifest, options.snippets, options.effect};
    if (const Result<void> checked = checkOutputs(options, inputs); !checked)
        throw CLI::ValidationError("--output-file", checked.error().what);
    if (options.look.energy && options.look.brdf == Brdf::Seed)
        throw CLI::ValidationError("--energy", "the reflectance model 'seed' has no such form");
    if (options.frames > 0 && options.animation.empty())
        throw CLI::ValidationError("--frames", "it needs --animation");
    checkStrip(options);
    if (options.measure && options.backend != platform::Backend::EglSurfaceless)
        throw CLI::ValidationError("--measure", "it needs --backend egl, which draws on the GPU");
    if (const auto& pick = options.pick)
        if ((*pick)[0] < 0 || (*pick)[1] < 0 || (*pick)[0] >= options.size.width ||
            (*pick)[1] >= options.size.height)
            throw CLI::ValidationError("--pick", "the pixel is not one of the picture");
}

void addModel(CLI::App& app, Options& options) {
    app.add_option("MODEL", options.model, "A .gltf or .glb file")->required()->check(cli::notEmpty());
    app.add_option(
           "--camera", options.camera,
           "One of the file's cameras, by its name, its node's name, or its index in the file [the first]")
        ->type_name("NAME|INDEX");
    app.add_flag("--frame", options.frame, "Show all of the model, whatever cameras the file has")
        ->excludes("--camera");
    app.add_option("--variant", options.variant,
                   "One of the file's variants (KHR_materials_variants), by its name")
        ->type_name("NAME");
    app.add_option("--animation", options.animation,
                   "One of the file's animations, by its name or its index in the file: the picture shows it "
                   "at --time. Nodes, skins, morph targets, cameras and lights move [none]")
        ->type_name("NAME|INDEX");
    app.add_option_function<std::string>(
           "--time", [&options](const std::string& text) { options.time = toNumber("--time", text); },
           "Of the animation, which holds its ends [0]")
        ->type_name("SECONDS")
        ->needs("--animation");
}

void addLights(CLI::App& app, Options& options) {
    app.add_option_function<std::vector<std::string>>(
           "--sun",
           [&options](const std::vector<std::string>& texts) {
               for (const std::string& text : texts)
                   options.suns.push_back(toSun(text));
           },
           "One more sun: where its light travels, and its colour in lux [3.14 each]; may be repeated")
        ->type_name("X,Y,Z[:R,G,B]")
        ->allow_extra_args(false);
    app.add_option_function<std::string>(
           "--ambient", [&options](const std::string& text) { options.ambient = toColor("--ambient", text); },
           "Light from everywhere, as a radiance")
        ->type_name("R,G,B");
    app.add_option(
           "--skybox", options.skybox,
           "A sky that lights the model and is seen behind it: .hdr, cross, a folder of six faces, or what "
           "bake made of one")
        ->type_name("FILE")
        ->check(cli::notEmpty());
    app.add_flag("--sky-sun", options.skySun,
                 "Takes the sun out of the sky, so that it is one more sun with sharp highlights");
}

void addExposure(CLI::App& app, Options& options) {
    app.add_option_function<std::string>(
           "--exposure",
           [&options](const std::string& text) {
               options.autoExposure = text == "auto";
               if (options.autoExposure)
                   return;
               options.exposure = toNumber("--exposure", text);
               if (*options.exposure <= 0)
                   throw CLI::ValidationError("--exposure", "it must be above 0");
           },
           "Multiplies all light; auto: so that a white surface that faces it is just white [1, or auto "
           "where over half of the model would be white]")
        ->type_name("FACTOR|auto");
}

void addBackground(CLI::App& app, Options& options) {
    app.add_option_function<std::string>(
           "--background",
           [&options](const std::string& text) {
               options.background = toColor("--background", text);
               for (const float part : options.background)
                   if (part > 1)
                       throw CLI::ValidationError("--background", "'" + text + "': a display shows 0 to 1");
           },
           "As the display gets it, 0 to 1 [0,0,0]")
        ->type_name("R,G,B");
}

void addHeights(CLI::App& app, Options& options) {
    app.add_option(
           "--height-map", options.heightMap,
           "Moves the vertices of all materials along their normals by this PNG or JPEG; mid-grey stays")
        ->type_name("FILE")
        ->check(cli::notEmpty());
    app.add_option_function<std::string>(
           "--height-scale",
           [&options](const std::string& text) { options.heightScale = toNumber("--height-scale", text); },
           "How far white lies above black, in the model's unit [0.1]")
        ->type_name("LENGTH");
}

void addLook(CLI::App& app, Look& look) {
    addChoice(app, "--tone-map", look.toneMap, "The tone map", "toneMap");
    addChoice(app, "--brdf", look.brdf, "The reflectance model", "brdf");
    app.add_flag("--energy", look.energy, "Rough surfaces keep what is scattered between their facets");
    addChoice(app, "--output", look.output, "How colours are encoded", "output");
    addChoice(app, "--decode", look.decode, "How colour textures are decoded", "decode", "decode-");
    addChoice(app, "--view", look.view, "What is shown of the materials", "view", "view-");
    addChoice(app, "--light-vectors", look.lightVectors, "Where light vectors are computed", "lightVectors",
              "light");
    addChoice(app, "--dither", look.dither, "Dithering", "dither");
}

} // namespace

std::variant<ExitCode, Options> parseCommandLine(int argc, const char* const* argv) {
    Options options;
    CLI::App app(kAbout, "viewer");
    app.set_version_flag("-V,--version", "viewer " FRANKEN_VERSION);
    app.footer(kFooter);
    addModel(app, options);
    addLights(app, options);
    addExposure(app, options);
    addBackground(app, options);
    addHeights(app, options);
    addTarget(app, options);
    addPrograms(app, options);
    addLoading(app, options);
    addPrice(app, options);
    addLook(app, options.look);
    cli::addManual(app, "frankenshader-viewer");
    try {
        app.parse(argc, argv);
        checkTogether(options);
    } catch (const CLI::Success& success) {
        app.exit(success);
        return ExitCode::Ok;
    } catch (const CLI::ParseError& error) {
        std::cerr << "viewer: error: " << printable(cli::mistakeIn(app, error)) << "\n";
        return ExitCode::Usage;
    }
    return options;
}
