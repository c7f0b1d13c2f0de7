// SPDX-License-Identifier: MIT
#include "option_programs.h"

#include <algorithm>
#include <optional>
#include <string>

namespace franken::gallery {
namespace {

/// Programs in which options show; of these, the first that will do is taken. The price list's is tried
/// first.
struct Base {
    std::string_view name;
    std::string_view choice = {}; ///< For that choice alone.
};
constexpr Base kBases[] = {
    {"basecolor.metalrough.normal.occlusion+ambient+sun1+decode-fast+srgb-fast", "view"},
    {"basecolor.normal+ambient+sun1+decode-fast+srgb-fast"},
    {"basecolor.metalrough.normal+ambient+sun1+decode-fast+srgb-fast"},
    {"basecolor.metalrough.normal.occlusion.emissive+sh+sun1+decode-fast+srgb-fast"},
    {"basecolor.normal.normal-uv1+ambient+sun1+decode-fast+srgb-fast"},
    {"basecolor.normal.double+ambient+sun1+decode-fast+srgb-fast"},
    {"basecolor.normal.skin2+ambient+sun1+decode-fast+srgb-fast"},
    {"basecolor.normal+ambient+sun1+punctual1+decode-fast+srgb-fast"},
};

/// The choice's options in that program; nothing where one is refused, or has the same text as another. An
/// option may stand for other words: the view of the base colour is an unlit surface.
std::optional<std::vector<Permutation>> programsIn(const Permutation& base, const Choice& choice) {
    std::vector<Permutation> programs;
    for (unsigned option = 0; option < choice.options.size(); ++option) {
        Permutation wanted = base;
        choice.set(wanted, option);
        const Result<Canonical> canonical = canonicalise(wanted);
        if (!canonical ||
            std::find(programs.begin(), programs.end(), canonical->permutation) != programs.end())
            return {};
        programs.push_back(canonical->permutation);
    }
    return programs;
}

} // namespace

Result<std::vector<ChoiceProgram>> choicePrograms() {
    std::vector<ChoiceProgram> all;
    for (const Choice& choice : choices()) {
        std::optional<std::vector<Permutation>> programs;
        for (const auto& [name, only] : kBases) {
            if (!only.empty() && only != choice.name)
                continue;
            const Result<Permutation> base = parseName(name);
            if (!base)
                return base.error();
            if (programs = programsIn(*base, choice); programs)
                break;
        }
        if (!programs)
            return Error{"gallery.base", std::string(choice.name),
                         "in none of the gallery's programs does each of its options change the text",
                         "add a program to kBases (toolchains/docs/gallery/option_programs.cpp)"};
        all.push_back({&choice, *std::move(programs)});
    }
    return all;
}

} // namespace franken::gallery
