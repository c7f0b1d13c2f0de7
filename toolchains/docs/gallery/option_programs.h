// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/choices.h"
#include "franken/result.h"

#include <span>
#include <vector>

namespace franken::gallery {

/// A choice, in programs that differ in nothing but its options, as far as they can.
struct ChoiceProgram {
    const Choice* choice;              ///< Of choices().
    std::vector<Permutation> programs; ///< One for each of its options, in their order; canonical.
};

/// All choices, each set to its options in the first of a few programs in which every one of them changes the
/// text. Fails with "gallery.base", and names the choice, where there is no such program among them: then
/// option_programs.cpp needs one more.
Result<std::vector<ChoiceProgram>> choicePrograms();

} // namespace franken::gallery
