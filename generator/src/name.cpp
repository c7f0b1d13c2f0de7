// SPDX-License-Identifier: MIT
#include "franken/generator/choices.h"

#include <algorithm>
#include <numeric>
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

// Levenshtein's distance, one row at a time.
std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
        }
    }
    return row.back();
}

std::string_view nearestWord(std::string_view text) {
    text = text.substr(0, 64); // longer is no slip of a finger, and a file may hold megabytes without a space
    std::string_view best;
    std::size_t bestDistance = text.size() + 1000;
    for (const Choice& choice : choices())
        for (const Option& option : choice.options)
            if (const std::size_t distance = editDistance(text, option.word); distance < bestDistance) {
                best = option.word;
                bestDistance = distance;
            }
    return best;
}

// "basecolor+nromal" and, below the wrong word, a row of carets.
std::string pointAt(std::string_view name, std::size_t column, std::size_t length) {
    return "\n  " + std::string(name) + "\n  " + std::string(column, ' ') +
           std::string(std::max<std::size_t>(length, 1), '^');
}

Error unknownWord(std::string_view name, std::string_view word, std::size_t column) {
    return {"permutation.unknown-word", "column " + std::to_string(column + 1),
            "'" + std::string(word) + "' is no word of a permutation" + pointAt(name, column, word.size()),
            "did you mean '" + std::string(nearestWord(word)) + "'?"};
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
        name += choice.options[value].word;
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
