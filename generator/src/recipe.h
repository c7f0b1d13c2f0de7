// SPDX-License-Identifier: MIT
#pragma once

#include "needs.h"

#include <bitset>
#include <span>
#include <string_view>

namespace franken {

/// How often a row's snippet stands in the text. Neighbouring rows of the same kind repeat together.
/// Effect: once, as the effect of the permutation fills it.
enum class Each : std::uint8_t { Once, Sun, Punctual, Influence, Effect };

/// One row of the recipe: which snippet, in which stage. The rows' order is that of the text; their
/// conditions stand in recipe_conditions.h. Rows of which at most one is in a text make one slot
/// (recipe.cpp).
struct Row {
    Stage stage;
    std::string_view snippet; ///< File below glsl/<stage>/, without ".glsl".
    Each each = Each::Once;
    UvStream Permutation::*uv = nullptr; ///< The stream that ${uv} stands for.
};

inline constexpr std::size_t kMaxRows = 256;

std::span<const Row> recipe();

struct RowRange {
    std::size_t begin, end;
};
RowRange rowsOf(Stage stage);

/// How often a row of that kind stands in a permutation's text.
inline std::uint8_t repeats(const Permutation& p, Each each) {
    switch (each) {
    case Each::Sun:
        return p.suns;
    case Each::Punctual:
        return p.punctualLights;
    case Each::Influence:
        return p.influences;
    case Each::Once:
    case Each::Effect:
        break;
    }
    return 1;
}

/// A row that applies, with what its placeholders stand for.
struct Step {
    std::uint8_t row;
    std::uint8_t light; ///< Index of the sun, punctual light or influence; the slot of the effect.
    UvStream uv;
    friend bool operator==(const Step&, const Step&) = default;
};

/// What tells the plan of one stage from another's, quick to make and to compare.
struct Outline {
    std::bitset<kMaxRows> rows;        ///< Those that apply.
    std::bitset<kMaxRows> readsUv1;    ///< Those whose ${uv} stands for stream 1.
    std::uint8_t suns, punctualLights; ///< How often their rows repeat; 0 where there are none.
    std::uint8_t influences;           ///< The same.
    std::uint8_t effect;               ///< The slot of the effect that fills a row; 0 where none does.
    friend bool operator==(const Outline&, const Outline&) = default;
};

struct Outlines {
    Outline vertex, fragment;
    friend bool operator==(const Outlines&, const Outlines&) = default;
};

Outlines outlines(const Permutation& permutation);

/// One stage's.
Outline outline(const Permutation& permutation, Stage stage);

/// A permutation's whole text in terms of the recipe, both stages. Equal plans are equal texts.
std::vector<Step> plan(const Permutation& permutation);

/// One stage's part of it.
std::vector<Step> plan(const Permutation& permutation, Stage stage);

/// Whether no earlier step has the same row.
inline bool isFirst(const Step& step) { return step.light == 0 || recipe()[step.row].each == Each::Effect; }

/// Suns and punctual lights that a plan has a part for.
int lightsIn(const std::vector<Step>& steps);

} // namespace franken
