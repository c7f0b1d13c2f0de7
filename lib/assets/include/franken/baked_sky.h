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

/// A sky with all that programs need of it, and the file that holds it. Filtering a sky takes seconds on a
/// desktop and most of a minute on a Pi: `bake` (in examples/) does it once, and a Pi reads the result.
/// Nothing here needs GL, and all of it may be called on any thread.
namespace FRANKEN_API franken {

struct BakedSky {
    SkyCoefficients coefficients{}; ///< Lighting::sky.
    std::optional<Sun> sun;         ///< What was taken out of the sky, to be added to Lighting::suns.
    SkyboxMap skybox;               ///< Renderer::setSkybox(); its size is 0 where none was asked for.
    ReflectionMaps reflection;      ///< Renderer::setReflection().
};

struct BakeOptions {
    bool sun = false;     ///< Takes the sun out of the sky (takeSun).
    int skyboxSize = 512; ///< Of a face, texels; 0 to kMaxSkyWidth / 4. 0 leaves the skybox out.
    int reflectionSize = kReflectionSize; ///< kMinReflectionSize to kMaxReflectionSize.
    Progress progress = {};
    SkyLimits limits = {}; ///< For loadSky().
};

BakedSky bakeSky(Environment sky, const BakeOptions& options);

/// The file, version 3: little-endian, floats as IEEE 754 has them, nothing between the parts. The version
/// rises whenever what the textures mean does.
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

/// Reads it back. Every number is checked before it is used. Fails with "sky.baked": not such a file, another
/// version, cut short or too long, a size out of range, or a number that is not finite or below 0.
Result<BakedSky> decodeBakedSky(std::span<const std::uint8_t> bytes);

/// Whether a file begins as a baked sky does.
bool isBakedSky(const std::filesystem::path& path);

/// Loads a sky that was baked (then `options` mean nothing but the limits), or any that loadEnvironment()
/// takes and bakes it now. Fails as loadEnvironment() and decodeBakedSky() do.
Result<BakedSky> loadSky(const std::filesystem::path& path, const BakeOptions& options = {});

} // namespace franken
