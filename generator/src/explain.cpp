// SPDX-License-Identifier: MIT
#include "franken/generator/explain.h"

#include "effect_text.h"
#include "franken/generator/choices.h"
#include "library.h"
#include "recipe.h"
#include "without.h"

#include <algorithm>

namespace franken {
namespace {

bool contains(const std::vector<Step>& steps, const Step& wanted) {
    return std::find(steps.begin(), steps.end(), wanted) != steps.end();
}

std::vector<std::string> wordsOf(const Permutation& permutation) {
    std::vector<std::string> words;
    for (const Choice& choice : choices())
        if (const unsigned value = choice.get(permutation); value != 0)
            words.emplace_back(choice.options[value].word);
    return words;
}

struct Missed {
    std::string word;
    std::vector<Step> plan; ///< The program without that word.
};

std::vector<Missed> planWithoutEach(const Permutation& permutation, const SnippetSet& snippets) {
    std::vector<Missed> result;
    for (const Choice& choice : choices())
        if (const unsigned value = choice.get(permutation); value != 0)
            result.push_back({std::string(choice.options[value].word), plan(without(permutation, choice))});
    if (const Effect* const effect = snippets.effectOf(permutation.effect); effect != nullptr)
        result.push_back({effect->name(), plan(withoutEffect(permutation))});
    return result;
}

Permutation smallestWith(const Step& step, Permutation permutation) {
    if (const Permutation less = withoutEffect(permutation); contains(plan(less), step))
        permutation = less;
    const std::span<const Choice> all = choices();
    for (auto choice = all.rbegin(); choice != all.rend(); ++choice)
        if (const Permutation less = without(permutation, *choice); contains(plan(less), step))
            permutation = less;
    return permutation;
}

Reason reasonFor(const Step& step, const Permutation& permutation, const std::vector<Missed>& missed) {
    Reason reason{snippetName(recipe()[step.row]), Reason::Kind::All, {}};
    for (const Missed& each : missed)
        if (!contains(each.plan, step))
            reason.words.push_back(each.word);
    if (reason.words.empty()) {
        reason.words = wordsOf(smallestWith(step, permutation));
        reason.kind = reason.words.empty() ? Reason::Kind::Always : Reason::Kind::Enough;
    }
    return reason;
}

} // namespace

std::vector<Reason> explain(const Permutation& permutation, const SnippetSet& snippets) {
    const std::vector<Missed> missed = planWithoutEach(permutation, snippets);
    std::vector<Reason> reasons;
    for (const Step& step : plan(permutation))
        if (isFirst(step))
            reasons.push_back(reasonFor(step, permutation, missed));
    if (const Effect* const effect = snippets.effectOf(permutation.effect); effect != nullptr)
        reasons.push_back({std::string(effect->text().file), Reason::Kind::All, {effect->name()}});
    return reasons;
}

std::string toText(const Reason& reason) {
    std::string text;
    for (const std::string& word : reason.words)
        text.append(text.empty() ? "" : "+").append(word);
    return reason.kind == Reason::Kind::Enough ? text + " or others" : text;
}

} // namespace franken
