// SPDX-License-Identifier: MIT
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

Error answeredTwice(std::string_view name, std::string_view word, std::size_t column, const Choice& choice) {
    return {"permutation.twice", "column " + std::to_string(column + 1),
            "'" + std::string(word) + "' chooses " + std::string(choice.name) + " a second time" +
                pointAt(name, column, word.size()),
            "keep one of the two words"};
}

} // namespace

std::string toName(const Permutation& permutation) {
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
    return name.empty() ? std::string(choices().front().options.front().word) : name;
}

Result<Permutation> parseName(std::string_view name) {
    Permutation permutation;
    std::vector<const Choice*> answered;
    for (std::size_t begin = 0; begin <= name.size();) {
        const std::size_t end = std::min(name.find_first_of(".+", begin), name.size());
        const std::string_view text = name.substr(begin, end - begin);
        const std::optional<Word> word = findWord(text);
        if (!word)
            return unknownWord(name, text, begin);
        if (std::find(answered.begin(), answered.end(), word->choice) != answered.end())
            return answeredTwice(name, text, begin, *word->choice);
        answered.push_back(word->choice);
        word->choice->set(permutation, word->value);
        begin = end + 1;
    }
    return permutation;
}

} // namespace franken
