// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "franken/api.h"
#include "franken/environment.h"

/// The reflection of a sky, prefiltered on the CPU once and read by a fragment shader in four texture
/// fetches. generator/docs/sky.md compares this way with others, in error and in instructions.
///
/// The BRDF is that of glTF 2.0, appendix B. Its integral over the sky is split in two (Karis, "Real Shading
/// in Unreal Engine 4", 2013): the sky prefiltered with the lobe of N = V, and how much of a white sky the
/// surface reflects. That is exact where N.V is 1. Elsewhere the true lobe is narrow across
/// the plane of N and V and long within it, and a rough one is cut off at the horizon, so that its middle
/// lies between the mirrored eye and N. Three corrections, fitted together, make up for most of it: the sky
/// is looked up in a direction bent towards N (as in Lagarde and de Rousiers, "Moving Frostbite to Physically
/// Based Rendering", 2014), at a sharper level, and a share of the sky's irradiance at N, which a shader has
/// at hand, stands for the long part. That irradiance is in the same texture: a fourth fetch costs a small
/// GPU less than nine coefficients.
namespace FRANKEN_API franken {

/// Called now and then with the finished share, 0 to 1, on the thread of the caller.
using Progress = std::function<void(float)>;

/// The edge of the sharpest level's squares: 256 gives 0.56 degrees a texel.
inline constexpr int kReflectionSize = 256;
inline constexpr int kMinReflectionSize = 256;
inline constexpr int kMaxReflectionSize = 1024; ///< The largest edge that filterReflection() takes.

/// The sky prefiltered for rising roughness, in kReflectionLevels (pack.h) levels. Each texel is a sum over
/// all of the sky's texels, without sampling noise. One picture for a 2D texture with linear filter, clamped
/// to its edge and without mipmaps. Its texels are encoded as those of SkyboxMap.
///
/// A direction d belongs to the square of the upper half (d.y >= 0) or to that of the lower half beside it,
/// at the point (d.x, d.z) / (max(|d.x|, |d.z|) + |d.y|), each from -1 to 1, times kAtlasInner. The
/// squares of a level lie below those of the level before and are smaller by the factor sqrt(0.5).
///
/// The irradiance over pi fills two rectangles, each an eighth of the picture wide and high, whose middles
/// are at 13/16 (upper half) and 15/16 of the width and 3/4 of the height: a unit direction is at (d.x, d.z)
/// (1 - |d.y| / 2) from there, from -1 to 1, times kAtlasInner.
struct ReflectionAtlas {
    Image image;     ///< 2 size wide and reflectionHeight(size) high.
    float range = 0; ///< The largest radiance that a texel can hold.
};

/// The height of an atlas whose sharpest squares have that size: about 3.26 times the size.
int reflectionHeight(int size);

/// Leaves a rim around each square, one texel in the smallest, that is filled from beyond the horizon for
/// the linear filter.
inline constexpr float kAtlasInner = 7.0f / 8.0f;

/// Filters the sky. size: kMinReflectionSize to kMaxReflectionSize; a Pi 3 holds up to 512. A size of 256
/// takes about three seconds on two cores of a desktop; it runs on all, and the result is the same on any
/// number.
ReflectionAtlas filterReflection(const Environment& sky, int size = kReflectionSize,
                                 const Progress& progress = {});

/// The size of reflectionLookup(), texels.
inline constexpr int kLookupWidth = 128;
inline constexpr int kLookupHeight = 256;

/// How a surface reflects that sky, as a picture of kLookupWidth x kLookupHeight for a 2D texture with linear
/// filter, clamped to its edge. u is N.V, v the perceptual roughness. With F0 the reflectance at normal
/// incidence: R and G: the light of a white sky that is reflected is F0 R + G, within 0.004 from N.V 0.02 and
/// roughness 0.1 up, and within 0.011 below; B: the level to look at, over 8; A: the share of the irradiance
/// in that light. The direction to look into is bent towards N by reflectionBend() (pack.h).
Image reflectionLookup();

/// Both textures, for Renderer::setReflection().
struct ReflectionMaps {
    ReflectionAtlas atlas; ///< The sky, by roughness: filterReflection().
    Image lookup;          ///< How a surface reflects it: reflectionLookup().
};

} // namespace franken
