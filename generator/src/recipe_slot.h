// SPDX-License-Identifier: MIT
#pragma once

#include "recipe.h"
#include "recipe_conditions.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>

// What the recipe's table (recipe.cpp) is made of.
namespace franken {

/// One way to fill a slot.
struct Form {
    std::string_view snippet;
    conditions::Condition when = conditions::always;
    UvStream Permutation::*uv = nullptr; ///< The stream that it reads.
};

inline constexpr std::size_t kMaxForms = 12;

/// A place in the text. Where `when` holds, the first form that applies stands there.
struct Slot {
    constexpr Slot(Stage stage_, conditions::Condition when_, std::initializer_list<Form> forms_,
                   Each each_ = Each::Once)
        : stage(stage_), when(when_), count(forms_.size()), each(each_) {
        std::copy(forms_.begin(), forms_.end(), forms.begin());
    }

    Stage stage;
    conditions::Condition when;
    std::array<Form, kMaxForms> forms;
    std::size_t count;
    Each each;
};

} // namespace franken
