// SPDX-License-Identifier: MIT
#include "effect_rules.h"
#include "franken/generator/choices.h"
#include "franken/nearest.h"

#include <algorithm>
#include <optional>

namespace franken {
namespace {

struct Word {
    const Choice* choice;
    unsigned value;
};

std::optional<Word> findWord(std::string_view text) {
    for (const Choice& choice : choices())
        for (unsigned value = 0; value < choice.options.size(); ++value)
            if (choice.options[value].word == text)
                return Word{&choice, value};
    return std::nullopt;
}

std::vector<std::string_view> allWords() {
    std::vector<std::string_view> words;
    for (const Choice& choice : choices())
        for (const Option& option : choice.options)
            words.push_back(option.word);
    return words;
}

// "basecolor+nromal" and, below the wrong word, a row of carets.
std::string pointAt(std::string_view name, std::size_t column, std::size_t length) {
    return "\n  " + std::string(name) + "\n  " + std::string(column, ' ') +
           std::string(std::max<std::size_t>(length, 1), '^');
}

Error unknownWord(std::string_view name, std::string_view word, std::size_t column) {
    const std::string nearest(nearestWord(word, allWords()));
    return {"permutation.unknown-word", "column " + std::to_string(column + 1),
            "'" + std::string(word) + "' is no word of a permutation" + pointAt(name, column, word.size()),
            nearest.empty() ? "'frankenshader list --words' has them all"
                            : "did you mean '" + nearest + "'?"};
}

Error answeredTwice(std::string_view name, std::string_view word, std::size_t column,
                    std::string_view choice) {
    return {"permutation.twice", "column " + std::to_string(column + 1),
            "'" + std::string(word) + "' chooses " + std::string(choice) + " a second time" +
                pointAt(name, column, word.size()),
            "keep one of the two words"};
}

} // namespace

std::string toName(const Permutation& permutation, const SnippetSet& snippets) {
    std::string name;
    bool lastWasMaterial = false;
    for (const Choice& choice : choices()) {
        const unsigned value = choice.get(permutation);
        if (value == 0)
            continue;
        if (!name.empty())
            name += choice.material && lastWasMaterial ? '.' : '+';
        name += value < choice.options.size() ? std::string(choice.options[value].word)
                                              : std::string(choice.name) + "=" + std::to_string(value);
        lastWasMaterial = choice.material;
    }
    if (permutation.effect.slot != 0) {
        const Effect* const effect = snippets.effectOf(permutation.effect);
        name += name.empty() ? "" : "+";
        name += effect != nullptr ? effect->word() : "effect#" + std::to_string(permutation.effect.slot);
    }
    return name.empty() ? std::string(choices().front().options.front().word) : name;
}

namespace {

// The hash may be left out.
Result<EffectChoice> parseEffect(std::string_view word, const SnippetSet& snippets) {
    const std::size_t at = word.find('@');
    const std::string_view name = word.substr(0, at);
    const Result<EffectChoice> choice = snippets.chooseEffect(name);
    if (!choice)
        return choice;
    const std::string& whole = snippets.effectOf(*choice)->word();
    if (at != word.npos && word != whole)
        return Error{"effect.changed", std::string(word),
                     "the text of the effect '" + std::string(name) + "' is another one now",
                     "it is '" + whole + "' in this run; name it so"};
    return choice;
}

bool namesEffect(std::string_view word, const SnippetSet& snippets) {
    return isEffectWord(word) || snippets.chooseEffect(word).has_value();
}

} // namespace

Result<Permutation> parseName(std::string_view name, const SnippetSet& snippets) {
    Permutation permutation;
    std::vector<const Choice*> answered;
    for (std::size_t begin = 0; begin <= name.size();) {
        const std::size_t end = std::min(name.find_first_of(".+", begin), name.size());
        const std::string_view text = name.substr(begin, end - begin);
        if (const std::optional<Word> word = findWord(text)) {
            if (std::find(answered.begin(), answered.end(), word->choice) != answered.end())
                return answeredTwice(name, text, begin, word->choice->name);
            answered.push_back(word->choice);
            word->choice->set(permutation, word->value);
        } else if (namesEffect(text, snippets)) {
            if (permutation.effect.slot != 0)
                return answeredTwice(name, text, begin, "the effect");
            const Result<EffectChoice> effect = parseEffect(text, snippets);
            if (!effect)
                return effect.error();
            permutation.effect = *effect;
        } else {
            return unknownWord(name, text, begin);
        }
        begin = end + 1;
    }
    return permutation;
}

} // namespace franken
