// SPDX-License-Identifier: MIT
#include "franken/generator/space.h"

#include "enumerate.h"
#include "franken/generator/choices.h"

#include <bit>

namespace franken {

Space::Space() {
    for (const Choice& choice : choices())
        m_allowed.push_back((1U << choice.options.size()) - 1);
}

Result<void> Space::require(std::string_view word) { return narrow(word, true); }
Result<void> Space::forbid(std::string_view word) { return narrow(word, false); }

Result<void> Space::narrow(std::string_view word, bool present) {
    if (auto parsed = parseName(word); !parsed)
        return parsed.error();
    for (std::size_t i = 0; i < choices().size(); ++i)
        for (unsigned value = 0; value < choices()[i].options.size(); ++value)
            if (choices()[i].options[value].word == word) {
                const unsigned bit = 1U << value;
                m_allowed[i] &= present ? bit : ~bit;
                if (m_allowed[i] == 0)
                    return Error{"space.empty", std::string(word),
                                 "no value is left for " + std::string(choices()[i].name),
                                 "remove one of the words for this choice"};
                return {};
            }
    return Error{"space.word", std::string(word), "more than one word", "give one word at a time"};
}

bool Space::contains(const Permutation& permutation) const {
    for (std::size_t i = 0; i < choices().size(); ++i)
        if (!(m_allowed[i] >> choices()[i].get(permutation) & 1U))
            return false;
    return true;
}

std::uint64_t Space::product() const {
    std::uint64_t product = 1;
    for (const unsigned allowed : m_allowed)
        product *= static_cast<std::uint64_t>(std::popcount(allowed));
    return product;
}

void Space::forEachCanonical(const std::function<bool(const Permutation&)>& visit,
                             const std::function<void(std::uint64_t)>& tried) const {
    enumerateCanonical(m_allowed, visit, tried);
}

} // namespace franken
