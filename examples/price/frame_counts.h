// SPDX-License-Identifier: MIT
#pragma once

#include "franken/material.h"
#include "franken/result.h"
#include "franken/viewpoint.h"
#include "raster.h"

#include <string>
#include <vector>

namespace price {

/// What a frame shows, as Renderer::draw() does.
struct FrameContents {
    const franken::Scene& scene; ///< In its pose; as check() demands.
    franken::Viewpoint viewpoint;
    franken::Lighting lighting;
    franken::Look look;
    int skyboxSize = 0; ///< Of a face, texels; 0 without a skybox.
    int width = 0, height = 0;
};

/// Memory that textures take of it, bytes.
struct TexelBytes {
    double whole = 0;
    double halved = 0; ///< If the material's textures were of half the width and height.
};

/// One draw, in the order of the frame.
struct Draw {
    franken::MaterialPlan plan; ///< Of a surface.
    bool isSkybox = false;
    bool isMasked = false;    ///< Pixels may be discarded.
    Shaded shaded;            ///< With an early test against what has left its depth.
    Shaded covered;           ///< Without one.
    std::size_t vertices = 0; ///< That the coordinate shader runs for: each of the mesh once.
    std::size_t tileVertices =
        0;               ///< That the vertex shader runs for: in each tile, those of its triangles once.
    int vertexBytes = 0; ///< Of all its attributes.
    TexelBytes texels;   ///< For the shaded pixels.
    double lookups = 0;  ///< Of the texture units, for each pixel.
};

/// Where a GPU stops testing depth early.
enum class EarlyDepth {
    Always,       ///< VideoCore IV.
    UntilDiscard, ///< VideoCore VI and VII: from the first masked surface to the end of the frame.
};

struct FrameCounts {
    int width = 0, height = 0;
    std::vector<Draw> draws;
};

/// The order is that of the renderer (lib/renderer/src/draw_list.h): opaque objects by program, each from
/// front to back in 16 slices, masked ones last; the skybox; blended ones from back to front, both sides of a
/// double-sided one after each other. Fails as permutationOf() does.
franken::Result<FrameCounts> countFrame(const FrameContents& frame);

/// What is shaded of each draw on such a GPU, in their order.
std::vector<Shaded> shadedOf(const FrameCounts& counts, EarlyDepth early);

/// The program of a draw in that light and look. Fails as permutationOf() does.
franken::Result<franken::Permutation> programOf(const Draw& draw, const franken::Lighting& lighting,
                                                const franken::Look& look);

} // namespace price
