// SPDX-License-Identifier: MIT
#include "franken/generator/covering.h"

#include "franken/generator/choices.h"

#include <cstddef>
#include <optional>
#include <random>

namespace franken {
namespace {

constexpr std::size_t kSamples = 3000;

std::optional<Permutation> canonicalOrNone(const Permutation& permutation) {
    const auto canonical = canonicalise(permutation);
    return canonical ? std::optional(canonical->permutation) : std::nullopt;
}

using Accept = std::function<bool(const Permutation&)>;

// Any permutation without contradictions. Most are lit surfaces: elsewhere most choices mean nothing.
// (No distribution of <random> is used, as each library has its own.)
Permutation randomPermutation(std::mt19937_64& random) {
    while (true) {
        Permutation p;
        for (const Choice& choice : choices())
            choice.set(p, static_cast<unsigned>(random() % choice.options.size()));
        if (random() % 8 != 0)
            p.program = Program::Surface;
        if (random() % 4 != 0)
            p.view = View::Shaded;
        if (random() % 8 != 0)
            p.shading = Shading::Lit;
        if (const auto canonical = canonicalOrNone(p))
            return *canonical;
    }
}

/// Which triples there are, which permutation showed each, and which are covered.
class Triples {
public:
    Triples() {
        for (const Choice& choice : choices()) {
            m_firstOption.push_back(m_options);
            m_options += choice.options.size();
        }
        m_state.resize(m_options * m_options * m_options, State::Unknown);
    }

    /// Notes triples that were not seen before; returns how many of the permutation's are uncovered.
    std::size_t look(const Permutation& permutation) {
        std::size_t uncovered = 0;
        bool isWitness = false;
        forEach(permutation, [&](std::size_t triple) {
            if (m_state[triple] == State::Unknown) {
                m_state[triple] = State::Wanted;
                m_wanted.push_back({triple, m_witnesses.size()});
                isWitness = true;
            }
            uncovered += m_state[triple] == State::Wanted;
        });
        if (isWitness)
            m_witnesses.push_back(permutation);
        return uncovered;
    }

    void cover(const Permutation& permutation) {
        forEach(permutation, [&](std::size_t triple) { m_state[triple] = State::Covered; });
    }

    /// A permutation that shows a triple which is not covered.
    std::optional<Permutation> nextWitness() {
        while (m_next < m_wanted.size() && m_state[m_wanted[m_next].triple] == State::Covered)
            ++m_next;
        if (m_next == m_wanted.size())
            return std::nullopt;
        return m_witnesses[m_wanted[m_next].witness];
    }

private:
    enum class State : std::uint8_t { Unknown, Wanted, Covered };
    struct Wanted {
        std::size_t triple, witness;
    };

    template<typename Visit>
    void forEach(const Permutation& permutation, Visit visit) const {
        std::vector<std::size_t> options;
        for (std::size_t i = 0; i < choices().size(); ++i)
            options.push_back(m_firstOption[i] + choices()[i].get(permutation));
        for (std::size_t a = 0; a < options.size(); ++a)
            for (std::size_t b = a + 1; b < options.size(); ++b)
                for (std::size_t c = b + 1; c < options.size(); ++c)
                    visit((options[a] * m_options + options[b]) * m_options + options[c]);
    }

    std::size_t m_options = 0;
    std::vector<std::size_t> m_firstOption;
    std::vector<State> m_state;
    std::vector<Wanted> m_wanted;
    std::vector<Permutation> m_witnesses;
    std::size_t m_next = 0;
};

// Climbs, one choice at a time, to a neighbour that covers more.
Permutation improve(Permutation best, Triples& triples, const Accept& accept) {
    std::size_t most = triples.look(best);
    for (const Choice& choice : choices()) {
        const Permutation base = best;
        for (unsigned value = 0; value < choice.options.size(); ++value) {
            Permutation changed = base;
            choice.set(changed, value);
            const auto candidate = canonicalOrNone(changed);
            if (!candidate || *candidate == base || !accept(*candidate))
                continue;
            if (const std::size_t uncovered = triples.look(*candidate); uncovered > most) {
                most = uncovered;
                best = *candidate;
            }
        }
    }
    return best;
}

} // namespace

std::vector<Permutation> coveringSet() {
    return coveringSet([](const Permutation&) { return true; });
}

std::vector<Permutation> coveringSet(const Accept& accept) {
    std::mt19937_64 random(1);
    Triples triples;
    for (std::size_t sample = 0; sample < kSamples; ++sample)
        if (const Permutation permutation = randomPermutation(random); accept(permutation))
            triples.look(permutation);
    std::vector<Permutation> set;
    while (const auto witness = triples.nextWitness()) {
        set.push_back(improve(*witness, triples, accept));
        triples.cover(set.back());
    }
    return set;
}

} // namespace franken
