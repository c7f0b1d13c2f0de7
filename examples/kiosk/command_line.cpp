// SPDX-License-Identifier: MIT
#include "kiosk/command_line.h"

#include "franken/command_line/manual.h"
#include "franken/command_line/mistake.h"
#include "franken/printable.h"
#include "kiosk/config/setting.h"

#include <iostream>

namespace kiosk {

namespace platform = franken::platform;

namespace {

constexpr char kAbout[] = "Shows glTF models on a screen, for months.";
constexpr char kFooter[] =
    "Each setting of the configuration is an option as well, and wins over the file:\n"
    "    kiosk --content.playlist \"vase.glb urn.glb\" --show.turn-seconds 10\n"
    "`kiosk settings` prints all of them, as a file that says what each does.\n"
    "Exit codes: 0 ok, 1 `doctor` found something wrong, 2 usage, 3 a file was refused, 4 no screen or no\n"
    "context.";

void addSettings(CLI::App& app, Overrides& overrides) {
    for (const Setting& setting : settings())
        app.add_option_function<std::string>(
               "--" + setting.key,
               [&overrides, key = setting.key](const std::string& text) {
                   overrides.emplace_back(key, text);
               },
               setting.help)
            ->group(""); // `kiosk settings` is where they are read.
}

platform::Backend toBackend(const std::string& word) {
    const auto backend = platform::parseBackend(word);
    if (!backend)
        throw CLI::ValidationError("--backend", franken::toString(backend.error()));
    return *backend;
}

platform::Size toSize(const std::string& text) {
    const auto request = platform::parseModeRequest(text);
    if (!request || request->refresh != 0)
        throw CLI::ValidationError("--size", "'" + text + "' is not WIDTHxHEIGHT in pixels");
    return request->size;
}

/// A mistyped command is taken for a model: nothing is there by that name, and it is no name of a model.
std::optional<franken::Error> mistypedCommand(const CLI::App& app, const std::vector<std::string>& models) {
    if (models.empty() || std::filesystem::path(models[0]).has_extension())
        return {};
    std::error_code error;
    const std::string nearest = franken::cli::nearestOf(models[0], franken::cli::commandsOf(app));
    if (nearest.empty() || std::filesystem::exists(models[0], error))
        return {};
    return franken::Error{"usage", "", "'" + models[0] + "' is neither a command nor a file",
                          "did you mean '" + nearest + "'?"};
}

struct Parsed {
    RunOptions run;
    DrawFrame frame;
    CheckFile check;
    Examine examine;
    std::vector<std::string> models;
};

void addRun(CLI::App& app, Parsed& parsed) {
    app.add_option("-c,--config", parsed.run.config, "The configuration")->type_name("FILE");
    app.add_option("MODEL", parsed.models, "Models to show: stands for --content.playlist");
    app.add_option_function<std::string>(
           "--backend", [&parsed](const std::string& word) { parsed.run.backend = toBackend(word); },
           "Where to draw: kms (a screen), window, egl or osmesa [kms; egl with --frame]")
        ->type_name("WORD");
    app.add_option("--frame", parsed.frame.output, "Draw one picture of the first model, and end")
        ->type_name("PNG");
    app.add_option_function<std::string>(
           "--size", [&parsed](const std::string& text) { parsed.frame.size = toSize(text); },
           "Of the picture [1280x720]")
        ->type_name("WxH");
    app.add_option("--time", parsed.frame.seconds, "What the picture shows: seconds after the model came [0]")
        ->check(CLI::Range(0.0, 86400.0))
        ->type_name("SECONDS");
    app.add_option("--loading", parsed.frame.loaded,
                   "Draw what is shown until the first model is there, with so much of the bar filled")
        ->check(CLI::Range(0.0, 1.0))
        ->needs("--frame")
        ->type_name("0..1");
    app.add_option("--root", parsed.run.root, "Where /sys, /proc and /run are: for tests")
        ->type_name("FOLDER");
    addSettings(app, parsed.run.overrides);
}

Command commandOf(const CLI::App& app, Parsed& parsed) {
    if (app.got_subcommand("check"))
        return parsed.check;
    if (app.got_subcommand("settings"))
        return PrintSettings{};
    if (app.got_subcommand("doctor"))
        return parsed.examine;
    for (const std::string& model : parsed.models)
        parsed.run.models.push_back(model);
    if (parsed.frame.output.empty())
        return Run{parsed.run};
    if (app.get_option("--backend")->empty())
        parsed.run.backend = platform::Backend::EglSurfaceless;
    parsed.frame.options = parsed.run;
    return parsed.frame;
}

} // namespace

Command parseCommandLine(int count, const char* const* arguments) {
    CLI::App app(kAbout, "kiosk");
    app.footer(kFooter);
    app.set_version_flag("-V,--version", "kiosk " FRANKEN_VERSION);
    Parsed parsed;
    addRun(app, parsed);
    app.require_subcommand(0, 1);
    CLI::App* check = app.add_subcommand("check", "Say what is wrong with a configuration");
    check->add_option("FILE", parsed.check.file, "The configuration")->required();
    app.add_subcommand("settings", "Print all settings, as a file that says what each does");
    CLI::App* doctor = app.add_subcommand("doctor", "Say what is wrong with this machine, and what mends it");
    doctor->add_option("-c,--config", parsed.examine.config, "The configuration")->type_name("FILE");
    doctor->add_flag("--json", parsed.examine.json, "For programs");
    doctor->add_option("--report", parsed.examine.report, "Write all of it to one file, to send to somebody")
        ->type_name("FILE");
    doctor->add_option("--root", parsed.examine.root, "Where /sys, /proc and /dev are: for tests")
        ->type_name("FOLDER");
    franken::cli::addManual(app, "frankenshader-kiosk");
    try {
        app.parse(count, arguments);
    } catch (const CLI::Success& success) {
        app.exit(success);
        return ExitCode::Ok;
    } catch (const CLI::ParseError& error) {
        std::cerr << "kiosk: " << franken::printable(franken::cli::mistakeIn(app, error)) << "\n";
        return ExitCode::Usage;
    }
    if (const auto mistake = mistypedCommand(app, parsed.models)) {
        std::cerr << "kiosk: " << franken::printable(*mistake) << "\n";
        return ExitCode::Usage;
    }
    return commandOf(app, parsed);
}

} // namespace kiosk
