// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "franken/api.h"
#include "franken/environment.h"
#include "franken/reflection.h"

/// A sky, filtered for programs, and its file format. Filtering a sky takes seconds on a desktop and most of
/// a minute on a Pi: `bake` (in examples/) does it once, and a Pi reads the result. Nothing here needs GL,
/// and all functions may be called on any thread.
namespace FRANKEN_API franken {

/// What a sky was filtered to.
struct BakedSky {
    SkyCoefficients coefficients{}; ///< Lighting::sky.
    std::optional<Sun> sun;         ///< Was taken out of the sky; add it to Lighting::suns.
    SkyboxMap skybox;               ///< For Renderer::setSkybox(); its size is 0 if none was requested.
    ReflectionMaps reflection;      ///< For Renderer::setReflection().
};

/// What bakeSky() and loadSky() make of a sky.
struct BakeOptions {
    bool sun = false;     ///< Takes the sun out of the sky (takeSun).
    int skyboxSize = 512; ///< Of a face, texels; 0 to kMaxSkyWidth / 4. 0 leaves the skybox out.
    int reflectionSize = kReflectionSize; ///< kMinReflectionSize to kMaxReflectionSize.
    Progress progress = {};
    SkyLimits limits = {}; ///< For loadSky().
};

/// Filters a sky: seconds on a desktop, most of a minute on a Pi. Runs on all cores; cannot fail.
BakedSky bakeSky(Environment sky, const BakeOptions& options);

/// The file format, version 3: little-endian, IEEE 754 floats, no padding. The version rises whenever the
/// meaning of the textures changes.
///
/// | bytes | what |
/// |---|---|
/// | 8 | "FRANKSKY" |
/// | 4 | 3, the version |
/// | 108 | the coefficients: 27 floats, RGB by RGB |
/// | 4 | 1 where a sun follows, or 0 |
/// | 28 | the sun: direction, colour, illuminance; zeros where there is none |
/// | 4, 4 | the skybox: size of a face, range (float) |
/// | 4, 4 | the reflection: size of the sharpest one's squares, range (float) |
/// | 24 size^2 | the skybox's faces, RGBA8 |
/// | 8 size reflectionHeight(size) | the atlas of the reflection, RGBA8 |
/// | 131,072 | the reflection's lookup, RGBA8 |
///
/// About 8 MB with the sizes of BakeOptions. Ranges and layouts are those of SkyboxMap and ReflectionAtlas.
std::vector<std::uint8_t> encodeBakedSky(const BakedSky& sky);

/// Decodes a baked sky. Every number is checked before use. Fails with "sky.baked": not such a file, another
/// version, cut short or too long, a size out of range, or a number that is not finite or below 0.
Result<BakedSky> decodeBakedSky(std::span<const std::uint8_t> bytes);

/// Whether a file begins with the magic bytes of a baked sky.
bool isBakedSky(const std::filesystem::path& path);

/// Loads a baked sky (then only the limits of `options` count), or bakes any sky that loadEnvironment() can
/// load. Fails as loadEnvironment() and decodeBakedSky() do.
Result<BakedSky> loadSky(const std::filesystem::path& path, const BakeOptions& options = {});

} // namespace franken
