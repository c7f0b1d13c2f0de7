// SPDX-License-Identifier: MIT
#pragma once

#include "common/exit_code.h"
#include "franken/generator/pack.h"
#include "franken/gltf.h"
#include "franken/material.h"
#include "franken/platform/surface.h"
#include "franken/result.h"

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

struct Options {
    std::filesystem::path model;
    std::filesystem::path output = "out.png";
    franken::platform::Backend backend = franken::platform::Backend::OsMesa;
    franken::platform::Size size = {512, 512};
    int turntable = 0;  ///< How many pictures all around; 0 for one picture.
    int frames = 0;     ///< How many pictures of one round of the animation; 0 for one picture.
    bool strip = false; ///< All of these side by side in one picture.
    bool supersample = false;
    bool permutations = false;
    bool watch = false;
    bool stats = false;
    std::filesystem::path snippets; ///< A folder; empty for those that are built in.
    std::filesystem::path effect;   ///< A file of GLSL; empty for none.
    std::vector<franken::Float4> effectValues;
    std::filesystem::path manifest; ///< Empty for none.

    /// That loading may take: the model, and the sky.
    std::size_t memoryBytes = franken::LoadOptions{}.maxMemoryBytes;

    std::filesystem::path heightMap; ///< Empty for none.
    float heightScale = 0.1f;        ///< From black to white, in the model's unit.

    bool list = false; ///< Says what is in the file, and draws nothing.
    /// The pixel of which to say what it shows; x, y from the top left.
    std::optional<std::array<int, 2>> pick;
    std::string price;     ///< The Raspberry Pi to price the picture for, "pi3"; empty for none.
    bool json = false;     ///< The price as JSON.
    bool measure = false;  ///< Times the picture on this GPU beside the price.
    std::string variant;   ///< Empty for none.
    std::string animation; ///< A name or an index; empty for none: the file at rest.
    double time = 0;       ///< Of the animation, seconds.
    std::string camera;    ///< A name or an index; empty for the first.
    bool frame = false;    ///< All of the model, instead of through one of the file's cameras.
    std::vector<franken::Sun> suns;
    std::optional<franken::Float3> ambient;
    std::filesystem::path skybox; ///< Empty for none.
    bool skySun = false;          ///< Takes the sun out of it, as one of the suns.
    std::optional<float>
        exposure; ///< Nothing: 1, or autoExposure() where that leaves most of the model white.
    bool autoExposure = false;
    franken::Float3 background{0, 0, 0}; ///< Encoded, 0-1.
    franken::Look look;
};

/// Where the picture of that number goes, counted from 0, of those all around or of an animation: the output
/// with the number, from 1 on, in place of its %d or %04d, or else before its extension. The output itself
/// where there is one picture, as a strip is.
std::filesystem::path outputOf(const Options& options, int number);

/// Fails where a picture would overwrite one of these.
franken::Result<void> checkOutputs(const Options& options, std::span<const std::filesystem::path> inputs);

/// What the command line asks for; or the exit code where there is nothing left to do, because of --help or a
/// mistake that has been reported.
std::variant<ExitCode, Options> parseCommandLine(int argc, const char* const* argv);
