// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "franken/api.h"
#include "franken/generator/pack.h"
#include "franken/image.h"
#include "franken/result.h"

/// The light of distant surroundings. It is loaded and kept on the CPU in linear floats, and converted to
/// what shaders read: nine coefficients for rough and matt surfaces, and textures of 8 bits a channel, the
/// only format that GLES2 has on a Raspberry Pi. Nothing here needs GL.
namespace FRANKEN_API franken {

/// A sky, as a picture. World space has +Y up and is right-handed; -Z is ahead and +X to the right.
struct Environment {
    /// Which texel is seen in which direction.
    enum class Layout {
        /// One picture of everything. A direction (x, y, z) of unit length lies at u = 0.5 + atan2(x, -z) /
        /// (2 pi) and v = acos(y) / pi, v = 0 in the top row: straight up is above, -Z in the middle, +X at
        /// u = 0.75.
        Equirect,
        /// Six square faces, one below the other: +X, -X, +Y, -Y, +Z, -Z, each as glTexImage2D takes it for
        /// its side of a cube map (OpenGL ES 2.0, table 3.21).
        Cube,
    };

    Layout layout = Layout::Equirect;
    int width = 0;                 ///< Texels; of one face for Layout::Cube. At least 1 after loading.
    int height = 0;                ///< Texels; six times the width for Layout::Cube.
    std::vector<glm::vec3> texels; ///< width * height radiances, rows from top to bottom; finite and >= 0.
};

/// The largest width of a picture of the sky: twice that of a Pi's largest texture. The texels of such a sky
/// fill 400 MB.
inline constexpr int kMaxSkyWidth = 8192;

/// Limits for loading a sky's files.
struct SkyLimits {
    std::size_t maxFileBytes = std::size_t{128} << 20; ///< Of each file.

    /// Of all memory that loading holds at a time. The default suffices for 4096 x 2048 texels or faces of
    /// 1536, and keeps any process that loads a file below 256 MiB; a sky of kMaxSkyWidth needs twice as
    /// much.
    std::size_t maxMemoryBytes = std::size_t{240} << 20;
};

/// Loads a sky from one of
/// - a picture twice as wide as high: Layout::Equirect;
/// - a picture of 4 x 3 squares: a cross with +Y above and -Y below the second square of -X, +Z, +X, -Z;
/// - a picture of 3 x 4 squares: a cross with -X and +X beside the second square of +Y, +Z, -Y, -Z, the last
///   one upside down;
/// - a folder with six pictures, whose names without extension are, or end in, px nx py ny pz nz after a
///   character that is no letter;
/// - an HDRE environment (.hdre) of 32-bit floats: its level 0, Layout::Cube.
/// Pictures are Radiance .hdr (its EXPOSURE and GAMMA lines are not applied, as in most programs), OpenEXR
/// (one part of lines or tiles; R, G and B, or Y; not packed, or by RLE, ZIP or PIZ; in builds with tinyexr),
/// or PNG and JPEG, which are taken as sRGB. The squares of crosses and the faces of folders are oriented as
/// cube map faces; seen by a person, each is then a mirror image, and neighbours in a cross fit together.
///
/// Files may be broken, or an enemy's. Fails with "sky.file" (cannot be read, or too large), "sky.shape"
/// (another aspect ratio, faces missing or of different sizes), "sky.limit" (more memory than `limits`
/// allow), "hdr.format", "hdr.size", "hdre.format", "hdre.size", "exr.format", "exr.size", "exr.absent" (a
/// build without tinyexr) or an error of decodeImage().
Result<Environment> loadEnvironment(const std::filesystem::path& path, const SkyLimits& limits = {});

/// Loads a sky from six pictures in the order +X, -X, +Y, -Y, +Z, -Z. Fails as the function above does.
Result<Environment> loadEnvironment(const std::array<std::filesystem::path, 6>& faces,
                                    const SkyLimits& limits = {});

/// Radiance from a direction (any length but 0), interpolated between the four nearest texels.
glm::vec3 radianceFrom(const Environment& sky, const glm::vec3& direction);

/// Projects the radiance of all texels, each weighted by its solid angle, on the first nine real spherical
/// harmonics. packAmbient() makes an irradiance of them (Ramamoorthi and Hanrahan, "An Efficient
/// Representation for Irradiance Environment Maps", 2001).
SkyCoefficients skyCoefficients(const Environment& sky);

/// Cuts the sun out of a sky and returns it as a light, so that textures of the sky need not hold its range
/// and its reflection is sharp. The sun is the radiance above kSunContrast times the mean, within 5 degrees
/// of the brightest texel; those texels keep that limit. The light of both together is unchanged. Returns
/// nothing if no texel is that bright.
std::optional<Sun> takeSun(Environment& sky);

inline constexpr float kSunContrast = 32; ///< See takeSun().

/// The faces of a cube map, ready for glTexImage2D. Texels hold sqrt(radiance / range) as RGB times a shared
/// alpha: radiance = (rgb * a)^2 * range. The root puts more codes where eyes see more.
struct SkyboxMap {
    int size = 0;                ///< Of an edge, texels.
    float range = 0;             ///< The largest radiance that a texel can hold.
    std::array<Image, 6> images; ///< +X, -X, +Y, -Y, +Z, -Z.
};

/// The smallest range of a SkyboxMap, so that skies of one scene differ little in precision.
inline constexpr float kMinSkyRange = 64;

/// The largest range, as a multiple of the sky's mean over all directions: up to there, 8 bits hold the rest
/// of the sky without visible steps. A surface that reflects a fortieth of that radiance, and a sky behind
/// the scene, are white in any case.
inline constexpr float kMaxSkyContrast = 1024;

/// Resamples the sky to a cube of that size (1 to kMaxSkyWidth / 4), each texel the mean over its area, and
/// encodes it. The range is the brightest texel's, within the two bounds above; brighter texels are cut to
/// it.
SkyboxMap encodeSkybox(const Environment& sky, int size);

} // namespace franken
