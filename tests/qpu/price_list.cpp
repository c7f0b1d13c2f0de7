// SPDX-License-Identifier: MIT
#include "price_list.h"

#include "measure.h"
#include "population.h"

#include <array>

namespace franken::test {
namespace {

constexpr std::array kGpuNames = {"vc4", "v3d42", "v3d71"};

/// A feature is the difference of two programs.
struct Item {
    const char* feature;
    const char* with;
    const char* without;
};

#define BASE "basecolor.normal+ambient+sun1+decode-fast+srgb-fast"
#define LIGHTS "+ambient+sun1+decode-fast+srgb-fast"
constexpr Item kItems[] = {
    {"base colour texture", BASE, "normal" LIGHTS},
    {"vertex colour", "basecolor.vertexcolor.normal" LIGHTS, BASE},
    {"normal map", BASE, "basecolor" LIGHTS},
    {"metallic-roughness texture", "basecolor.metalrough.normal" LIGHTS, BASE},
    {"metalness and roughness, two textures", "basecolor.metalrough-separate.normal" LIGHTS, BASE},
    {"occlusion texture", "basecolor.normal.occlusion" LIGHTS, BASE},
    {"occlusion in the metallic-roughness texture", "basecolor.metalrough.normal.occlusion-packed" LIGHTS,
     "basecolor.metalrough.normal" LIGHTS},
    {"emission by factor", "basecolor.normal.emissive-factor" LIGHTS, BASE},
    {"emissive texture", "basecolor.normal.emissive" LIGHTS, BASE},
    {"alpha mask", "basecolor.normal.mask" LIGHTS, BASE},
    {"alpha blending", "basecolor.normal.blend" LIGHTS, BASE},
    {"double-sided", "basecolor.normal.double" LIGHTS, BASE},
    {"texture transform", "basecolor.normal.uv0-transform" LIGHTS, BASE},
    {"second texture coordinates", "basecolor.normal.normal-uv1" LIGHTS, BASE},
    {"skin, 1 joint a vertex", "basecolor.normal.skin1" LIGHTS, BASE},
    {"skin, 2 joints a vertex", "basecolor.normal.skin2" LIGHTS, BASE},
    {"skin, 3 joints a vertex", "basecolor.normal.skin3" LIGHTS, BASE},
    {"skin, 4 joints a vertex", "basecolor.normal.skin4" LIGHTS, BASE},
    {"ambient colour", BASE, "basecolor.normal+sun1+decode-fast+srgb-fast"},
    {"sky (SH) instead of the ambient colour", "basecolor.normal+sh+sun1+decode-fast+srgb-fast", BASE},
    {"reflection of the sky as well", "basecolor.normal+sh+reflection+sun1+decode-fast+srgb-fast",
     "basecolor.normal+sh+sun1+decode-fast+srgb-fast"},
    {"1st sun", BASE, "basecolor.normal+ambient+decode-fast+srgb-fast"},
    {"2nd sun", "basecolor.normal+ambient+sun2+decode-fast+srgb-fast", BASE},
    {"3rd and 4th sun, together", "basecolor.normal+ambient+sun4+decode-fast+srgb-fast",
     "basecolor.normal+ambient+sun2+decode-fast+srgb-fast"},
    {"light vectors per vertex, 1 sun", BASE "+vertexlight", BASE},
    {"light vectors per vertex, 4 suns", "basecolor.normal+ambient+sun4+vertexlight+decode-fast+srgb-fast",
     "basecolor.normal+ambient+sun4+decode-fast+srgb-fast"},
    {"1st punctual light", BASE "+punctual1", BASE},
    {"2nd punctual light", BASE "+punctual2", BASE "+punctual1"},
    {"the light is a spot", BASE "+punctual1+spots", BASE "+punctual1"},
    {"BRDF of the seed instead of glTF's", BASE "+seed", BASE},
    {"BRDF fast instead of glTF's", BASE "+fast", BASE},
    {"BRDF schlick instead of glTF's", BASE "+schlick", BASE},
    {"energy, roughness by factor", BASE "+energy", BASE},
    {"energy, roughness by texture", "basecolor.metalrough.normal" LIGHTS "+energy",
     "basecolor.metalrough.normal" LIGHTS},
    {"energy, with the reflection of the sky",
     "basecolor.normal+sh+reflection+sun1+energy+decode-fast+srgb-fast",
     "basecolor.normal+sh+reflection+sun1+decode-fast+srgb-fast"},
    {"exact sRGB decode instead of the cubic", "basecolor.normal+ambient+sun1+srgb-fast", BASE},
    {"no decode instead of the cubic", "basecolor.normal+ambient+sun1+decode-none+srgb-fast", BASE},
    {"exact sRGB encode instead of the fast one", "basecolor.normal+ambient+sun1+decode-fast", BASE},
    {"encode by 1/2.2 instead of fast sRGB", "basecolor.normal+ambient+sun1+decode-fast+pow22", BASE},
    {"no encode instead of fast sRGB", "basecolor.normal+ambient+sun1+decode-fast+linear", BASE},
    {"tone map: Reinhard", BASE "+reinhard", BASE},
    {"tone map: ACES", BASE "+aces", BASE},
    {"tone map: Khronos neutral", BASE "+neutral", BASE},
    {"dither", BASE "+dither", BASE},
};

// "155, 2 threads"
std::string total(const cli::ShaderCost& shader) {
    return std::to_string(shader.instructions) + ", " + std::to_string(shader.threads) + " threads";
}

std::string signedNumber(int number) {
    return number > 0 ? "+" + std::to_string(number) : number < 0 ? "−" + std::to_string(-number) : "0";
}

std::string difference(const cli::Cost& with, const cli::Cost& without) {
    if (!with.measured() || !without.measured())
        return with.measured() ? without.error : with.error;
    std::string text = signedNumber(with.fragment.instructions - without.fragment.instructions);
    if (with.fragment.threads != without.fragment.threads)
        text += ", " + std::to_string(with.fragment.threads) +
                (with.fragment.threads == 1 ? " thread" : " threads");
    const int vertex = with.vertexInstructions() - without.vertexInstructions();
    return vertex == 0 ? text : text + " (" + signedNumber(vertex) + ")";
}

} // namespace

std::string priceList() {
    std::vector<Permutation> permutations{named(BASE)};
    for (const Item& item : kItems) {
        permutations.push_back(named(item.with));
        permutations.push_back(named(item.without));
    }
    std::array<std::vector<cli::Priced>, kGpuNames.size()> prices;
    for (std::size_t gpu = 0; gpu < prices.size(); ++gpu)
        prices[gpu] = priceOn(kGpuNames[gpu], permutations);
    std::string list =
        "| fragment instructions (vertex and coordinate shader, where they change) | vc4: Pi 0–3 | v3d "
        "4.2: Pi 4 | v3d 7.1: Pi 5 |\n|---|---|---|---|\n| `" BASE "` |";
    for (const auto& priced : prices)
        list += " " + total(priced[0].cost.fragment) + " (" +
                std::to_string(priced[0].cost.vertexInstructions()) + ") |";
    for (std::size_t i = 0; i < std::size(kItems); ++i) {
        list += std::string("\n| ") + kItems[i].feature + " |";
        for (const auto& priced : prices)
            list += " " + difference(priced[2 * i + 1].cost, priced[2 * i + 2].cost) + " |";
    }
    return list + "\n";
}

std::string withPriceList(const std::string& text, const std::string& list) {
    const std::string begin = "<!-- prices -->\n", end = "<!-- /prices -->";
    const std::size_t from = text.find(begin), to = text.find(end);
    if (from == std::string::npos || to == std::string::npos || to < from)
        return text;
    return text.substr(0, from + begin.size()) + list + text.substr(to);
}

} // namespace franken::test
