// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/permutation.h"

#include <optional>

namespace FRANKEN_API franken {

/// The next rung of the ladder (fallback chain): a simpler program that draws the same object, for a driver
/// that refuses this one. Nothing after the last rung. Takes and returns canonical permutations; the ladder
/// of a permutation is the same on every machine, and has at most twelve rungs.
///
/// Each rung drops one feature; later rungs are more visible:
///
/// 1. the joints of skins: whoever draws with a program without aJoints moves the vertices on the CPU
///    (deform.h), and the picture is the same
/// 2. the effect of the application
/// 3. the form for a GPU: another text, the same picture
/// 4. dithering
/// 5. what is scattered between a rough surface's facets
/// 6. lights beyond two suns and two punctual lights
/// 7. lights beyond the first sun, or the first punctual light where there is no sun
/// 8. the sky's reflection
/// 9. normal and occlusion maps
/// 10. textures of metalness, roughness and emission: factors alone
/// 11. light and tone map: the base colour as it is
/// 12. the base colour's texture, vertex colours, the alpha mask: one colour
///
/// A rung reads no attribute and no texture that the rung above does not read, so that it can be drawn with
/// the same mesh, textures and blocks of uniforms, but for rung 1. A rung keeps the BRDF, because blocks are
/// packed for it, and the output's encoding. A surface always ends at rung 12, which every driver can
/// compile. A sky has rungs 3, 4 and 11 (without the tone map), an overlay has rung 4.
std::optional<Permutation> simpler(const Permutation& permutation);

} // namespace franken
