// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/permutation.h"

#include <optional>

namespace FRANKEN_API franken {

/// The next rung of the ladder (fallback chain): a simpler program that draws the same object, for a driver
/// that refuses this one. Nothing after the last rung. Takes and returns canonical permutations; the ladder
/// of a permutation is the same on every machine, and has at most ten rungs.
///
/// Each rung drops one feature; later rungs are more visible:
///
/// 1. the effect of the application
/// 2. the form for a GPU: another text, the same picture
/// 3. dithering
/// 4. lights beyond two suns and two punctual lights
/// 5. lights beyond the first sun, or the first punctual light where there is no sun
/// 6. the sky's reflection
/// 7. normal and occlusion maps
/// 8. textures of metalness, roughness and emission: factors alone
/// 9. light and tone map: the base colour as it is
/// 10. the base colour's texture, vertex colours, the alpha mask: one colour
///
/// A rung reads no attribute and no texture that the rung above does not read, so that it can be drawn with
/// the same mesh, textures and blocks of uniforms. A rung keeps the BRDF, because blocks are packed for it,
/// and the output's encoding. A surface always ends at rung 10, which every driver can compile. A sky has
/// rungs 2, 3 and 9 (without the tone map), an overlay has rung 3.
std::optional<Permutation> simpler(const Permutation& permutation);

} // namespace franken
