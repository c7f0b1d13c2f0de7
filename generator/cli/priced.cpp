// SPDX-License-Identifier: MIT
#include "priced.h"

#include <map>

namespace franken::cli {
namespace {

// The same program with its light vectors the other way, if there is one.
std::optional<Permutation> otherWay(const Permutation& permutation) {
    Permutation other = permutation;
    const bool perPixel = permutation.lightVectors == LightVectors::PerPixel;
    other.lightVectors = perPixel ? LightVectors::PerVertex : LightVectors::PerPixel;
    const auto canonical = canonicalise(other);
    if (!canonical || canonical->permutation == permutation)
        return std::nullopt;
    return canonical->permutation;
}

class Measured {
public:
    void add(const Permutation& permutation) {
        if (m_places.emplace(toKey(permutation), m_permutations.size()).second)
            m_permutations.push_back(permutation);
    }

    Result<void> measure(const QpuCompiler& compiler, const Gpu& gpu, const SnippetSet& snippets) {
        return compiler.measure(gpu, m_permutations, snippets).transform([this](std::vector<Cost> costs) {
            m_costs = std::move(costs);
        });
    }

    const Cost& operator[](const Permutation& permutation) const {
        return m_costs[m_places.at(toKey(permutation))];
    }

private:
    std::vector<Permutation> m_permutations;
    std::map<Key, std::size_t> m_places;
    std::vector<Cost> m_costs;
};

std::optional<double> breakEven(const Permutation& measured, const Measured& costs) {
    const auto other = otherWay(measured);
    if (!other || !costs[measured].measured() || !costs[*other].measured())
        return std::nullopt;
    const bool perPixel = measured.lightVectors == LightVectors::PerPixel;
    return breakEvenPixels(costs[perPixel ? *other : measured], costs[perPixel ? measured : *other]);
}

} // namespace

Result<std::vector<Priced>> price(const QpuCompiler& compiler, const Gpu& gpu,
                                  std::span<const Permutation> asked, const SnippetSet& snippets) {
    Measured costs;
    for (const Permutation& permutation : asked) {
        const Permutation measured = forGpu(permutation, gpu);
        costs.add(measured);
        if (const auto other = otherWay(measured))
            costs.add(*other);
    }
    if (auto done = costs.measure(compiler, gpu, snippets); !done)
        return done.error();
    std::vector<Priced> priced;
    for (const Permutation& permutation : asked) {
        const Permutation measured = forGpu(permutation, gpu);
        priced.push_back({permutation, measured, costs[measured], breakEven(measured, costs)});
    }
    return priced;
}

} // namespace franken::cli
