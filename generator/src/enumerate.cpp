// SPDX-License-Identifier: MIT
#include "enumerate.h"

#include "franken/generator/choices.h"
#include "recipe.h"

#include <random>

namespace franken {
namespace {

constexpr int kProbes = 2048;

using Allowed = std::vector<unsigned>;

std::vector<unsigned> valuesOf(unsigned allowed) {
    std::vector<unsigned> values;
    for (unsigned value = 0; allowed >> value; ++value)
        if (allowed >> value & 1U)
            values.push_back(value);
    return values;
}

// mt19937's numbers are the same everywhere; those of the standard's distributions are not.
Permutation randomPermutation(const std::vector<std::vector<unsigned>>& values, std::mt19937& random) {
    Permutation permutation;
    for (std::size_t i = 0; i < values.size(); ++i)
        choices()[i].set(permutation, values[i][random() % values[i].size()]);
    return permutation;
}

bool matters(const Choice& choice, const std::vector<unsigned>& values, Permutation permutation) {
    const std::vector<Step> steps = plan(permutation);
    for (const unsigned value : values) {
        choice.set(permutation, value);
        if (plan(permutation) != steps)
            return true;
    }
    return false;
}

// Leaves only the default to each choice that may have it and that no probe shows to matter.
Allowed withoutDeadChoices(Allowed allowed) {
    std::vector<std::vector<unsigned>> values;
    std::vector<std::size_t> unproven;
    for (std::size_t i = 0; i < allowed.size(); ++i) {
        values.push_back(valuesOf(allowed[i]));
        if (allowed[i] & 1U && values[i].size() > 1)
            unproven.push_back(i);
    }
    std::mt19937 random;
    for (int probe = 0; probe < kProbes && !unproven.empty(); ++probe) {
        const Permutation permutation = randomPermutation(values, random);
        std::erase_if(unproven, [&](std::size_t i) { return matters(choices()[i], values[i], permutation); });
    }
    for (const std::size_t dead : unproven)
        allowed[dead] = 1;
    return allowed;
}

class Enumeration {
public:
    Enumeration(Allowed allowed, const std::function<bool(const Permutation&)>& visit,
                const std::function<void(std::uint64_t)>& tried)
        : m_allowed(std::move(allowed)),
          m_visit(visit),
          m_tried(tried),
          m_least(m_allowed.size() + 1),
          m_most(m_allowed.size() + 1) {
        for (std::size_t i = m_allowed.size(); i-- > 0;) {
            m_least[i] = m_least[i + 1] + (m_allowed[i] & 1U ? 0 : 1);
            m_most[i] = m_most[i + 1] + (m_allowed[i] > 1 ? 1 : 0);
        }
    }

    void run() {
        for (std::size_t words = m_least[0]; words <= m_most[0]; ++words)
            if (!choose(0, words))
                return;
    }

private:
    // Spreads that many words over the choices from `index` on; false once the visitor has had enough.
    bool choose(std::size_t index, std::size_t words) {
        if (words < m_least[index] || words > m_most[index])
            return true;
        if (index == m_allowed.size())
            return offer();
        const Choice& choice = choices()[index];
        for (const unsigned value : valuesOf(words > 0 ? m_allowed[index] & ~1U : 0)) {
            choice.set(m_permutation, value);
            if (!choose(index + 1, words - 1))
                return false;
        }
        choice.set(m_permutation, 0);
        return !(m_allowed[index] & 1U) || choose(index + 1, words);
    }

    bool offer() {
        if (++m_candidates % 1024 == 0 && m_tried)
            m_tried(m_candidates);
        const auto canonical = canonicalise(m_permutation);
        return !canonical || !canonical->dropped.empty() || m_visit(m_permutation);
    }

    Allowed m_allowed;
    const std::function<bool(const Permutation&)>& m_visit;
    const std::function<void(std::uint64_t)>& m_tried;
    std::vector<std::size_t> m_least, m_most; ///< Words that the choices from an index on need, and can take.
    Permutation m_permutation;
    std::uint64_t m_candidates = 0;
};

} // namespace

void enumerateCanonical(std::vector<unsigned> allowed, const std::function<bool(const Permutation&)>& visit,
                        const std::function<void(std::uint64_t)>& tried) {
    Enumeration(withoutDeadChoices(std::move(allowed)), visit, tried).run();
}

} // namespace franken
