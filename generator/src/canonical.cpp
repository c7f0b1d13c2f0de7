// SPDX-License-Identifier: MIT
#include "canonical.h"

#include "franken/generator/choices.h"
#include "recipe.h"

#include <optional>
#include <utility>

namespace franken {
namespace {

using Outlines = std::pair<Outline, Outline>;

Outlines outlines(const Permutation& p) { return {outline(p, Stage::Vertex), outline(p, Stage::Fragment)}; }

// Resets, in the order of the table and until nothing changes, every choice that leaves the recipe's outcome
// alone. `drop` hears of each.
template<typename Drop>
Permutation reduce(Permutation permutation, Drop drop) {
    const Outlines wanted = outlines(permutation);
    for (bool changed = true; changed;) {
        changed = false;
        for (const Choice& choice : choices()) {
            const unsigned value = choice.get(permutation);
            if (value == 0)
                continue;
            Permutation without = permutation;
            choice.set(without, 0);
            if (outlines(without) != wanted)
                continue;
            drop(choice, value);
            permutation = without;
            changed = true;
        }
    }
    return permutation;
}

std::string reasonFor(const Permutation& p, const Choice& choice) {
    if (choice.name == "target")
        return "this program is the same on all GPUs";
    if (p.program == Program::Sky)
        return "the sky has no material and is lit by nothing";
    if (p.program == Program::Overlay)
        return "an overlay is drawn as it is";
    if (p.view != View::Shaded)
        return "the view of the material does not show it; leave the 'view-' word out";
    if (p.shading == Shading::Unlit)
        return "an unlit surface shows its base colour alone; leave 'unlit' out to see it";
    if (choice.name == "lightVectors")
        return p.punctualLights > 0 ? "punctual lights are lit per pixel, and suns beside them too"
                                    : "there is no sun";
    if (p.suns + p.punctualLights == 0)
        return p.ambient == Ambient::None
                   ? "there is nothing to light it, so that it is drawn black; add 'sun1', 'ambient' or "
                     "'sh', or "
                     "'unlit'"
                   : "there is no sun and no punctual light that would show it; add 'sun1'";
    return "no line of this program depends on it";
}

Error contradiction(const Choice& choice, const Permutation& p, std::string what, std::string remedy) {
    return {"permutation.contradiction", std::string(choice.options[choice.get(p)].word), std::move(what),
            std::move(remedy)};
}

const Choice& choiceNamed(std::string_view name) {
    for (const Choice& choice : choices())
        if (choice.name == name)
            return choice;
    return choices().front();
}

struct Rule {
    std::string_view choice;
    bool (*broken)(const Permutation&);
    std::string_view what, remedy;
};

constexpr UvStream kUv1 = UvStream::Uv1;
constexpr Rule kRules[] = {
    {"occlusion",
     [](const Permutation& p) {
         return p.occlusion == Occlusion::Packed && p.metallicRoughness != MetallicRoughness::Packed;
     },
     "there is no packed metallic-roughness texture to take the occlusion from",
     "add 'metalrough', or use 'occlusion' for a texture of its own"},
    {"uv0Transform", [](const Permutation& p) { return p.uv0Transform && !anyReads(p, UvStream::Uv0); },
     "no texture reads stream 0", "drop the word, or add the texture"},
    {"uv1Transform", [](const Permutation& p) { return p.uv1Transform && !anyReads(p, kUv1); },
     "no texture reads stream 1", "drop the word, or let a texture read stream 1"},
    {"baseColorUv", [](const Permutation& p) { return p.baseColorUv == kUv1 && !p.baseColorTexture; },
     "there is no base colour texture", "add 'basecolor', or drop the word"},
    {"metallicRoughnessUv",
     [](const Permutation& p) {
         return p.metallicRoughnessUv == kUv1 && p.metallicRoughness == MetallicRoughness::Factors;
     },
     "there is no metallic-roughness texture", "add 'metalrough', or drop the word"},
    {"normalUv", [](const Permutation& p) { return p.normalUv == kUv1 && p.normal != Normal::Map; },
     "there is no normal map", "add 'normal', or drop the word"},
    {"occlusionUv",
     [](const Permutation& p) { return p.occlusionUv == kUv1 && p.occlusion != Occlusion::Texture; },
     "there is no occlusion texture of its own", "add 'occlusion', or drop the word"},
    {"emissiveUv",
     [](const Permutation& p) { return p.emissiveUv == kUv1 && p.emissive != Emissive::Texture; },
     "there is no emissive texture", "add 'emissive', or drop the word"},
    {"reflection",
     [](const Permutation& p) { return p.reflection != Reflection::None && p.ambient != Ambient::Sky; },
     "there is no sky to reflect", "add 'sh', or drop the word"},
    {"spots", [](const Permutation& p) { return p.spots && p.punctualLights == 0; },
     "there is no punctual light", "add 'punctual1', or drop the word"},
};

std::optional<Error> findContradiction(const Permutation& p) {
    for (const Choice& choice : choices())
        if (choice.get(p) >= choice.options.size())
            return Error{"permutation.range", std::string(choice.name), "the value is out of range",
                         "the largest is " + std::to_string(choice.options.size() - 1)};
    for (const Rule& rule : kRules)
        if (rule.broken(p))
            return contradiction(choiceNamed(rule.choice), p, std::string(rule.what),
                                 std::string(rule.remedy));
    return std::nullopt;
}

// Two ways to ask for the same program become one: equal texts have equal keys.
void unifyViews(Canonical& canonical) {
    Permutation& p = canonical.permutation;
    if (p.program != Program::Surface || p.view != View::BaseColor)
        return;
    p.view = View::Shaded;
    p.shading = Shading::Unlit;
    canonical.dropped.push_back(
        {"view-basecolor", "'unlit' stands for it: an unlit surface shows its base colour"});
}

} // namespace

bool anyReads(const Permutation& p, UvStream stream) {
    return (p.baseColorTexture && p.baseColorUv == stream) ||
           (p.metallicRoughness != MetallicRoughness::Factors && p.metallicRoughnessUv == stream) ||
           (p.normal == Normal::Map && p.normalUv == stream) ||
           (p.occlusion == Occlusion::Texture && p.occlusionUv == stream) ||
           (p.emissive == Emissive::Texture && p.emissiveUv == stream);
}

Result<Canonical> canonicalise(const Permutation& permutation) {
    if (auto error = findContradiction(permutation))
        return *error;
    Canonical canonical{permutation, {}};
    unifyViews(canonical);
    canonical.permutation = reduce(canonical.permutation, [&](const Choice& choice, unsigned value) {
        canonical.dropped.push_back(
            {std::string(choice.options[value].word), reasonFor(permutation, choice)});
    });
    return canonical;
}

Permutation fragmentChoices(const Permutation& permutation) {
    Permutation choices = permutation;
    choices.uv0Transform = choices.uv1Transform = false;
    return choices;
}

Key stageKey(const Permutation& permutation, Stage stage) {
    if (stage == Stage::Fragment)
        return toKey(fragmentChoices(permutation));
    const Outline vertex = outline(permutation, Stage::Vertex);
    return {{vertex.rows.to_ullong(), vertex.suns}};
}

} // namespace franken
