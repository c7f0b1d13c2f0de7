// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/choices.h"
#include "franken/result.h"

namespace franken {

/// "permutation.range" for a value that no choice has; such a permutation has no key.
inline Result<void> checkValues(const Permutation& permutation) {
    for (const Choice& choice : choices())
        if (choice.get(permutation) >= choice.options.size())
            return Error{"permutation.range", toName(permutation),
                         std::string(choice.name) + " has no value " + std::to_string(choice.get(permutation)),
                         "pass what canonicalise() returned"};
    return {};
}

} // namespace franken
