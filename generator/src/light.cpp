// SPDX-License-Identifier: MIT
#include "franken/generator/light.h"

#include "numbers.h"

#include <cmath>
#include <initializer_list>

namespace franken {
namespace {

struct Rule {
    bool holds;
    LightFault fault;
};

std::optional<LightFault> firstBroken(std::initializer_list<Rule> rules) {
    for (const Rule& rule : rules)
        if (!rule.holds)
            return rule.fault;
    return std::nullopt;
}

constexpr std::string_view kDirectionRule = "it must be finite, and not 0";

bool isDirection(const Float3& vector) {
    return areFinite(vector) && std::hypot(vector[0], vector[1], vector[2]) > 0;
}

} // namespace

std::optional<LightFault> faultOf(const Sun& sun) {
    return firstBroken({{isDirection(sun.direction), {"direction", kDirectionRule}},
                        {isAmount(sun.color), {"color", kAmountRule}},
                        {isAmount(sun.illuminance), {"illuminance", kAmountRule}}});
}

std::optional<LightFault> faultOf(const PunctualLight& light) {
    return firstBroken({{areFinite(light.position), {"position", "it must be finite"}},
                        {isDirection(light.direction) || !light.spot, {"direction", kDirectionRule}},
                        {isAmount(light.color), {"color", kAmountRule}},
                        {isAmount(light.intensity), {"intensity", kAmountRule}},
                        {isAmount(light.range), {"range", kAmountRule}},
                        {isAmount(light.innerCone) || !light.spot, {"innerCone", kAmountRule}},
                        {isAmount(light.outerCone) || !light.spot, {"outerCone", kAmountRule}}});
}

} // namespace franken
