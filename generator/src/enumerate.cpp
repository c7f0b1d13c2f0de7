// SPDX-License-Identifier: MIT
#include "enumerate.h"

#include "franken/generator/choices.h"
#include "recipe.h"

#include <algorithm>
#include <random>

namespace franken {
namespace {

constexpr int kProbes = 256;

// The choices that decide which others have an effect at all.
constexpr std::string_view kGates[] = {"program", "view", "shading", "precision"};

using Allowed = std::vector<unsigned>; ///< By choice: a bit for each value.
using Values = std::vector<unsigned>;

Values valuesOf(unsigned allowed) {
    Values values;
    for (unsigned value = 0; allowed >> value; ++value)
        if (allowed >> value & 1U)
            values.push_back(value);
    return values;
}

// mt19937's numbers are the same everywhere; those of the standard's distributions are not.
Permutation randomPermutation(const std::vector<Values>& values, std::mt19937& random) {
    Permutation permutation;
    for (std::size_t i = 0; i < values.size(); ++i)
        choices()[i].set(permutation, values[i][random() % values[i].size()]);
    return permutation;
}

struct Word {
    std::size_t choice;
    unsigned value;
};

bool matters(Word word, Permutation permutation) {
    choices()[word.choice].set(permutation, 0);
    const std::vector<Step> without = plan(permutation);
    choices()[word.choice].set(permutation, word.value);
    return plan(permutation) != without;
}

// Takes away the words that no probe shows to matter; they would be dropped. A choice that needs one of
// them is left without a value.
Allowed withoutDeadWords(Allowed allowed) {
    std::vector<Values> values;
    std::vector<Word> unproven;
    for (std::size_t i = 0; i < allowed.size(); ++i) {
        values.push_back(valuesOf(allowed[i]));
        for (const unsigned value : valuesOf(allowed[i] & ~1U))
            unproven.push_back({i, value});
    }
    std::mt19937 random;
    for (int probe = 0; probe < kProbes && !unproven.empty(); ++probe) {
        const Permutation permutation = randomPermutation(values, random);
        std::erase_if(unproven, [&](Word word) { return matters(word, permutation); });
    }
    for (const Word dead : unproven)
        allowed[dead.choice] &= ~(1U << dead.value);
    return allowed;
}

// Parts in which a gate has one value each, and only words that matter are left; empty parts are left out.
void split(const Allowed& allowed, std::span<const std::string_view> gates, std::vector<Allowed>& parts) {
    if (gates.empty()) {
        const Allowed living = withoutDeadWords(allowed);
        if (std::count(living.begin(), living.end(), 0U) == 0)
            parts.push_back(living);
        return;
    }
    const auto gate = std::find_if(choices().begin(), choices().end(),
                                   [&](const Choice& choice) { return choice.name == gates.front(); });
    const auto index = static_cast<std::size_t>(gate - choices().begin());
    for (const unsigned value : valuesOf(allowed[index])) {
        Allowed part = allowed;
        part[index] = 1U << value;
        split(part, gates.subspan(1), parts);
    }
}

// The permutations of one part, by their number of words.
class Part {
public:
    Part(Allowed allowed, const std::function<bool(const Permutation&)>& offer)
        : m_allowed(std::move(allowed)),
          m_offer(offer),
          m_least(m_allowed.size() + 1),
          m_most(m_allowed.size() + 1) {
        for (std::size_t i = m_allowed.size(); i-- > 0;) {
            m_least[i] = m_least[i + 1] + (m_allowed[i] & 1U ? 0 : 1);
            m_most[i] = m_most[i + 1] + (m_allowed[i] > 1 ? 1 : 0);
        }
    }

    // Offers all that have so many words; false once that was enough.
    bool offerAll(std::size_t words) { return choose(0, words); }

private:
    bool choose(std::size_t index, std::size_t words) {
        if (words < m_least[index] || words > m_most[index])
            return true;
        if (index == m_allowed.size())
            return m_offer(m_permutation);
        const Choice& choice = choices()[index];
        for (const unsigned value : valuesOf(words > 0 ? m_allowed[index] & ~1U : 0)) {
            choice.set(m_permutation, value);
            if (!choose(index + 1, words - 1))
                return false;
        }
        choice.set(m_permutation, 0);
        return !(m_allowed[index] & 1U) || choose(index + 1, words);
    }

    Allowed m_allowed;
    const std::function<bool(const Permutation&)>& m_offer;
    std::vector<std::size_t> m_least, m_most; ///< Words that the choices from an index on need, and can take.
    Permutation m_permutation;
};

} // namespace

void enumerateCanonical(const std::vector<unsigned>& allowed,
                        const std::function<bool(const Permutation&)>& visit,
                        const std::function<void(std::uint64_t)>& tried) {
    std::uint64_t candidates = 0;
    const std::function<bool(const Permutation&)> offer = [&](const Permutation& permutation) {
        if (++candidates % 1024 == 0 && tried)
            tried(candidates);
        const auto canonical = canonicalise(permutation);
        return !canonical || !canonical->dropped.empty() || visit(permutation);
    };
    std::vector<Allowed> allowedParts;
    split(allowed, kGates, allowedParts);
    std::vector<Part> parts;
    parts.reserve(allowedParts.size());
    for (Allowed& part : allowedParts)
        parts.emplace_back(std::move(part), offer);
    for (std::size_t words = 0; words <= choices().size(); ++words)
        for (Part& part : parts)
            if (!part.offerAll(words))
                return;
}

} // namespace franken
