// SPDX-License-Identifier: MIT
#include "population.h"

#include "franken/generator/choices.h"
#include "franken/generator/covering.h"

#include <algorithm>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>

namespace franken::test {
namespace {

template<typename T>
T valueOf(Result<T> result) {
    if (!result)
        throw std::logic_error(toString(result.error()));
    return *std::move(result);
}

class Collector {
public:
    void add(const std::vector<Permutation>& permutations) {
        for (const Permutation& permutation : permutations)
            if (const Permutation p = canonical(permutation); m_keys.insert(toKey(p)).second)
                m_all.push_back(p);
    }
    std::vector<Permutation> take() { return std::move(m_all); }

private:
    std::set<Key> m_keys;
    std::vector<Permutation> m_all;
};

} // namespace

std::vector<Permutation> randomPermutations(std::size_t count, unsigned seed) {
    std::mt19937_64 random(seed);
    std::vector<Permutation> result;
    while (result.size() < count) {
        Permutation p;
        for (const Choice& choice : choices())
            choice.set(p, static_cast<unsigned>(random() % choice.options.size()));
        // Else one in thirty only would be a lit surface.
        if (random() % 8 != 0)
            p.program = Program::Surface;
        if (random() % 8 != 0)
            p.view = View::Shaded;
        if (random() % 8 != 0)
            p.shading = Shading::Lit;
        if (canonicalise(p))
            result.push_back(p);
    }
    return result;
}

std::vector<Permutation> litProduct() {
    std::vector<Permutation> result{{}};
    for (const Choice& choice : choices()) {
        if (choice.name != "normal" && choice.name != "ambient" && choice.name != "suns" &&
            choice.name != "brdf" && choice.name != "output")
            continue;
        std::vector<Permutation> longer;
        for (Permutation permutation : result)
            for (unsigned value = 0; value < choice.options.size(); ++value) {
                choice.set(permutation, value);
                longer.push_back(permutation);
            }
        result = std::move(longer);
    }
    return result;
}

std::vector<Permutation> singleFlips(const Permutation& permutation) {
    std::vector<Permutation> result;
    for (const Choice& choice : choices())
        for (unsigned value = 0; value < choice.options.size(); ++value) {
            Permutation flipped = permutation;
            choice.set(flipped, value);
            if (flipped != permutation && canonicalise(flipped))
                result.push_back(flipped);
        }
    return result;
}

Permutation richSurface() {
    return named("basecolor.vertexcolor.metalrough.normal.occlusion.emissive.mask.double.occlusion-uv1."
                 "uv0-transform.uv1-transform+sh+sun2+punctual2+spots+aces+dither");
}

const std::vector<Permutation>& population() {
    static const std::vector<Permutation> all = [] {
        Collector collector;
        collector.add(coveringSet());
        collector.add(litProduct());
        collector.add(randomPermutations(2000, 2));
        collector.add(singleFlips({}));
        collector.add(singleFlips(richSurface()));
        return collector.take();
    }();
    return all;
}

Permutation canonical(const Permutation& permutation) {
    return valueOf(canonicalise(permutation)).permutation;
}

Permutation named(std::string_view name) { return canonical(valueOf(parseName(name))); }

std::string withoutComments(const std::string& glsl) {
    std::istringstream lines(glsl);
    std::string result;
    for (std::string line; std::getline(lines, line);) {
        line.erase(std::min(line.find("//"), line.size()));
        line.erase(line.find_last_not_of(' ') + 1);
        if (!line.empty())
            result += line + '\n';
    }
    return result;
}

} // namespace franken::test
