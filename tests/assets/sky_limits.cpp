// SPDX-License-Identifier: MIT
// Prints how close to brute force the reflection of a sky could come at N.V 0.2 with other directions, levels
// and shares of irradiance than the shipped ones, as in generator/README.md:
//   sky_limits ORIENTATIONS SKY.hdr...
// The three are free at each roughness and found on a grid; the errors are those of the skies' worse one.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <vector>

#include <glm/common.hpp>

#include "franken/generator/pack.h"
#include "sky_sampling.h"
#include "sky_shader.h"

namespace {

using namespace franken;

constexpr float kNDotV = 0.2f;
constexpr std::array kBends = {0.0f, 0.05f, 0.1f, 0.15f, 0.2f, 0.25f, 0.3f, 0.4f,
                               0.5f, 0.6f,  0.8f, 1.1f,  1.6f, 2.5f,  4.0f, 8.0f};
constexpr int kLevels = 17, kShares = 10;

struct Sky {
    Environment light;
    ReflectionAtlas atlas;
};

using Errors = std::array<double, 2>; ///< Of the worse metal, and of the black dielectric.

/// Those of one bend at all levels and shares.
using Choices = std::vector<Errors>;

struct Point {
    glm::vec3 n, v, irradiance;
    std::array<glm::vec3, 3> reflectance, truth;
};

const std::array<std::size_t, 3> kMaterials = {0, 1, 3}; ///< Of test::skyMaterials(): both metals, black.

std::vector<Point> points(const Sky& sky, const glm::vec4& look, float roughness, int count) {
    std::vector<Point> all;
    for (const glm::vec3& normal : test::directions(count)) {
        const test::Frame frame(normal, static_cast<float>(all.size()));
        const test::Reflected light = test::reflected(sky.light, frame, kNDotV, roughness);
        Point point{normal,
                    frame.toWorld({std::sqrt(1 - kNDotV * kNDotV), 0, kNDotV}),
                    test::skyLight(sky.atlas, normal),
                    {},
                    {}};
        for (std::size_t m = 0; m < kMaterials.size(); ++m) {
            const glm::vec3 f0 = test::skyMaterials()[kMaterials[m]].f0();
            point.reflectance[m] = f0 * look.r + look.g;
            point.truth[m] = f0 * light.byF0 + light.besides;
        }
        all.push_back(point);
    }
    return all;
}

/// Raises `worst`, an entry for each level and share, to what that bend makes of the points.
void addErrors(Choices& worst, const Sky& sky, const std::vector<Point>& all, float roughness, float bend) {
    for (int i = 0; i < kLevels * kShares; ++i) {
        const float level = 2 * std::log2(roughness) + 8 - 3.5f + 0.25f * static_cast<float>(i / kShares);
        const float share = 0.1f * static_cast<float>(i % kShares);
        std::array<double, 3> sums{};
        for (const Point& point : all) {
            const glm::vec3 toSky = point.n * (2 * kNDotV + bend) - point.v;
            const glm::vec3 light =
                glm::mix(test::skyThroughLobe(sky.atlas, toSky, glm::clamp(level, 0.0f, 7.999f)),
                         point.irradiance, share);
            for (std::size_t m = 0; m < sums.size(); ++m)
                sums[m] += test::meanDifference(light * point.reflectance[m], point.truth[m]) /
                           static_cast<double>(all.size());
        }
        Errors& errors = worst[static_cast<std::size_t>(i)];
        errors = {std::max({errors[0], sums[0], sums[1]}), std::max(errors[1], sums[2])};
    }
}

void print(const char* what, const std::vector<Errors>& row) {
    std::printf("| %s |", what);
    for (const std::size_t side : {0u, 1u}) {
        for (const Errors& errors : row)
            std::printf(" %.1f", errors[side]);
        std::printf(" |");
    }
    std::printf("\n");
}

/// The choice with the least rank.
Errors best(const std::vector<Choices>& byBend, const std::function<double(const Errors&)>& rank) {
    Errors found = byBend[0][0];
    for (const Choices& choices : byBend)
        for (const Errors& errors : choices)
            if (rank(errors) < rank(found))
                found = errors;
    return found;
}

/// One level and share, but a bend for metals and one for dielectrics.
Errors bestOfTwoBends(const std::vector<Choices>& byBend) {
    Errors found = {1e9, 1e9};
    for (std::size_t i = 0; i < byBend[0].size(); ++i) {
        Errors errors = byBend[0][i];
        for (const Choices& choices : byBend)
            errors = {std::min(errors[0], choices[i][0]), std::min(errors[1], choices[i][1])};
        if (std::max(errors[0], errors[1]) < std::max(found[0], found[1]))
            found = errors;
    }
    return found;
}

} // namespace

int main(int count, char** words) {
    const int orientations = count > 2 ? std::atoi(words[1]) : 0;
    if (orientations < 1) {
        std::fprintf(stderr, "sky_limits ORIENTATIONS SKY.hdr...\n");
        return 2;
    }
    std::vector<Sky> skies;
    for (int i = 2; i < count; ++i) {
        auto light = test::loadExposed(words[i]);
        if (!light) {
            std::fprintf(stderr, "%s: %s\n", words[i], light.error().what.c_str());
            return 1;
        }
        skies.push_back({*light, filterReflection(*light)});
    }
    const Image lookup = reflectionLookup();
    std::vector<Errors> metals, black, all, two;
    for (const float roughness : {0.2f, 0.4f, 0.6f, 0.8f, 1.0f}) {
        std::vector<Choices> byBend(kBends.size(), Choices(kLevels * kShares));
        for (const Sky& sky : skies) {
            const auto seen = points(sky, test::sample(lookup, {kNDotV, roughness}), roughness, orientations);
            for (std::size_t b = 0; b < kBends.size(); ++b)
                addErrors(byBend[b], sky, seen, roughness, kBends[b]);
        }
        metals.push_back(best(byBend, [](const Errors& e) { return e[0]; }));
        black.push_back(best(byBend, [](const Errors& e) { return e[1]; }));
        all.push_back(best(byBend, [](const Errors& e) { return std::max(e[0], e[1]); }));
        two.push_back(bestOfTwoBends(byBend));
    }
    std::printf("| fitted to | the worse metal | black dielectric |\n|---|---|---|\n");
    print("metals", metals);
    print("the black dielectric", black);
    print("all", all);
    print("all, with a bend for metals and one for dielectrics", two);
    return 0;
}
