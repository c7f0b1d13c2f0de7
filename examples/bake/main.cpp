// SPDX-License-Identifier: MIT
#include "common/exit_code.h"
#include "common/progress_bar.h"
#include "franken/baked_sky.h"
#include "franken/command_line/manual.h"
#include "franken/command_line/mistake.h"
#include "franken/file_writer.h"
#include "franken/printable.h"

#include <iostream>

using namespace franken;

namespace {

constexpr char kAbout[] =
    "Filters a sky once, so that a Pi only loads it: its irradiance, its reflection for each roughness, and\n"
    "the skybox.";
constexpr char kFooter[] = "The file's format is in franken/baked_sky.h. `viewer --skybox` takes it.\n"
                           "Exit codes: 0 ok, 2 usage, 3 the sky was refused, 4 the file cannot be written.\n"
                           "Example: bake venice.hdr -o venice.sky --sun";

struct Options {
    std::filesystem::path sky, output;
    BakeOptions bake;
};

ExitCode fail(const Error& error, ExitCode code) {
    std::cerr << "bake: error: " << printable(error) << "\n";
    return code;
}

ExitCode run(Options options) {
    // Baking in place would destroy the source.
    if (const Result<void> checked = checkNotInput(options.output, {{options.sky}}); !checked)
        return fail(checked.error(), ExitCode::Usage);
    if (isBakedSky(options.sky))
        return fail({"bake.baked", options.sky.string(), "it is baked already",
                     "give it to viewer --skybox, or bake its source"},
                    ExitCode::Refused);
    ProgressBar bar("filtering");
    options.bake.progress = [&bar](float share) { bar.show(share); };
    // Whoever bakes sits at a desktop, and knows the file.
    const SkyLimits limits{.maxFileBytes = std::size_t{1} << 30, .maxMemoryBytes = std::size_t{2} << 30};
    Result<Environment> sky = loadEnvironment(options.sky, limits);
    if (!sky)
        return fail(sky.error(), ExitCode::Refused);
    const BakedSky baked = bakeSky(*std::move(sky), options.bake);
    if (options.bake.sun && !baked.sun)
        std::cerr << "bake: warning: no part of the sky is bright enough to be a sun\n";
    const Result<void> written = writeFile(options.output, encodeBakedSky(baked));
    return written ? ExitCode::Ok : fail(written.error(), ExitCode::Device);
}

} // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app(kAbout, "bake");
    app.set_version_flag("-V,--version", "bake " FRANKEN_VERSION);
    app.footer(kFooter);
    app.add_option("SKY", options.sky, "A .hdr, .exr or .hdre, a cross, or a folder of six faces")
        ->required()
        ->check(cli::notEmpty());
    app.add_option("-o,--output-file", options.output, "The baked sky [SKY's name with .sky]")
        ->type_name("FILE")
        ->check(cli::notEmpty());
    app.add_flag("--sun", options.bake.sun, "Takes the sun out and stores it as a directional light");
    app.add_option("--skybox-size", options.bake.skyboxSize,
                   "Edge of the skybox's faces, texels; 0 for no skybox [512]")
        ->type_name("TEXELS")
        ->check(cli::wholeNumber(0, kMaxSkyWidth / 4));
    app.add_option("--reflection-size", options.bake.reflectionSize,
                   "Edge of the squares of the sharpest reflection, texels; a Pi 3 takes up to 512 [256]")
        ->type_name("TEXELS")
        ->check(cli::wholeNumber(kMinReflectionSize, kMaxReflectionSize));
    cli::addManual(app, "frankenshader-bake");
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& success) {
        return app.exit(success);
    } catch (const CLI::ParseError& error) {
        return static_cast<int>(fail(cli::mistakeIn(app, error), ExitCode::Usage));
    }
    if (options.output.empty())
        options.output = options.sky.has_stem() ? options.sky.stem().concat(".sky") : "out.sky";
    return static_cast<int>(run(options));
}
