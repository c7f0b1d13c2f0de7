// SPDX-License-Identifier: MIT
#pragma once

#include "recipe.h"
#include "recipe_slot.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

/// From a table of slots, a constant array, to the rows that a permutation takes of it. For recipe.cpp alone.
namespace franken {

using conditions::P;

/// Where each slot's forms begin among all rows; the last is their number.
template<const auto& kSlots>
constexpr auto kFirstRow = [] {
    std::array<std::size_t, kSlots.size() + 1> first{};
    for (std::size_t slot = 0; slot < kSlots.size(); ++slot)
        first[slot + 1] = first[slot] + kSlots[slot].count;
    return first;
}();

/// Those of all slots.
template<const auto& kSlots>
constexpr auto kRows = [] {
    std::array<Row, kFirstRow<kSlots>[kSlots.size()]> rows {};
    for (std::size_t slot = 0; slot < kSlots.size(); ++slot)
        for (std::size_t form = 0; form < kSlots[slot].count; ++form)
            rows[kFirstRow<kSlots>[slot] + form] = {kSlots[slot].stage, kSlots[slot].forms[form].snippet,
                                                    kSlots[slot].each, kSlots[slot].forms[form].uv};
    return rows;
}();

/// The slots of the vertex shader stand first.
template<const auto& kSlots>
constexpr auto kVertexSlots = static_cast<std::size_t>(std::count_if(kSlots.begin(), kSlots.end(),
                                                                     [](const Slot& slot) {
                                                                         return slot.stage == Stage::Vertex;
                                                                     }));

/// A form that reads a stream says so to the slots before it, which declare it.
template<const auto& kSlots, std::size_t Index, std::size_t FormIndex>
void addForm(P p, Needs& n, Outline& outline) {
    constexpr Form form = kSlots[Index].forms[FormIndex];
    constexpr std::size_t row = kFirstRow<kSlots>[Index] + FormIndex;
    if (form.when(p, n)) {
        outline.rows[row] = true;
        if constexpr (form.uv != nullptr) {
            const bool second = p.*form.uv == UvStream::Uv1;
            outline.readsUv1[row] = second;
            (second ? n.uv1 : n.uv0) = true;
        }
    } else if constexpr (FormIndex + 1 < kSlots[Index].count) {
        addForm<kSlots, Index, FormIndex + 1>(p, n, outline);
    }
}

template<const auto& kSlots, std::size_t Index>
void addSlot(P p, Needs& n, Outline& outline) {
    constexpr Slot slot = kSlots[Index];
    if (!slot.when(p, n) || repeats(p, slot.each) == 0)
        return;
    if constexpr (slot.each == Each::Sun)
        outline.suns = p.suns;
    if constexpr (slot.each == Each::Punctual)
        outline.punctualLights = p.punctualLights;
    if constexpr (slot.each == Each::Influence)
        outline.influences = p.influences;
    if constexpr (slot.each == Each::Effect)
        outline.effect = p.effect.slot;
    addForm<kSlots, Index, 0>(p, n, outline);
}

/// From the last to the first: what declares a stream stands before what reads it. Spelt out slot by slot: no
/// loop and no calls are left, and canonicalising is mostly this.
template<const auto& kSlots, std::size_t End, std::size_t... Index>
void addSlots(P p, Needs& n, Outline& outline, std::index_sequence<Index...>) {
    (addSlot<kSlots, End - 1 - Index>(p, n, outline), ...);
}

} // namespace franken
