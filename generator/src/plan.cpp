// SPDX-License-Identifier: MIT
#include "recipe.h"

#include <algorithm>

namespace franken {

std::vector<Step> plan(const Permutation& p, Stage stage) {
    const std::span<const Row> all = recipe();
    const RowRange rows = rowsOf(stage);
    const Outline applying = outline(p, stage);
    std::vector<Step> steps;
    steps.reserve(64);
    for (std::size_t begin = rows.begin, end = begin + 1; begin < rows.end; begin = end++) {
        if (!applying.rows[begin])
            continue;
        const Each each = all[begin].each;
        if (each == Each::Effect) {
            steps.push_back({static_cast<std::uint8_t>(begin), applying.effect, UvStream::Uv0});
            continue;
        }
        while (each != Each::Once && end < rows.end && all[end].each == each)
            ++end;
        for (std::uint8_t light = 0; light < repeats(p, each); ++light)
            for (std::size_t row = begin; row < end; ++row)
                if (applying.rows[row])
                    steps.push_back({static_cast<std::uint8_t>(row), light,
                                     applying.readsUv1[row] ? UvStream::Uv1 : UvStream::Uv0});
    }
    return steps;
}

std::vector<Step> plan(const Permutation& p) {
    std::vector<Step> steps = plan(p, Stage::Vertex);
    const std::vector<Step> fragment = plan(p, Stage::Fragment);
    steps.insert(steps.end(), fragment.begin(), fragment.end());
    return steps;
}

int lightsIn(const std::vector<Step>& steps) {
    int suns = 0, punctualLights = 0;
    for (const Step& step : steps) {
        const Each each = recipe()[step.row].each;
        suns = each == Each::Sun ? std::max(suns, step.light + 1) : suns;
        punctualLights = each == Each::Punctual ? std::max(punctualLights, step.light + 1) : punctualLights;
    }
    return suns + punctualLights;
}

} // namespace franken
