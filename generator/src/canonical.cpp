// SPDX-License-Identifier: MIT
#include "canonical.h"

#include "effect_rules.h"

#include "franken/generator/choices.h"
#include "franken/generator/texture_role.h"
#include "recipe.h"
#include "without.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace franken {
namespace {

// Resets, in the order of the table and until nothing changes, every choice that leaves the recipe's outcome
// alone. `drop` hears of each.
template<typename Drop>
Permutation reduce(Permutation permutation, Drop drop) {
    const Outlines wanted = outlines(permutation);
    bool changed = true;
    const auto leaveOut = [&](const Permutation& less, std::string_view word, std::string_view choice) {
        if (outlines(less) != wanted)
            return;
        drop(word, choice);
        permutation = less;
        changed = true;
    };
    while (std::exchange(changed, false)) {
        for (const Choice& choice : choices())
            if (const unsigned value = choice.get(permutation); value != 0)
                leaveOut(without(permutation, choice), choice.options[value].word, choice.name);
        if (permutation.effect.slot != 0)
            leaveOut(withoutEffect(permutation), "effect", "effect");
    }
    return permutation;
}

std::string reasonFor(const Permutation& p, std::string_view choice) {
    if (choice == "target")
        return "this program is the same on all GPUs";
    if (choice == "joints" && p.influences == 0)
        return "no joint moves a vertex; add 'skin4'";
    if (choice == "precision")
        return "this program is the same in 16 bits";
    if (choice == "lightVectors" && p.precision == Precision::Fp16)
        return "in 16 bits light vectors are exact per pixel alone";
    if (choice == "effect")
        return "it fills no hook of this program";
    if (choice == "lightVectors" && p.effect.slot != 0)
        return "the effect sees the surface per pixel";
    if (p.program == Program::Sky)
        return "the sky has no material and is lit by nothing";
    if (p.program == Program::Overlay)
        return "an overlay is drawn as it is";
    if (p.view != View::Shaded)
        return "the view of the material does not show it; leave the 'view-' word out";
    if (p.shading == Shading::Unlit && choice == "decode" && p.baseColorTexture)
        return "an unlit texel stays in sRGB codes here, because decode and encode would cancel";
    if (p.shading == Shading::Unlit)
        return "an unlit surface shows its base colour alone; leave 'unlit' out to see it";
    if (choice == "lightVectors")
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

constexpr Rule kRules[] = {
    {"occlusion",
     [](const Permutation& p) {
         return p.occlusion == Occlusion::Packed && p.metallicRoughness != MetallicRoughness::Packed;
     },
     "there is no packed metallic-roughness texture to take the occlusion from",
     "add 'metalrough', or use 'occlusion' for a texture of its own"},
    {"uv0Transform", [](const Permutation& p) { return p.uv0Transform && !anyReads(p, UvStream::Uv0); },
     "no texture reads stream 0", "drop the word, or add the texture"},
    {"uv1Transform", [](const Permutation& p) { return p.uv1Transform && !anyReads(p, UvStream::Uv1); },
     "no texture reads stream 1", "drop the word, or let a texture read stream 1"},
    {"reflection",
     [](const Permutation& p) { return p.reflection != Reflection::None && p.ambient != Ambient::Sky; },
     "there is no sky to reflect", "add 'sh', or drop the word"},
    {"energy", [](const Permutation& p) { return p.energy && p.brdf == Brdf::Seed; },
     "the BRDF 'seed' has no form that keeps what is scattered between facets",
     "drop the word, or take another BRDF"},
    {"spots", [](const Permutation& p) { return p.spots && p.punctualLights == 0; },
     "there is no punctual light", "add 'punctual1', or drop the word"},
};

std::optional<Error> findContradiction(const Permutation& p) {
    for (const Choice& choice : choices())
        if (choice.get(p) >= choice.options.size())
            return Error{"permutation.range", std::string(choice.name), "the value is out of range",
                         "the largest is " + std::to_string(choice.options.size() - 1)};
    if (!isEffect(p.effect))
        return noEffect("effect");
    for (const Rule& rule : kRules)
        if (rule.broken(p))
            return contradiction(choiceNamed(rule.choice), p, std::string(rule.what),
                                 std::string(rule.remedy));
    for (const TextureRoleRow& role : textureRoles())
        if (role.stream != nullptr && p.*role.stream != UvStream::Uv0 && !isRead(p, role.stream))
            return Error{"permutation.contradiction", std::string(role.word) + "-uv1",
                         "there is no " + std::string(role.name) + " texture of its own",
                         "add '" + std::string(role.word) + "', or drop the word"};
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

bool isRead(const Permutation& p, UvStream Permutation::*stream) {
    const std::span<const TextureRoleRow> roles = textureRoles();
    return std::any_of(roles.begin(), roles.end(),
                       [&](const TextureRoleRow& role) { return role.stream == stream && role.there(p); });
}

bool anyReads(const Permutation& p, UvStream stream) {
    const std::span<const TextureRoleRow> roles = textureRoles();
    return std::any_of(roles.begin(), roles.end(), [&](const TextureRoleRow& role) {
        return role.stream != nullptr && role.there(p) && p.*role.stream == stream;
    });
}

Result<Canonical> canonicalise(const Permutation& permutation) {
    if (auto error = findContradiction(permutation))
        return *error;
    Canonical canonical{permutation, {}};
    unifyViews(canonical);
    canonical.permutation =
        reduce(canonical.permutation, [&](std::string_view word, std::string_view choice) {
            canonical.dropped.push_back({std::string(word), reasonFor(permutation, choice)});
        });
    return canonical;
}

Permutation fragmentChoices(const Permutation& permutation) {
    Permutation choices = permutation;
    choices.uv0Transform = choices.uv1Transform = false;
    choices.influences = 0;
    choices.joints = {};
    if (choices.effect.slot != 0 && outline(permutation, Stage::Fragment).effect == 0)
        choices.effect = {};
    return choices;
}

Key stageKey(const Permutation& permutation, Stage stage) {
    if (stage == Stage::Fragment)
        return toKey(fragmentChoices(permutation));
    const Outline vertex = outline(permutation, Stage::Vertex);
    return {{vertex.rows.to_ullong(), std::uint64_t{vertex.suns} | std::uint64_t{vertex.punctualLights} << 8 |
                                          std::uint64_t{vertex.effect} << 16 |
                                          std::uint64_t{vertex.influences} << 24}};
}

} // namespace franken
